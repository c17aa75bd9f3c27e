// hodt edges and hodt triangles as users see them.
#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "command_fixture.h"
#include "families.h"
#include "oracle.h"
#include <gtest/gtest.h>

namespace hodt {
namespace {

using test::content_of;

/// The words with spaces between them.
std::string words(std::initializer_list<std::string_view> list) {
  std::string line;
  for (const std::string_view word : list) line.append(word).push_back(' ');
  return line;
}

class ListCommand : public test::CommandTest {
 protected:
  /// Runs the command in the directory; returns its exit code.
  int run(const std::string& arguments, const std::string& input = "/dev/null",
          const std::string& before = "") {
    const test::Outcome outcome = shell(before + " HODT " + arguments + " <'" + input + "'");
    out_ = outcome.out;
    err_ = outcome.err;
    return outcome.exit_code;
  }

  /// What the command writes to a file.
  std::string listed(const std::string& arguments) {
    EXPECT_EQ(run(arguments + " -o list.csv"), 0) << arguments << ": " << err_;
    EXPECT_EQ(err_, "") << arguments;
    return content_of(directory_ / "list.csv");
  }

  /// Refused, and "kept.csv" stays as it is.
  void expect_refused(const std::string& arguments, const std::string& message) {
    put("kept.csv", "an existing output");
    CommandTest::expect_refused(arguments, message);
    EXPECT_EQ(content_of(directory_ / "kept.csv"), "an existing output") << arguments;
  }

