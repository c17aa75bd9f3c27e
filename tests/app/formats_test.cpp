// hodt formats, and docs/formats.md, which has its table.
#include <cstddef>
#include <string>
#include <vector>

#include "command_fixture.h"
#include <gtest/gtest.h>

namespace hodt {
namespace {

using test::content_of;
using test::Json;
using test::Outcome;

class Formats : public test::CommandTest {};

TEST_F(Formats, AreListed) {
  const Outcome outcome = run("formats");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_TRUE(outcome.out.starts_with("format ")) << outcome.out;
  EXPECT_NE(outcome.out.find("\nVTU "), std::string::npos);
  EXPECT_EQ(outcome.out.find(" \n"), std::string::npos) << "no blanks at the end";
  expect_refused("formats --json none/a.json", "there is no directory");
}

TEST_F(Formats, ThatNeedGdalSayWhetherItIsThere) {
  const std::string out = run("formats").out;
  const std::size_t at = out.find("need GDAL: ");
  ASSERT_NE(at, std::string::npos) << out;
  put("plane.csv", "x,y,z\n0,0,0\n9,0,0\n0,9,0\n");
  const int made = run("triangulate plane.csv -k 0 --resolution 3 -o plane.tif").exit_code;
  EXPECT_EQ(out.substr(at).starts_with("need GDAL: it is there.\n"), made == 0) << out;
}

TEST_F(Formats, AreToldToPrograms) {
  const Json all = Json::parse(run("formats --json -").out);
  bool has_stl = false;
  for (const Json& format : all) {
    EXPECT_FALSE(format["extensions"].empty());
    EXPECT_FALSE(format["reads"].empty() && format["writes"].empty()) << format;
    if (format["name"] != "STL") continue;
    has_stl = true;
    EXPECT_EQ(format["extensions"], Json({".stl"}));
    EXPECT_EQ(format["writes"], Json({"mesh"}));
    EXPECT_EQ(format["keeps"], Json({{"heights", false}, {"crs", false}, {"order", false}}));
  }
  EXPECT_TRUE(has_stl);
}

TEST_F(Formats, AreThoseOfTheDocumentation) {
  const std::string page = content_of(HODT_SOURCE_DIR "/docs/formats.md");
  const std::string table = run("formats --markdown").out;
  EXPECT_FALSE(table.empty());
  EXPECT_NE(page.find("\n\n" + table + "\n"), std::string::npos)
      << "docs/formats.md wants the table that 'hodt formats --markdown' prints:\n"
      << table;
}

TEST_F(Formats, OfSinglePrecisionWarnOnce) {
  put("points.csv", "x,y,z\n500000.1,5400000,4\n500010,5400001.3,0\n500003,5400009,2\n");
  for (const std::string name : {"a.stl", "a.glb"}) {
    const Outcome outcome = run("triangulate points.csv -k 0 -o " + name);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(outcome.err.starts_with("hodt: warning: " + name + ": ")) << outcome.err;
    EXPECT_NE(outcome.err.find("origin at x 500005, y 5400005, z 2"), std::string::npos)
        << outcome.err;
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
  }
  EXPECT_EQ(run("triangulate points.csv -k 0 -o a.vtu").err, "");
  put("whole.csv", "x,y,z\n0,0,4\n1,0,0\n0,1,2\n");
  EXPECT_EQ(run("triangulate whole.csv -k 0 -o b.stl").err, "") << "nothing is lost";
}

/// The orders in the file are those that the report counts.
TEST_F(Formats, KeepOrdersOfTriangles) {
  ASSERT_EQ(shell("HODT sample valley -n 3000 -o valley.csv").exit_code, 0);
  ASSERT_EQ(run("triangulate valley.csv -k 4 -o a.vtu --json report.json").exit_code, 0);
  const std::string vtu = content_of(directory_ / "a.vtu");
  const std::size_t triangles = json("report.json")["triangles"];
  // The orders, four bytes each, stand before the last array, of a byte each and its length.
  const std::size_t begin = vtu.rfind("\n</AppendedData>") - triangles - 8 - 4 * triangles;
  std::vector<std::size_t> histogram;
  for (std::size_t t = 0; t < triangles; ++t) {
    const auto order = static_cast<unsigned char>(vtu[begin + 4 * t]);
    if (histogram.size() <= order) histogram.resize(order + 1u);
    ++histogram[order];
  }
  EXPECT_EQ(Json(histogram), json("report.json")["order_histogram"]);
  EXPECT_GT(histogram.size(), 2u);
}

}  // namespace
}  // namespace hodt
