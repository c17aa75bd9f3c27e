// hodt voronoi as users see it.
#include <set>
#include <string>
#include <vector>

#include "command_fixture.h"
#include <gtest/gtest.h>

namespace hodt {
namespace {

using test::content_of;
using test::Json;

class VoronoiCommand : public test::CommandTest {
 protected:
  /// Runs the command in the directory; returns its exit code.
  int run(const std::string& arguments, const std::string& input = "/dev/null") {
    const test::Outcome outcome = shell("HODT voronoi " + arguments + " <" + input);
    out_ = outcome.out;
    err_ = outcome.err;
    return outcome.exit_code;
  }

  /// Refused, and "kept" stays as it is.
  void expect_refused(const std::string& arguments, const std::string& message) {
    put("kept", "an existing output");
    CommandTest::expect_refused("voronoi " + arguments, message);
    EXPECT_EQ(content_of(directory_ / "kept"), "an existing output");
  }

  std::string out_, err_;
};

/// Twice the signed area of a closed ring.
double twice_area(const Json& ring) {
  double sum = 0;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    const double x0 = ring[i - 1][0], y0 = ring[i - 1][1], x1 = ring[i][0], y1 = ring[i][1];
    sum += x0 * y1 - x1 * y0;
  }
  return sum;
}

// A square with a point off its middle; row 2 is a duplicate of row 0.
const char* const kPoints = "x,y,z\n0,0,1\n4,0,1\n0,0,2\n4,4,1\n0,4,1\n1,1.5,0\n";

TEST_F(VoronoiCommand, WritesPolygonsThatTileTheBox) {
  directory_.file("points.csv", kPoints);
  for (const int m : {1, 2, 3, 4}) {
    ASSERT_EQ(run("points.csv -m " + std::to_string(m) + " -o cells.geojson --box -1,-1,5,6.5"), 0)
        << err_;
    EXPECT_EQ(err_, "");
    EXPECT_NE(out_.find("1 duplicate dropped"), std::string::npos) << out_;
    const Json collection = json("cells.geojson");
    EXPECT_EQ(collection["type"], "FeatureCollection");
    std::set<Json> cells;
    double area = 0;
    for (const Json& feature : collection["features"]) {
      EXPECT_EQ(feature["type"], "Feature");
      EXPECT_EQ(feature["geometry"]["type"], "Polygon");
      const Json& points = feature["properties"]["points"];
      EXPECT_EQ(points.size(), std::size_t(m));
      EXPECT_TRUE(cells.insert(points).second);
      for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_NE(points[i], 2);
        EXPECT_TRUE(i == 0 || points[i - 1] < points[i]);
      }
      ASSERT_EQ(feature["geometry"]["coordinates"].size(), 1u);
      const Json& ring = feature["geometry"]["coordinates"][0];
      EXPECT_GE(ring.size(), 4u);
      EXPECT_EQ(ring.front(), ring.back());
      EXPECT_GT(twice_area(ring), 0);
      area += twice_area(ring) / 2;
    }
    EXPECT_NEAR(area, 6 * 7.5, 1e-9);
  }
}

TEST_F(VoronoiCommand, TheDefaultBoxIsALittleLargerThanThePoints) {
  directory_.file("points.csv", "0,0\n10,0\n0,4\n");
  ASSERT_EQ(run("points.csv -m 1 -o -"), 0) << err_;
  const Json collection = Json::parse(out_);
  double low_x = 99, high_x = -99, low_y = 99, high_y = -99;
  for (const Json& feature : collection["features"])
    for (const Json& corner : feature["geometry"]["coordinates"][0]) {
      low_x = std::min(low_x, corner[0].get<double>());
      high_x = std::max(high_x, corner[0].get<double>());
      low_y = std::min(low_y, corner[1].get<double>());
      high_y = std::max(high_y, corner[1].get<double>());
    }
  EXPECT_EQ((std::vector<double>{low_x, low_y, high_x, high_y}),
            (std::vector<double>{-1, -1, 11, 5}));
}

TEST_F(VoronoiCommand, ReadsStandardInputAndTakesAnyNumberOfThreads) {
  std::string text;
  unsigned state = 7;
  for (int i = 0; i < 3000; ++i) {
    state = state * 1664525 + 1013904223;
    text += std::to_string(state >> 16 & 255) + ',' + std::to_string(state >> 24) + '\n';
  }
  directory_.file("points.csv", text);
  ASSERT_EQ(run("points.csv -m 4 -o one.geojson --threads 1"), 0) << err_;
  ASSERT_EQ(run("- -m 4 -o two.geojson --threads 4", "points.csv"), 0) << err_;
  EXPECT_EQ(content_of(directory_ / "one.geojson"), content_of(directory_ / "two.geojson"));
  EXPECT_GT(json("one.geojson")["features"].size(), 3000u);
}

TEST_F(VoronoiCommand, NamesTheCoordinateSystem) {
  directory_.file("points.csv", kPoints);
  ASSERT_EQ(run("points.csv -m 1 -o cells.geojson --crs EPSG:25832"), 0) << err_;
  EXPECT_EQ(json("cells.geojson")["crs"]["type"], "name");
  EXPECT_EQ(json("cells.geojson")["crs"]["properties"]["name"], "urn:ogc:def:crs:EPSG::25832");
  ASSERT_EQ(run("points.csv -m 1 -o cells.geojson"), 0) << err_;
  EXPECT_FALSE(json("cells.geojson").contains("crs"));
}

TEST_F(VoronoiCommand, ABoxFarFromAllPointsIsInOneCell) {
  directory_.file("points.csv", kPoints);
  ASSERT_EQ(run("points.csv -m 1 -o cells.geojson --box 1000,2000,1001,2001"), 0) << err_;
  const Json features = json("cells.geojson")["features"];
  ASSERT_EQ(features.size(), 1u);
  EXPECT_EQ(features[0]["properties"]["points"], Json::array({3}));
  EXPECT_EQ(features[0]["geometry"]["coordinates"][0].size(), 5u);
}

TEST_F(VoronoiCommand, RefusesWhatItCannotDo) {
  directory_.file("points.csv", kPoints);
  directory_.file("line.csv", "0,0\n1,1\n2,2\n");
  for (const char* m : {"0", "-1", "1.5", "x", "''"})
    expect_refused("points.csv -o kept -m " + std::string(m), "-m must be");
  expect_refused("points.csv -o kept -m 5", "distinct points, 5");
  expect_refused("points.csv -o kept -m 99999999999999999999", "distinct points, 5");
  expect_refused("points.csv -o kept", "--order is required");
  expect_refused("points.csv -m 1", "--output is required");
  expect_refused("line.csv -o kept -m 1", "on one line");
  expect_refused("none.csv -o kept -m 1", "none.csv");
  expect_refused("points.csv -o none/kept -m 1", "none");
  expect_refused("points.csv -o ./points.csv -m 1", "is the input");
  expect_refused("points.csv -o kept -m 1 --threads 0", "--threads");
  for (const char* box : {"1,2,3", "1,2,3,4,5", "a,b,c,d", "0,0,0,1", "0,1,1,0", "0,0,nan,1",
                          "0,0,inf,1", "0,0,1,1,"})
    expect_refused("points.csv -o kept -m 1 --box " + std::string(box), "--box must be");
}

TEST_F(VoronoiCommand, ExplainsItself) {
  ASSERT_EQ(run("--help"), 0);
  EXPECT_NE(out_.find("Examples:"), std::string::npos);
  EXPECT_NE(out_.find("--box"), std::string::npos);
}

}  // namespace
}  // namespace hodt
