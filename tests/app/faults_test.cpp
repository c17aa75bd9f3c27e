// The hodt command where something goes wrong around it: signals, full disks, odd names, links.
#include <csignal>
#include <filesystem>
#include <string>
#include <vector>

#include "command_fixture.h"
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

namespace hodt {
namespace {

using test::content_of;
using test::Json;
using test::Outcome;

class Faults : public test::CommandTest {
 protected:
  void SetUp() override {
    put("points.csv",
        "x,y,z\n0,0,4\n0,1,0\n1,0,2\n1,1.1,3\n2,0,5\n2,1,1\n0,0,9\n0.4,0.5,2\n1.6,0.4,2.5\n");
  }
};

// ---- Signals ----

class Signals : public Faults {
 protected:
  /// The command waits: its mesh is written, but nobody reads the pipe that the JSON goes to.
  void start(int ignored = 0) {
    ASSERT_EQ(::mkfifo((directory_ / "pipe").c_str(), 0600), 0);
    files_ = directory_.entries();
    process_ = ::fork();
    if (process_ == 0) {
      if (ignored) std::signal(ignored, SIG_IGN);
      if (::chdir(directory_.path().c_str()) == 0)
        ::execl(HODT_COMMAND, "hodt", "triangulate", "points.csv", "-o", "out.ply", "--json",
                "pipe", nullptr);
      ::_exit(127);
    }
    constexpr int most = 6000;
    for (int i = 0; i < most && directory_.entries() == files_; ++i) ::usleep(10000);
    ASSERT_EQ(directory_.entries(), files_ + 1) << "no temporary file to clean up";
  }

  void expect_end_by(int signal) {
    ::kill(process_, signal);
    int status = 0;
    ASSERT_EQ(::waitpid(process_, &status, 0), process_);
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(WTERMSIG(status), signal);
    EXPECT_EQ(directory_.entries(), files_);
    std::filesystem::remove(directory_ / "pipe");
  }

  pid_t process_ = 0;
  std::size_t files_ = 0;
};

TEST_F(Signals, LeaveNoTemporaryFile) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    start();
    expect_end_by(signal);
  }
}

TEST_F(Signals, ThatAreIgnoredStayIgnored) {
  start(SIGHUP);  // as nohup does
  ::kill(process_, SIGHUP);
  ::usleep(100000);
  EXPECT_EQ(directory_.entries(), files_ + 1);
  expect_end_by(SIGTERM);
}

// ---- All or nothing ----

TEST_F(Faults, NothingStaysIfTheJsonCannotBeWritten) {
  for (const std::string json : {"/dev/full", "/proc/none.json"}) {
    expect_refused("triangulate points.csv -o new.ply --json " + json, json);
    expect_refused("compare points.csv -o new.html --json " + json, json);
    expect_refused("info points.csv --json " + json, json);
  }
  put("kept.ply", "an existing output");
  expect_refused("triangulate points.csv -o kept.ply --json /dev/full", "/dev/full");
  EXPECT_EQ(content_of(directory_ / "kept.ply"), "an existing output");
}

TEST_F(Faults, NothingStaysIfTheReportCannotBePrinted) {
  put("kept.ply", "an existing output");
  ASSERT_EQ(run("triangulate points.csv -o mesh.ply").exit_code, 0);
  const std::size_t entries = directory_.entries();
  for (const std::string command :
       {"triangulate points.csv -o new.ply", "triangulate points.csv -o kept.ply --json new.json",
        "triangulate points.csv -o new.ply --json -", "edges points.csv -o new.csv",
        "triangles points.csv -o new.csv", "voronoi points.csv -m 2 -o new.geojson",
        "compare points.csv -o new.html --json new.json", "check mesh.ply --json new.json",
        "info points.csv --json new.json", "edges points.csv -o -",
        "voronoi points.csv -m 2 -o /dev/stdout"}) {
    for (const std::string target : {" >/dev/full", " >&-"}) {
      const Outcome outcome = shell("HODT " + command + target);
      EXPECT_EQ(outcome.exit_code, 2) << command << target;
      EXPECT_NE(outcome.err.find("hodt: cannot write standard output"), std::string::npos)
          << command << target << ": " << outcome.err;
      EXPECT_EQ(directory_.entries(), entries) << command << target;
    }
  }
  EXPECT_EQ(content_of(directory_ / "kept.ply"), "an existing output");
}

