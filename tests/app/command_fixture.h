// Running the hodt command as users do: exit code, output, messages, files.
#pragma once

#include <cstdlib>
#include <string>
#include <string_view>

#include "../io/temporary_directory.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>

namespace hodt::test {

using Json = nlohmann::json;

struct Outcome {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// A directory to run the command in, and another for what it prints.
class CommandTest : public testing::Test {
 protected:
  /// Runs a shell command in the directory, HODT standing for the command.
  Outcome shell(std::string line) const {
    const std::string streams = (streams_ / "").string();
    for (std::size_t at; (at = line.find("HODT")) != std::string::npos;) {
      line.replace(at, 4, HODT_COMMAND);
    }
    line = "cd '" + directory_.path().string() + "' && { " + line + "\n} </dev/null >'" + streams +
           "out' 2>'" + streams + "err'";
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(streams_ / "out"),
            content_of(streams_ / "err")};
  }
  Outcome run(const std::string& arguments) const { return shell("HODT " + arguments); }

  /// Exit code 2, one line on standard error that contains `message`, nothing else anywhere.
  void expect_refused(const std::string& arguments, const std::string& message) const {
    const std::size_t entries = directory_.entries();
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_TRUE(outcome.err.starts_with("hodt: ")) << outcome.err;
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
    EXPECT_NE(outcome.err.find(message), std::string::npos) << arguments << ": " << outcome.err;
    EXPECT_EQ(directory_.entries(), entries) << arguments;
  }

  void put(std::string_view name, std::string_view content) const {
    directory_.file(name, content);
  }
  Json json(std::string_view name) const { return Json::parse(content_of(directory_ / name)); }

  TemporaryDirectory directory_;
  TemporaryDirectory streams_;
};

}  // namespace hodt::test
