// The hodt command as users see it: exit codes, messages, files.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "command_fixture.h"
#include <gtest/gtest.h>

namespace hodt {
namespace {

using test::content_of;
using test::Json;
using test::Outcome;
using test::TemporaryDirectory;

class Command : public test::CommandTest {};

const char* const kPoints =
    "x,y,z\n0,0,4\n0,1,0\n1,0,2\n1,1.1,3\n2,0,5\n2,1,1\n0,0,9\n0.4,0.5,2\n1.6,0.4,2.5\n";

TEST_F(Command, TriangulatesAndChecks) {
  put("points.csv", kPoints);
  for (const char* mesh : {"mesh.ply", "mesh.obj"}) {
    const std::string name = mesh;
    Outcome outcome = run("triangulate points.csv -o " + name + " -k 1 --json report.json");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_NE(outcome.out.find("triangles"), std::string::npos);
    const Json report = json("report.json");
    EXPECT_EQ(report["points"], 9);
    EXPECT_EQ(report["duplicates"], 1);
    EXPECT_EQ(report["k"], 1);
    EXPECT_EQ(report["objective"], "min-local-minima");
    EXPECT_LE(report["order"], 1);
    for (const char* key : {"delaunay", "result", "bound"}) {
      EXPECT_TRUE(report["value"][key].is_number()) << key;
    }
    EXPECT_TRUE(report["value"]["optimal"].is_boolean());
    for (const char* key : {"local_minima", "local_maxima", "pits"}) {
      for (const char* stage : {"delaunay", "result"}) {
        EXPECT_TRUE(report[key][stage]["interior"].is_number_unsigned()) << key;
        EXPECT_TRUE(report[key][stage]["boundary"].is_number_unsigned()) << key;
      }
    }
    for (const char* key : {"read", "delaunay", "optimize", "write"}) {
      EXPECT_TRUE(report["seconds"][key].is_number()) << key;
    }

    outcome = run("check " + name + " -k 1 --strict --json check.json");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
    const Json check = json("check.json");
    EXPECT_TRUE(check["embedded"]);
    EXPECT_TRUE(check["covers_hull"]);
    EXPECT_TRUE(check["k_od"]);
    EXPECT_EQ(check["unused_vertices"], 0);
    EXPECT_EQ(check["points"], 8);
    EXPECT_EQ(check["triangles"], report["triangles"]);
    EXPECT_EQ(check["order"], report["order"]);
    EXPECT_EQ(check["local_minima"], report["local_minima"]["result"]);
  }
}

TEST_F(Command, OptimisesWithoutHeights) {
  put("flat.csv", "0,0\n4,0\n0,4\n5,5\n2,1\n");
  const Outcome outcome =
      run("triangulate flat.csv -o mesh.ply --objective min-max-angle --json report.json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(json("report.json")["value"].is_object());
  EXPECT_TRUE(json("report.json")["local_minima"].is_null());
}

TEST_F(Command, WritesOnlyJsonToStandardOutput) {
  put("points.csv", kPoints);
  const Outcome outcome = run("triangulate points.csv -o mesh.ply --objective none --json -");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(Json::parse(outcome.out)["value"].is_null());
  EXPECT_TRUE(Json::parse(run("info points.csv --json -").out).is_object());
  EXPECT_TRUE(Json::parse(run("check mesh.ply --json -").out).is_object());
}

TEST_F(Command, ReadsStandardInput) {
  put("points.csv", kPoints);
  Outcome outcome = shell("HODT triangulate - -o mesh.obj <points.csv");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  outcome = shell("HODT check - <mesh.obj");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

TEST_F(Command, RefusesBadInput) {
  struct Case {
    std::string content;
    const char* message;
  };
  const Case cases[] = {
      {"", "bad.csv is empty"},
      {"x,y,z\n", "bad.csv holds no data row"},
      {"1,2,3\n4,5,6\n", "three"},
      {"1,2,3\n4,5,6\n1,2,7\n4,5,8\n", "three"},
      {"1,2,3\n4,5,6\n1,2,7\n4,5,8\n", "bad.csv: 2 distinct"},
      {"0,0,1\n1,1,1\n2,2,5\n3,3,0\n", "line"},
      {"x,y,z\n1,2,3\n4,nan,6\n7,8,8\n", "bad.csv, line 3"},
      {"1,2,3\n4,5,inf\n7,8,8\n", "bad.csv, line 2"},
      {"1,2,3\n4,5\n7,8,8\n", "bad.csv, line 2"},
      {"1,2,3\n4,five,6\n7,8,8\n", "'five'"},
      {std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16), "binary"},
      {"\x1f\x8b\x08", "cut short"},
      {"0,0\n1,0\n0,1\n", "height"},
  };
  for (const Case& c : cases) {
    put("bad.csv", c.content);
    expect_refused("triangulate bad.csv -o out.ply --json out.json", c.message);
  }
}

TEST_F(Command, RefusesBadUsage) {
  put("points.csv", kPoints);
  put("kept.ply", "an existing output");
  const std::string start = "triangulate points.csv -o ";
  expect_refused("triangulate none.csv -o out.ply", "none.csv");
  expect_refused("triangulate . -o out.ply", "directory");
  expect_refused(start + "out.step", ".obj, .ply");
  expect_refused(start + "out", ".obj, .ply");
  expect_refused(start + "none/out.ply", "none");
  expect_refused(start + "out.ply --json none/out.json", "none");
  expect_refused(start + "out.ply --json out.ply", "out.ply");
  expect_refused(start + "out.ply --json $PWD/out.ply", "out.ply");
  expect_refused(start + "out.ply --json points.csv", "is the input");
  expect_refused(start + "out.obj.gz", "'.gz'");
  expect_refused(start + "out.ply --objective beauty", "beauty");
  expect_refused(start + "out.ply --method magic", "magic");
  for (const char* k : {"-1", "1.5", "x", "''", "1e3", "-0"}) {
    expect_refused(start + "kept.ply -k " + k, "-k");
  }
  for (const char* seconds : {"-1", "nan", "soon"}) {
    expect_refused(start + "kept.ply --time-limit " + seconds, "--time-limit");
  }
  expect_refused(start + "kept.ply --threads 0", "--threads");
  expect_refused(start + "kept.ply --threads -2", "--threads");
  expect_refused("triangulate points.csv", "--output");
  expect_refused(start + "kept.ply --bogus", "--bogus");
  expect_refused(start + "kept.ply surplus", "surplus");
  expect_refused("", "subcommand");
  expect_refused("frobnicate", "'frobnicate'");
  expect_refused("check points.csv", ".csv");
  expect_refused("check none.ply", "none.ply");
  expect_refused("sample atlantis", "atlantis");
  expect_refused("sample valley -n 0", "-n");
  expect_refused("sample valley -n -5", "-n");
  expect_refused("sample valley -o out.doc", ".doc");
  EXPECT_EQ(content_of(directory_ / "kept.ply"), "an existing output");
}

TEST_F(Command, AcceptsAHugeOrder) {
  put("points.csv", kPoints);
  const Outcome outcome =
      run("triangulate points.csv -o out.ply --objective none -k 99999999999999999999");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

TEST_F(Command, LeavesNothingHalfWrittenOnAFullDisk) {
  ASSERT_EQ(run("sample valley -n 5000 -o points.csv").exit_code, 0);
  put("kept.ply", "an existing output");
  const std::size_t entries = directory_.entries();
  for (const char* output : {"kept.ply", "new.ply", "new.obj"}) {
    // The largest file may have eight blocks of 512 or 1024 bytes.
    const Outcome outcome =
        shell("ulimit -f 8; HODT triangulate points.csv -k 0 -o " + std::string(output));
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("cannot write"), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(directory_.entries(), entries);
  EXPECT_EQ(content_of(directory_ / "kept.ply"), "an existing output");
}

TEST_F(Command, ReportsAFullStandardOutput) {
  put("points.csv", kPoints);
  for (const char* arguments : {"info points.csv", "info points.csv --json -", "sample valley",
                                "--help", "--version", "sample"}) {
    const Outcome outcome = shell("HODT " + std::string(arguments) + " >/dev/full");
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_NE(outcome.err.find("No space"), std::string::npos) << outcome.err;
  }
}

TEST_F(Command, AClosedPipeIsNoError) {
  const Outcome outcome = shell("{ HODT sample valley -n 100000; echo $? >code; } | head -n 1");
  EXPECT_EQ(outcome.out, "x,y,z\n");
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(content_of(directory_ / "code"), "0\n");
}

TEST_F(Command, AClosedStandardOutputSpoilsNoFile) {
  put("points.csv", kPoints);
  put("kept.obj", "an existing output");
  EXPECT_EQ(shell("HODT triangulate points.csv -o kept.obj >&-").exit_code, 2);
  EXPECT_EQ(content_of(directory_ / "kept.obj"), "an existing output");
}

TEST_F(Command, ExplainsItself) {
  for (const char* arguments :
       {"--help", "triangulate --help", "check --help", "info --help", "sample --help"}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << arguments;
    EXPECT_NE(outcome.out.find("hodt"), std::string::npos) << arguments;
    EXPECT_EQ(outcome.err, "");
  }
  EXPECT_NE(run("triangulate --help").out.find("Examples:"), std::string::npos);
  EXPECT_TRUE(run("--version").out.starts_with("hodt "));
}

TEST_F(Command, SaysNo) {
  const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.1 1\n";
  put("overlap.obj", square + "f 1 2 3\nf 1 2 4\n");
  Outcome outcome = run("check overlap.obj --json no.json");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.out.find("embedded         no: "), std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(json("no.json")["embedded"], false);

  put("square.obj", square + "f 1 2 3\nf 1 3 4\n");
  EXPECT_EQ(run("check square.obj").exit_code, 0);
  EXPECT_EQ(run("check square.obj -k 1").exit_code, 0);
  EXPECT_EQ(run("check square.obj -k 0").exit_code, 1);
  EXPECT_EQ(run("check square.obj --strict").exit_code, 1);

  // One triangle of two: embedded, but not the hull.
  put("half.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\n");
  outcome = run("check half.obj --json no.json");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(json("no.json")["covers_hull"], false);
  EXPECT_EQ(json("no.json")["unused_vertices"], 1);
  EXPECT_EQ(run("check half.obj --strict").exit_code, 1);
}

TEST_F(Command, InfoDescribesPoints) {
  put("points.csv", kPoints);
  ASSERT_EQ(run("info points.csv --json info.json").exit_code, 0);
  const Json info = json("info.json");
  EXPECT_EQ(info["points"], 9);
  EXPECT_EQ(info["distinct"], 8);
  EXPECT_EQ(info["duplicates"], 1);
  EXPECT_EQ(info["x"], Json::array({0, 2}));
  EXPECT_EQ(info["z"], Json::array({0, 9}));
  EXPECT_EQ(info["heights"], true);
  EXPECT_EQ(info["collinear"], false);
  put("line.csv", "0,0\n1,1\n2,2\n");
  EXPECT_NE(run("info line.csv").out.find("on a line"), std::string::npos);
  put("two.csv", "0,0\n1,1\n0,0\n");
  EXPECT_NE(run("info two.csv").out.find("fewer than three"), std::string::npos);
}

TEST_F(Command, SamplesAreRepeatable) {
  EXPECT_NE(run("sample").out.find("valley"), std::string::npos);
  const std::string first = run("sample valley -n 500 --seed 7").out;
  EXPECT_EQ(first, run("sample valley -n 500 --seed 7 --threads 1").out);
  EXPECT_NE(first, run("sample valley -n 500 --seed 8").out);
  ASSERT_EQ(run("sample valley -n 500 --seed 7 -o a.csv.gz").exit_code, 0);
  EXPECT_EQ(shell("gunzip <a.csv.gz").out, first);
}

TEST_F(Command, TheSameBytesOnAnyThreadCount) {
  ASSERT_EQ(run("sample valley -n 20000 -o points.csv").exit_code, 0);
  ASSERT_EQ(run("triangulate points.csv -o one.ply --threads 1").exit_code, 0);
  ASSERT_EQ(run("triangulate points.csv -o two.ply --threads 2").exit_code, 0);
  EXPECT_TRUE(content_of(directory_ / "one.ply") == content_of(directory_ / "two.ply"));
}

}  // namespace
}  // namespace hodt
