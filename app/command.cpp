#include "app/command.h"

#include <cstdio>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include "app/command_line.h"
#include "app/common.h"
#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/base/printable.h"
#include "hodt/io/atomic_write.h"

namespace hodt::app {

namespace {

int complain(std::string message) {
  for (char& c : message) {
    if (c == '\n') c = ' ';
  }
  // Not fmt::print: that throws where standard error cannot be written.
  std::fputs(fmt::format("hodt: {}\n", printable(message)).c_str(), stderr);
  return kError;
}

/// CLI11 would only say that a subcommand is required.
void check_command_name(const CLI::App& app, int argc, const char* const* argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::string known;
  for (const CLI::App* command : app.get_subcommands({})) {
    if (command->get_name() == argv[1]) return;
    known += (known.empty() ? "" : ", ") + command->get_name();
  }
  throw ParameterError(fmt::format("there is no command '{}'; known are {}", argv[1], known));
}

/// "-k" of "-k,--order".
std::string short_name(const CLI::Option& option) {
  const std::vector<std::string>& letters = option.get_snames();
  return letters.empty() ? option.get_name() : "-" + letters.front();
}

/// An empty value would pass for an option that was not given.
void check_values(const CLI::App& app) {
  for (const CLI::App* command : app.get_subcommands())
    for (const CLI::Option* option : command->get_options())
      for (const std::string& value : option->results())
        if (value.empty())
          throw ParameterError(
              fmt::format("{} must be given a value, not ''", short_name(*option)));
}

/// Parses the command line; help and version are actions too.
void parse(CLI::App& app, Action& action, int argc, const char* const* argv) {
  check_command_name(app, argc, argv);
  try {
    app.parse(argc, argv);
    check_values(app);
  } catch (const CLI::CallForHelp&) {
    action = [help = app.help()] { return print(help), kOk; };
  } catch (const CLI::CallForVersion& version) {
    action = [text = fmt::format("{}\n", version.what())] { return print(text), kOk; };
  }
}

}  // namespace

int run(int argc, const char* const* argv) {
  Action action;
  std::unique_ptr<CLI::App> app;
  try {
    app = command_line(action);
    parse(*app, action, argc, argv);
    return action();
  } catch (const CLI::ParseError& error) {
    const auto chosen = app->get_subcommands();
    return complain(fmt::format("{} (see 'hodt {}--help')", error.what(),
                                chosen.empty() ? "" : chosen[0]->get_name() + " "));
  } catch (const BrokenPipeError&) {
    return kOk;
  } catch (const std::bad_alloc&) {
    return complain("not enough memory");
  } catch (const std::exception& error) {
    return complain(error.what());
  }
}

}  // namespace hodt::app