TEST_F(Faults, AReaderWhoHasSeenEnoughSpoilsNothing) {
  const Outcome outcome =
      shell("{ HODT triangulate points.csv -o out.ply --json -; echo $? >code; } | true");
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(content_of(directory_ / "code"), "0\n");
  EXPECT_EQ(run("check out.ply").exit_code, 0);
}

// ---- Links, pipes, devices ----

TEST_F(Faults, WritesThroughLinks) {
  std::filesystem::create_directory(directory_ / "there");
  std::filesystem::create_symlink("there/mesh.ply", directory_ / "link.ply");
  for (int i = 0; i < 2; ++i) {  // a new file, then an old one
    EXPECT_EQ(run("triangulate points.csv -o link.ply").exit_code, 0);
    EXPECT_TRUE(std::filesystem::is_symlink(directory_ / "link.ply"));
    EXPECT_EQ(run("check there/mesh.ply").exit_code, 0);
  }
}

TEST_F(Faults, RefusesALoopOfLinks) {
  std::filesystem::create_symlink("b.ply", directory_ / "a.ply");
  std::filesystem::create_symlink("a.ply", directory_ / "b.ply");
  expect_refused("triangulate points.csv -o a.ply", "Too many levels of symbolic links");
  expect_refused("triangulate points.csv -o new.ply --json a.ply", "Too many levels");
  EXPECT_TRUE(std::filesystem::is_symlink(directory_ / "a.ply"));
}

TEST_F(Faults, RefusesOneOutputUnderTwoNames) {
  std::filesystem::create_symlink("mesh.ply", directory_ / "link.ply");  // where nothing is yet
  expect_refused("triangulate points.csv -o link.ply --json mesh.ply", "is named for the output");
  expect_refused("triangulate points.csv -o mesh.ply --json ./link.ply", "is named for the output");
  expect_refused("compare points.csv -o a.html --json ./a.html", "is named for the output");
  std::filesystem::create_symlink("points.csv", directory_ / "input");
  expect_refused("triangulate points.csv -o mesh.ply --json input", "is the input");
  expect_refused("info input --json points.csv", "is the input");
}

TEST_F(Faults, WritesToPipes) {
  ASSERT_EQ(run("triangulate points.csv -o good.ply").exit_code, 0);
  const Outcome outcome = shell(
      "mkfifo pipe.ply; cat pipe.ply >got.ply & HODT triangulate points.csv -o pipe.ply; wait");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(content_of(directory_ / "got.ply"), content_of(directory_ / "good.ply"));
  EXPECT_TRUE(std::filesystem::is_fifo(directory_ / "pipe.ply"));
}

TEST_F(Faults, StandardOutputHasManyNames) {
  const std::string edges = run("edges points.csv -o -").out;
  EXPECT_TRUE(edges.starts_with("u,v,order\n"));
  for (const std::string name : {"/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"}) {
    EXPECT_EQ(run("edges points.csv -o " + name).out, edges) << name;
    EXPECT_TRUE(Json::accept(run("info points.csv --json " + name).out)) << name;
    EXPECT_TRUE(Json::accept(run("triangulate points.csv -o a.ply --json " + name).out)) << name;
  }
  // Neither has an extension that tells a format.
  for (const char* name : {"-", "/dev/stdout"})
    expect_refused("triangulate points.csv -o " + std::string(name), "known are .obj, .ply");
}

// ---- Odd names ----

TEST_F(Faults, RefusedOutputsAreNoInputs) {
  put("mesh.obj", "v 0 0 0\nv 1 0 1\nv 0 1 2\nf 1 2 3\n");
  put("line.csv", "x,y,z\n0,0,1\n1,0,2\n0,1,3\n");
  for (const std::string output : {"-", "/dev/stdout"})
    for (const std::string command :
         {"triangulate line.csv -o ", "contours mesh.obj --interval 1 -o ",
          "raster mesh.obj --resolution 1 -o ", "triangulate line.csv -o a.ply --picture ",
          "triangulate line.csv -o a.ply --pits "}) {
      const Outcome outcome = run(command + output);
      EXPECT_EQ(outcome.exit_code, 2) << command;
      EXPECT_NE(outcome.err.find("to standard output"), std::string::npos) << outcome.err;
      EXPECT_EQ(outcome.err.find("standard input"), std::string::npos) << outcome.err;
    }
}

