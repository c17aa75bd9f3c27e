#include "command_fixture.h"

namespace hodt {
namespace {

class ContoursCommand : public test::CommandTest {
 protected:
  void SetUp() override {
    put("pyramid.obj",
        "# crs: EPSG:25832\nv 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 2 2 4\n"
        "f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n");
  }
};

TEST_F(ContoursCommand, writes_lines_in_space) {
  const test::Outcome outcome =
      run("contours pyramid.obj --interval 1 --base 0.5 -o lines.geojson --json report.json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out,
            "contours 4 lines, 4 closed\nlevels   4 from 0.5 to 3.5\nwritten  lines.geojson\n");
  EXPECT_EQ(
      json("report.json"),
      test::Json({{"lines", 4}, {"closed", 4}, {"levels", 4}, {"lowest", 0.5}, {"highest", 3.5}}));
  const test::Json lines = json("lines.geojson");
  ASSERT_EQ(lines["features"].size(), 4u);
  const test::Json& line = lines["features"][1];
  EXPECT_EQ(line["properties"], test::Json({{"elevation", 1.5}, {"closed", 1}}));
  EXPECT_EQ(line["geometry"]["type"], "LineString");
  EXPECT_EQ(line["geometry"]["coordinates"], test::Json({{0.75, 0.75, 1.5},
                                                         {3.25, 0.75, 1.5},
                                                         {3.25, 3.25, 1.5},
                                                         {0.75, 3.25, 1.5},
                                                         {0.75, 0.75, 1.5}}));
}

TEST_F(ContoursCommand, may_find_nothing) {
  const test::Outcome outcome =
      run("contours pyramid.obj --interval 100 --base 50 -o lines.gpkg --json report.json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "contours 0 lines, 0 closed\nwritten  lines.gpkg\n");
  EXPECT_EQ(json("report.json")["lowest"], nullptr);
}

TEST_F(ContoursCommand, refuses_bad_usage) {
  const std::string contours = "contours pyramid.obj ";
  expect_refused(contours + "-o a.geojson", "--interval");
  expect_refused(contours + "--interval 0 -o a.geojson", "--interval must be positive, not '0'");
  expect_refused(contours + "--interval=-1 -o a.geojson", "--interval must be positive");
  expect_refused(contours + "--interval ten -o a.geojson", "--interval must be a number");
  expect_refused(contours + "--interval 1 --base inf -o a.geojson", "--base must be a number");
  expect_refused(contours + "--interval 1e-9 -o a.geojson", "pyramid.obj: an interval of 1e-09");
  expect_refused(contours + "--interval 1 -o a.dxf", "unknown extension '.dxf'");
  expect_refused(contours + "--interval 1 -o pyramid.obj", "unknown extension");
  expect_refused("contours none.ply --interval 1 -o a.gpkg", "none.ply");
  put("flat.obj", "v 0 0\nv 1 0\nv 0 1\nf 1 2 3\n");
  expect_refused("contours flat.obj --interval 1 -o a.gpkg", "contours need heights");
}

}  // namespace
}  // namespace hodt