  std::string out_, err_;
};

// ---- What is expected, by the oracle ----

// Rows 2 and 6 are duplicates of rows 0 and 3.
const char* const kPoints =
    "x,y,z\n0,0,1\n4,0,1\n0,0,2\n4,4,1\n0,4,1\n1,1.5,0\n4,4,1\n2,3,0\n3,1,5\n2,0,5\n";
const oracle::Points kDistinct{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1.5}, {2, 3}, {3, 1}, {2, 0}};
const std::vector<int> kRows{0, 1, 3, 4, 5, 7, 8, 9};

std::string line_of(const std::vector<int>& numbers) {
  std::string line;
  for (const int number : numbers) line.append(std::to_string(number)).push_back(',');
  line.back() = '\n';
  return line;
}

bool is_delaunay(const oracle::Instance& instance, int u, int v) {
  const auto triangles = instance.delaunay();
  return std::any_of(triangles.begin(), triangles.end(), [&](const oracle::Triangle& t) {
    return std::ranges::count(t, u) + std::ranges::count(t, v) == 2;
  });
}

std::optional<int> useful_order(const oracle::Instance& instance, int u, int v, int k) {
  const auto order = instance.useful_order_by_lemma(u, v);
  return order && *order <= k ? order : std::nullopt;
}

bool is_fixed(const oracle::Instance& instance, int u, int v, int k) {
  if (!useful_order(instance, u, v, k)) return false;
  for (int a = 0; a < instance.size(); ++a)
    for (int b = 0; b < a; ++b)
      if (useful_order(instance, a, b, k) && instance.segments_cross(u, v, a, b)) return false;
  return true;
}

std::optional<int> order_of(const oracle::Instance& instance, const std::string& edge_class, int u,
                            int v, int k) {
  if (edge_class == "useful") return useful_order(instance, u, v, k);
  if (edge_class == "kod") {
    const auto order = instance.edge_order(u, v);
    return order && *order <= k ? order : std::nullopt;
  }
  const bool listed =
      edge_class == "fixed" ? is_fixed(instance, u, v, k) : is_delaunay(instance, u, v);
  return listed ? std::optional(0) : std::nullopt;
}

/// The whole file. `rows` ascend, so that sorted points are sorted rows.
std::string expected_edges(const oracle::Instance& instance, const std::vector<int>& rows,
                           const std::string& edge_class, int k) {
  std::string text = "u,v,order\n";
  for (int u = 0; u < instance.size(); ++u)
    for (int v = u + 1; v < instance.size(); ++v)
      if (const auto order = order_of(instance, edge_class, u, v, k))
        text += line_of({rows[u], rows[v], *order});
  return text;
}

std::optional<int> order_of(const oracle::Instance& instance, const std::string& triangle_class,
                            int a, int b, int c, int k) {
  if (instance.orient(a, b, c) == 0) return std::nullopt;
  int order = instance.triangle_order(a, b, c);
  if (triangle_class == "valid") {
    if (!instance.is_triangle_empty(a, b, c)) return std::nullopt;
    for (const auto& [u, v] : {std::pair{a, b}, {b, c}, {a, c}}) {
      const auto useful = useful_order(instance, u, v, k);
      if (!useful) return std::nullopt;
      order = std::max(order, *useful);
    }
  }
  return order <= k ? std::optional(order) : std::nullopt;
}

std::string expected_triangles(const oracle::Instance& instance, const std::vector<int>& rows,
                               const std::string& triangle_class, int k) {
  std::string text = "a,b,c,order\n";
  for (int a = 0; a < instance.size(); ++a)
    for (int b = a + 1; b < instance.size(); ++b)
      for (int c = b + 1; c < instance.size(); ++c)
        if (const auto order = order_of(instance, triangle_class, a, b, c, k))
          text += line_of({rows[a], rows[b], rows[c], *order});
  return text;
}

// ---- Lists ----

TEST_F(ListCommand, WritesTheEdgesOfEachClassByRows) {
  directory_.file("points.csv", kPoints);
  const oracle::Instance instance(kDistinct);
  for (const std::string edge_class : {"useful", "kod", "fixed", "delaunay"})
    for (const int k : {0, 1, 2, 3, 4, 6})
      EXPECT_EQ(listed("edges points.csv --class " + edge_class + " -k " + std::to_string(k)),
                expected_edges(instance, kRows, edge_class, k))
          << edge_class << ' ' << k;
}

TEST_F(ListCommand, WritesTheTrianglesOfEachClassByRows) {
  directory_.file("points.csv", kPoints);
  const oracle::Instance instance(kDistinct);
  for (const std::string triangle_class : {"valid", "kod"})
    for (const int k : {0, 1, 2, 3, 4, 6})
      EXPECT_EQ(
          listed("triangles points.csv --class " + triangle_class + " -k " + std::to_string(k)),
          expected_triangles(instance, kRows, triangle_class, k))
          << triangle_class << ' ' << k;
}

/// A raster, where half of all questions are ties; no header, no heights.
TEST_F(ListCommand, BreaksTiesByTheRule) {
  const families::Points points = families::lattice(4, 3);
  std::string text;
  std::vector<int> rows;
  for (const auto& [x, y] : points) {
    rows.push_back(static_cast<int>(rows.size()));
    text += std::to_string(int(x)) + ' ' + std::to_string(int(y)) + '\n';
  }
  directory_.file("points.xyz", text);
  const oracle::Instance instance(points);
  for (const std::string edge_class : {"useful", "kod", "fixed"})
    EXPECT_EQ(listed("edges points.xyz -k 3 --class " + edge_class),
              expected_edges(instance, rows, edge_class, 3));
  for (const std::string triangle_class : {"valid", "kod"})
    EXPECT_EQ(listed("triangles points.xyz -k 3 --class " + triangle_class),
              expected_triangles(instance, rows, triangle_class, 3));
}

/// One rule for all commands: of the points at one place, the lowest stays. Here that is row 3.
TEST_F(ListCommand, NamesTheLowestOfDuplicates) {
  directory_.file("points.csv", "x,y,z\n0,0,9\n1,0,1\n0,1,1\n0,0,2\n");
  EXPECT_EQ(listed("edges points.csv -k 0"), "u,v,order\n1,2,0\n1,3,0\n2,3,0\n");
  EXPECT_EQ(listed("triangles points.csv -k 0"), "a,b,c,order\n1,2,3,0\n");
}

TEST_F(ListCommand, CountsRowsWithoutTheHeader) {
  const std::string rows = "0,0\n0,0\n5,0\n0,5\n";
  const std::string expected = "a,b,c,order\n0,2,3,0\n";
  directory_.file("bare.csv", rows);
  directory_.file("headed.csv", "x,y\n" + rows);
  EXPECT_EQ(listed("triangles bare.csv"), expected);
  EXPECT_EQ(listed("triangles headed.csv"), expected);
}

TEST_F(ListCommand, TheDefaultIsOrder4AndUsefulOrValid) {
  directory_.file("points.csv", kPoints);
  EXPECT_EQ(listed("edges points.csv"), listed("edges points.csv --class useful -k 4"));
  EXPECT_NE(listed("edges points.csv"), listed("edges points.csv --class useful -k 3"));
  EXPECT_EQ(listed("triangles points.csv"), listed("triangles points.csv --class valid -k 4"));
}

TEST_F(ListCommand, AHugeOrderIsUnrestricted) {
  directory_.file("points.csv", kPoints);
  for (const std::string command :
       {"edges points.csv --class useful", "edges points.csv --class kod",
        "edges points.csv --class fixed", "triangles points.csv",
        "triangles points.csv --class kod"}) {
    const std::string expected = listed(command + " -k 5");  // n - 3
    EXPECT_EQ(listed(command + " -k 6"), expected) << command;
    EXPECT_EQ(listed(command + " -k 99999999999999999999"), expected) << command;
  }
}

TEST_F(ListCommand, WritesOnlyCsvToStandardOutput) {
  directory_.file("points.csv", kPoints);
  for (const std::string command : {"edges", "triangles"}) {
    const std::string expected = listed(command + " points.csv");
    const std::size_t entries = directory_.entries();
    ASSERT_EQ(run(command + " points.csv -o -"), 0) << err_;
    EXPECT_EQ(out_, expected);
    EXPECT_EQ(err_, "");
    ASSERT_EQ(run(command + " - -o -", "points.csv"), 0) << err_;
    EXPECT_EQ(out_, expected);
    EXPECT_EQ(directory_.entries(), entries) << "no file beside";
  }
}

TEST_F(ListCommand, ReportsWhatItWrote) {
  directory_.file("points.csv", kPoints);
  for (const std::string command : {"edges", "triangles"}) {
    const std::string text = listed(command + " points.csv");
    const auto records = std::count(text.begin(), text.end(), '\n') - 1;
    EXPECT_NE(out_.find("2 duplicates dropped"), std::string::npos) << out_;
    EXPECT_NE(out_.find(std::to_string(records)), std::string::npos) << out_;
    EXPECT_NE(out_.find("list.csv"), std::string::npos) << out_;
  }
}

TEST_F(ListCommand, TheSameBytesOnAnyThreadCount) {
  ASSERT_EQ(run("sample valley -n 10000 -o points.csv"), 0) << err_;
  for (const std::string command :
       {"edges points.csv -k 5", "edges points.csv -k 2 --class kod",
        "edges points.csv -k 5 --class fixed", "triangles points.csv -k 3",
        "triangles points.csv -k 2 --class kod"}) {
    const std::string one = listed(command + " --threads 1");
    EXPECT_TRUE(one == listed(command + " --threads 2")) << command;
    EXPECT_GT(std::count(one.begin(), one.end(), '\n'), 10000) << command;
  }
}

// ---- Refusals ----

TEST_F(ListCommand, RefusesAnUnknownClass) {
  directory_.file("points.csv", kPoints);
  for (const std::string list_class : {"valid", "Useful", "best", "''"})
    for (const std::string output : {"new.csv", "kept.csv", "-"})
      expect_refused(words({"edges points.csv -o", output, "--class", list_class}), "--class");
  for (const std::string list_class : {"useful", "fixed", "delaunay", "KOD", "''"})
    for (const std::string output : {"new.csv", "kept.csv", "-"})
      expect_refused(words({"triangles points.csv -o", output, "--class", list_class}), "--class");
}

TEST_F(ListCommand, RefusesBadOrdersAndUsage) {
  directory_.file("points.csv", kPoints);
  for (const std::string command : {"edges", "triangles"}) {
    const std::string start = command + " points.csv -o kept.csv ";
    for (const char* k : {"-1", "1.5", "x", "''", "1e3", "-0"})
      expect_refused(start + "-k " + k, "-k");
    expect_refused(start + "--threads 0", "--threads");
    expect_refused(start + "--bogus", "--bogus");
    expect_refused(start + "surplus", "surplus");
    expect_refused(command + " points.csv", "--output");
    expect_refused(command + " none.csv -o kept.csv", "none.csv");
    expect_refused(command + " points.csv -o none/list.csv", "none");
    expect_refused(command + " points.csv -o ./points.csv", "is the input");
    EXPECT_EQ(content_of(directory_ / "points.csv"), kPoints);
  }
}

TEST_F(ListCommand, RefusesPointsThatHaveNoTriangle) {
  directory_.file("line.csv", "0,0\n1,1\n2,2\n");
  directory_.file("two.csv", "0,0\n1,1\n0,0\n");
  directory_.file("nan.csv", "0,0\n1,1\nnan,0\n");
  for (const std::string command : {"edges", "triangles"}) {
    for (const std::string output : {"new.csv", "kept.csv", "-"}) {
      expect_refused(words({command, "line.csv -o", output}), "line");
      expect_refused(words({command, "two.csv -o", output}), "three");
      expect_refused(words({command, "nan.csv -o", output}), "line 3");
    }
  }
}

TEST_F(ListCommand, LeavesNothingHalfWrittenOnAFullDisk) {
  ASSERT_EQ(run("sample valley -n 5000 -o points.csv"), 0) << err_;
  directory_.file("kept.csv", "an existing output");
  const std::size_t entries = directory_.entries();
  for (const std::string command : {"edges", "triangles"})
    for (const std::string output : {"new.csv", "kept.csv"}) {
      // The largest file may have eight blocks of 512 or 1024 bytes.
      EXPECT_EQ(run(words({command, "points.csv -o", output}), "/dev/null", "ulimit -f 8 &&"), 2);
      EXPECT_NE(err_.find("cannot write"), std::string::npos) << err_;
    }
  EXPECT_EQ(directory_.entries(), entries);
  EXPECT_EQ(content_of(directory_ / "kept.csv"), "an existing output");
}

TEST_F(ListCommand, ExplainsItself) {
  for (const std::string command : {"edges", "triangles"}) {
    ASSERT_EQ(run(command + " --help"), 0);
    for (const char* word : {"Examples:", "--class", "--threads", "-k"})
      EXPECT_NE(out_.find(word), std::string::npos) << command << ' ' << word;
    EXPECT_EQ(err_, "");
  }
}

}  // namespace
}  // namespace hodt