TEST_F(Faults, NamesReachTerminalsAndPagesPrintable) {
  const std::string odd = "a\x1b[31m\xff\nb<&>\u00fc";
  const std::string shown = "a\\x1b[31m\\xff\\x0ab<&>\u00fc";
  const std::string quoted = "'" + odd + "'";
  std::filesystem::copy(directory_ / "points.csv", directory_ / odd);

  Outcome outcome = run("triangulate points.csv -o " + quoted + ".ply");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("written       " + shown + ".ply\n"), std::string::npos)
      << outcome.out;
  outcome = run("edges points.csv -o " + quoted + ".csv");
  EXPECT_NE(outcome.out.find(shown + ".csv\n"), std::string::npos) << outcome.out;

  outcome = run("info 'no " + odd + "'");
  EXPECT_EQ(outcome.exit_code, 2);
  // In an error a new line is a blank, as errors have one line.
  EXPECT_NE(outcome.err.find("no a\\x1b[31m\\xff b<&>\u00fc"), std::string::npos) << outcome.err;
  for (const std::string& arguments :
       {quoted, "info points.csv '--" + odd + "'", "check --json a " + quoted,
        "triangulate points.csv -o a.ply -k " + quoted,
        "voronoi points.csv -m 1 -o a --box " + quoted,
        "triangulate points.csv -o a.ply --objective " + quoted}) {
    outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_EQ(outcome.err.find_first_of("\x1b\xff"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("a\\x1b[31m\\xff b<&>"), std::string::npos) << outcome.err;
  }

  // A warning: x counts.
  put(odd + ".csv", "a,b,c\n1,0,1\n2,0,2\n3,1,3\n4,5,2\n");
  outcome = run("triangulate " + quoted + ".csv -o a.ply --columns x=1,y=2,z=3");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("hodt: warning: " + shown + ".csv: "), std::string::npos)
      << outcome.err;

  ASSERT_EQ(run("compare " + quoted + " --orders 0-1 -o page.html --json page.json").exit_code, 0);
  EXPECT_TRUE(Json::accept(content_of(directory_ / "page.json")));
  const std::string page = content_of(directory_ / "page.html");
  EXPECT_EQ(page.find_first_of("\x1b\xff"), std::string::npos);
  EXPECT_NE(page.find("a\\x1b[31m\\xff\\x0ab&lt;&amp;&gt;\u00fc"), std::string::npos);
}

TEST_F(Faults, EverySubcommandNamesTheFileThatItCannotUse) {
  put("line.csv", "0,0,1\n1,1,2\n2,2,3\n");
  for (const char* arguments :
       {"triangulate line.csv -o a.ply", "edges line.csv -o a.csv", "triangles line.csv -o a.csv",
        "voronoi line.csv -m 1 -o a.geojson", "compare line.csv -o a.html"})
    expect_refused(arguments, "hodt: line.csv: ");
  expect_refused("voronoi points.csv -m 8 -o a.geojson", "hodt: points.csv: -m must be less");
}

// ---- Numbers ----

TEST_F(Faults, ReportsAnOrderAsItWasGiven) {
  for (const std::string k : {"0", "4294967294", "4294967295", "4294967296", "99999999999",
                              "18446744073709551615", "18446744073709551616"}) {
    Outcome outcome =
        run("triangulate points.csv -o out.ply --objective none --json a.json -k " + k);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("(allowed: " + k + ")"), std::string::npos) << outcome.out;
    EXPECT_EQ(json("a.json")["k"].get<double>(), std::stod(k));
    if (k.size() < 20) {
      EXPECT_EQ(json("a.json")["k"].dump(), k);
    }

    outcome = run("check out.ply --json a.json -k " + k);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("order " + k + " or less"), std::string::npos) << outcome.out;
    EXPECT_EQ(json("a.json")["k"].get<double>(), std::stod(k));

    outcome = run("edges points.csv -o a.csv -k " + k);
    EXPECT_NE(outcome.out.find("useful of order " + k + " or less"), std::string::npos);
  }
  EXPECT_NE(run("triangulate points.csv -o out.ply -k 0007").out.find("(allowed: 7)"),
            std::string::npos);
  EXPECT_NE(run("triangulate points.csv -o out.ply -k 000").out.find("(allowed: 0)"),
            std::string::npos);
  expect_refused("triangulate points.csv -o new.ply -k 1" + std::string(400, '0'), "-k must be");
}

TEST_F(Faults, RefusesNumbersThatAreNone) {
  ASSERT_EQ(run("triangulate points.csv -o mesh.ply").exit_code, 0);
  const std::vector<std::string> wholes = {"triangulate points.csv -o a.ply -k",
                                           "triangulate points.csv -o a.ply --threads",
                                           "edges points.csv -o a.csv -k",
                                           "edges points.csv -o a.csv --threads",
                                           "triangles points.csv -o a.csv -k",
                                           "triangles points.csv -o a.csv --threads",
                                           "voronoi points.csv -o a.geojson -m",
                                           "voronoi points.csv -m 1 -o a.geojson --threads",
                                           "check mesh.ply -k",
                                           "check mesh.ply --threads",
                                           "info points.csv --threads",
                                           "compare points.csv --threads",
                                           "compare points.csv --orders",
                                           "sample valley -o a.csv -n",
                                           "sample valley -o a.csv --seed",
                                           "sample valley -n 9 -o a.csv --threads"};
  for (const std::string& start : wholes) {
    const std::string option = start.substr(start.rfind(' ') + 1);
    for (const char* bad : {"-1", "1.5", "nan", "inf", "''", "+5", "0x10", "1e3", "' 5'", "5x"})
      expect_refused(start + " " + bad, option);
  }
  const std::vector<std::string> numbers = {"triangulate points.csv -o a.ply --time-limit",
                                            "triangulate points.csv -o a.ply --min-pit-depth",
                                            "compare points.csv --time-limit"};
  for (const std::string& start : numbers) {
    const std::string option = start.substr(start.rfind(' ') + 1);
    for (const char* bad : {"-1", "nan", "inf", "-inf", "''", "+5", "0x10", "1e999", "' 5'", "5s"})
      expect_refused(start + " " + bad, option);
    EXPECT_EQ(run(start + " 1e3").exit_code, 0) << start;
  }
  for (const char* bad : {"''", "0,0,1", "0,0,1,nan", "0,0,1,0x10", "0,0,1,+1", "1,1,0,0",
                          "0,0,1,1e999", "0,0,1,1,1", "0,0,1,1,"})
    expect_refused("voronoi points.csv -m 1 -o a.geojson --box " + std::string(bad), "--box");
  for (const char* empty :
       {"triangulate '' -o a.ply", "triangulate points.csv -o ''", "info points.csv --json ''",
        "check mesh.ply --json ''", "triangulate points.csv -o a.ply --keep ''", "sample ''"})
    expect_refused(empty, "must be given a value");
}

TEST_F(Faults, RefusesNumbersOutOfRangeAsTheyWereGiven) {
  const auto refused = [&](const std::string& arguments) {
    const std::string number = arguments.substr(arguments.rfind(' ') + 1);
    expect_refused(arguments, "'" + number + "'");
  };
  for (const std::string large : {"4294967296", "18446744073709551616", "99999999999999999999"}) {
    refused("sample valley -o a.csv -n " + large);
    refused("voronoi points.csv -o a.geojson -m " + large);
    refused("compare points.csv --orders " + large);
    refused("triangulate points.csv -o a.ply --threads " + large);
  }
  refused("sample valley -o a.csv -n 0");
  refused("sample valley -o a.csv --seed 18446744073709551616");
  refused("voronoi points.csv -o a.geojson -m 0");
  refused("info points.csv --threads 0");
  refused("info points.csv --threads 4097");
  expect_refused("compare points.csv --orders 0-99999999999", "'99999999999'");
}

}  // namespace
}  // namespace hodt
