// hodt compare as users see it.
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "command_fixture.h"
#include <gtest/gtest.h>

#include "hodt/io/formats.h"

namespace hodt {
namespace {

using test::content_of;
using test::Json;
using test::Outcome;

class CompareCommand : public test::CommandTest {
 protected:
  void sample() const { ASSERT_EQ(run("sample jacksboro -n 300 -o points.csv").exit_code, 0); }

  Json compared(const std::string& arguments) const {
    const Outcome outcome = run("compare " + arguments + " --json -");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return Json::parse(outcome.out, nullptr, false);
  }
  /// Every row is what triangulate reports of the same points, with the same options.
  void expect_as_triangulate(const std::string& input, const Json& comparison) const {
    for (const Json& objective : comparison["objectives"]) {
      std::string names = objective["objective"];
      for (const std::string name : objective["then"]) names += "," + name;
      for (const Json& row : objective["rows"]) {
        const std::string k = row["k"].dump();
        const Outcome outcome = run("triangulate " + input + " -o mesh.ply --json one.json -k " +
                                    k + " --objective " + names);
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        const Json report = json("one.json");
        EXPECT_EQ(row["value"], report["value"]["result"]) << names << " " << k;
        EXPECT_EQ(row["bound"], report["value"]["bound"]) << names << " " << k;
        EXPECT_EQ(row["optimal"], report["value"]["optimal"]) << names << " " << k;
        EXPECT_EQ(row["order"], report["order"]) << names << " " << k;
        ASSERT_EQ(row["then"].size(), report["then"].size());
        for (std::size_t i = 0; i < row["then"].size(); ++i) {
          const Json &found = row["then"][i], &later = report["then"][i];
          EXPECT_EQ(found["objective"], later["objective"]);
          EXPECT_EQ(found["value"], later["value"]["result"]) << names << " " << k;
          EXPECT_EQ(found["bound"], later["value"]["bound"]) << names << " " << k;
          EXPECT_EQ(found["optimal"], later["value"]["optimal"]) << names << " " << k;
          EXPECT_EQ(found["bound_in_order"], later["value"]["bound_in_order"]) << names << " " << k;
        }
        EXPECT_EQ(comparison["constraints"], report["constraints"]);
        EXPECT_EQ(comparison["points"], report["points"]);
        if (report["input"].is_null()) {
          EXPECT_TRUE(comparison["input"].is_null());
          EXPECT_TRUE(objective["input"].is_null());
          continue;
        }
        EXPECT_EQ(comparison["input"]["order"], report["input"]["order"]);
        EXPECT_EQ(comparison["input"]["unused_vertices"], report["input"]["unused_vertices"]);
        EXPECT_EQ(objective["input"][0], report["value"]["input"]) << names << " " << k;
      }
    }
  }

  Json orders(const std::string& list) const {
    return compared("points.csv --orders " + list)["orders"];
  }
};

/// The lines of the text, as words.
std::vector<std::vector<std::string>> words_of(const std::string& text) {
  std::vector<std::vector<std::string>> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    lines.emplace_back();
    for (std::string word; words >> word;) lines.back().push_back(word);
  }
  return lines;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST_F(CompareCommand, AgreesWithTriangulate) {
  sample();
  const Json comparison =
      compared("points.csv --orders 0-3,8 --objective min-local-minima,min-sum-length");
  EXPECT_EQ(comparison["points"], 300);
  EXPECT_EQ(comparison["duplicates"], 0);
  EXPECT_EQ(comparison["orders"], Json::array({0, 1, 2, 3, 8}));
  ASSERT_EQ(comparison["objectives"].size(), 2u);
  for (const Json& objective : comparison["objectives"]) {
    const std::string name = objective["objective"];
    ASSERT_EQ(objective["rows"].size(), 5u);
    for (const Json& row : objective["rows"]) {
      const std::string k = row["k"].dump();
      ASSERT_EQ(
          run("triangulate points.csv -o mesh.ply --json one.json -k " + k + " --objective " + name)
              .exit_code,
          0);
      const Json report = json("one.json");
      EXPECT_EQ(row["value"], report["value"]["result"]) << name << " " << k;
      EXPECT_EQ(row["bound"], report["value"]["bound"]) << name << " " << k;
      EXPECT_EQ(row["optimal"], report["value"]["optimal"]) << name << " " << k;
      EXPECT_EQ(row["order"], report["order"]) << name << " " << k;
      const Json& minima = report["local_minima"]["result"];
      EXPECT_EQ(row["local_minima"], int(minima["interior"]) + int(minima["boundary"]));
      EXPECT_EQ(row["pits"]["interior_minima"], minima["interior"]);
      const double before = report["value"]["delaunay"], after = report["value"]["result"];
      EXPECT_NEAR(row["change_percent"], 100 * (after - before) / before, 1e-9);
      EXPECT_TRUE(row["rmse"].is_null());
      EXPECT_TRUE(row["max_error"].is_null());
      EXPECT_TRUE(row["seconds"].is_number());
      EXPECT_TRUE(row["k"] != 0 || row["value"] == report["value"]["delaunay"]);
    }
  }
}

TEST_F(CompareCommand, AgreesWithTriangulateInOrder) {
  sample();
  const Json comparison = compared(
      "points.csv --orders 0,1,4 --objective "
      "min-local-minima+min-sum-abn,min-sum-abn,min-max-degree+min-local-minima+max-min-angle");
  ASSERT_EQ(comparison["objectives"].size(), 3u);
  const Json &in_order = comparison["objectives"][0], &alone = comparison["objectives"][1];
  EXPECT_EQ(in_order["objective"], "min-local-minima");
  EXPECT_EQ(in_order["then"], Json::array({"min-sum-abn"}));
  EXPECT_EQ(alone["then"], Json::array());
  // What comes second has less to choose from.
  EXPECT_GE(double(in_order["rows"][2]["then"][0]["value"]), double(alone["rows"][2]["value"]));
  expect_as_triangulate("points.csv", comparison);

  const Outcome outcome =
      run("compare points.csv --orders 0,4 --objective min-local-minima+min-sum-abn,min-max-angle "
          "-o page.html");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("\nmin-local-minima, then min-sum-abn\n"), std::string::npos);
  EXPECT_NE(outcome.out.find("\nthen min-sum-abn\n"), std::string::npos) << outcome.out;
  const std::string page = content_of(directory_ / "page.html");
  EXPECT_NE(page.find("<h2 id=\"min-local-minima+min-sum-abn\">min-local-minima, then min-sum-abn"),
            std::string::npos);
  EXPECT_NE(page.find("href=\"#min-local-minima+min-sum-abn\""), std::string::npos);
  EXPECT_NE(page.find("<h3>then min-sum-abn</h3>"), std::string::npos);
  EXPECT_EQ(count_of(page, "<svg"), 3u);

  for (const char* names : {"min-local-minima+none", "none+min-max-angle", "all+min-max-angle",
                            "min-max-angle+", "min-max-angle+min-max-angle"})
    expect_refused("compare points.csv --objective " + std::string(names), "objective");
  put("flat.csv", "0,0\n4,0\n0,4\n5,5\n2,1\n");
  expect_refused("compare flat.csv --objective min-max-angle+min-sum-abn",
                 "flat.csv: the objective min-sum-abn needs heights");
  expect_refused("compare points.csv --min-pit-depth 1 --objective min-max-angle+min-local-minima",
                 "minima");
}

TEST_F(CompareCommand, AgreesWithTriangulateBesideLines) {
  ASSERT_EQ(run("sample valley -n 400 -o points.csv").exit_code, 0);
  const Json info = Json::parse(run("info points.csv --json -").out);
  const double left = info["x"][0], right = info["x"][1];
  const double low = info["y"][0], high = info["y"][1];
  const auto at = [&](double x, double y) {
    return "[" + std::to_string(left + x * (right - left)) + "," +
           std::to_string(low + y * (high - low)) + "]";
  };
  put("road.geojson", R"({"type":"LineString","coordinates":[)" + at(0.1, 0.5) + "," +
                          at(0.5, 0.4) + "," + at(0.9, 0.6) + "]}");
  put("site.geojson", R"({"type":"Polygon","coordinates":[[)" + at(0.1, 0.1) + "," + at(0.9, 0.1) +
                          "," + at(0.7, 0.9) + "," + at(0.1, 0.1) + "]]}");
  put("edges.csv", "u,v\n0,399\n");
  const std::string objectives =
      " --orders 0,2,5 --objective min-local-minima,min-max-angle+"
      "min-sum-length";
  for (const std::string options :
       {"--breaklines road.geojson", "--outline site.geojson", "--keep-edges edges.csv",
        "--breaklines road.geojson --outline site.geojson --split-crossings --max-edge 100000"}) {
    const std::string input = "points.csv " + options;
    const Json comparison = compared(input + objectives);
    EXPECT_FALSE(comparison["constraints"].is_null());
    expect_as_triangulate(input, comparison);
  }
  const Outcome outcome =
      run("compare points.csv --breaklines road.geojson --orders 0,2 -o page.html");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("\nconstraints 2 pieces of lines, "), std::string::npos)
      << outcome.out;
  EXPECT_NE(
      content_of(directory_ / "page.html").find("<dt>constraints</dt><dd>2 pieces of lines, "),
      std::string::npos);
  expect_refused("compare points.csv --breaklines none.geojson", "none.geojson");
  expect_refused("compare points.csv --breaklines road.geojson --outline site.geojson",
                 "--split-crossings");
  expect_refused("compare points.csv --breaklines road.geojson --json road.geojson",
                 "road.geojson");
}

TEST_F(CompareCommand, AgreesWithTriangulateOfAMesh) {
  ASSERT_EQ(run("sample jacksboro -n 200 -o points.csv").exit_code, 0);
  ASSERT_EQ(run("triangulate points.csv -o in.obj -k 3 --objective max-sum-length").exit_code, 0);
  const Json comparison =
      compared("in.obj --orders 0-4 --objective min-local-minima,min-max-angle+min-sum-length");
  EXPECT_EQ(comparison["input"]["order"], 3);
  ASSERT_EQ(comparison["objectives"][1]["input"].size(), 2u);
  expect_as_triangulate("in.obj", comparison);
  const std::string text = run("compare in.obj --orders 0-4 --objective min-max-angle").out;
  EXPECT_NE(text.find("a mesh of order 3"), std::string::npos) << text;
  EXPECT_NE(text.find("\nmin-max-angle, of the input "), std::string::npos) << text;
  put("more.csv", "0,0,1\n4,0,2\n0,4,3\n");
  expect_refused("compare in.obj more.csv", "in.obj is a mesh");
  expect_refused("compare in.obj --max-edge 3", "the outline of in.obj stays");
}

TEST_F(CompareCommand, TellsTheGapToTheBound) {
  sample();
  const Json comparison = compared("points.csv --orders 1,8 --objective min-sum-abn");
  const Json& rows = comparison["objectives"][0]["rows"];
  EXPECT_EQ(rows[0]["optimal"], true);
  EXPECT_EQ(rows[0]["gap"], 0);
  ASSERT_EQ(rows[1]["optimal"], false) << "choose points that leave a gap";
  const double value = rows[1]["value"], bound = rows[1]["bound"];
  EXPECT_NEAR(rows[1]["gap"], 100 * (value - bound) / value, 1e-9);
}

TEST_F(CompareCommand, MeasuresTheSmallestAngle) {
  put("points.csv", "0,0\n4,0\n0,4\n");
  const Json rows =
      compared("points.csv --orders 0 --objective min-max-angle")["objectives"][0]["rows"];
  EXPECT_NEAR(rows[0]["smallest_angle"], 45, 1e-9);
  EXPECT_NEAR(rows[0]["value"], 90, 1e-9);
}

TEST_F(CompareCommand, MeasuresPits) {
  // A pyramid upside down, 3 deep.
  put("pyramid.csv", "0,0,4\n4,0,4\n0,4,4\n4,4,4\n2,2,1\n");
  const Json pyramid = compared("pyramid.csv --orders 0");
  const Json full = {
      {"interior_minima", 1}, {"total_depth", 3}, {"largest_depth", 3}, {"volume", 16}};
  EXPECT_EQ(pyramid["delaunay_pits"], full);
  EXPECT_EQ(pyramid["objectives"][0]["rows"][0]["pits"], full);
  const std::string table = run("compare pyramid.csv --orders 0").out;
  EXPECT_NE(table.find("Delaunay: 1 interior minimum, 3 deep in all, the deepest 3, volume 16"),
            std::string::npos)
      << table;

  sample();
  const Json hills = compared("points.csv --orders 0,8");
  const Json& rows = hills["objectives"][0]["rows"];
  EXPECT_EQ(rows[0]["pits"], hills["delaunay_pits"]);
  for (const char* total : {"interior_minima", "total_depth", "volume"})
    EXPECT_LT(double(rows[1]["pits"][total]), double(rows[0]["pits"][total])) << total;
}

TEST_F(CompareCommand, PrintsATable) {
  sample();
  const Json rows = compared("points.csv --orders 0,4")["objectives"][0]["rows"];
  const Outcome outcome = run("compare points.csv --orders 0,4");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto lines = words_of(outcome.out);
  ASSERT_EQ(lines.size(), 8u) << outcome.out;
  EXPECT_EQ(lines[0], (std::vector<std::string>{"points", "300,", "0", "duplicates", "dropped"}));
  EXPECT_EQ(lines[1][0], "pits");
  EXPECT_EQ(lines[2][0], "columns");
  EXPECT_EQ(lines[4], std::vector<std::string>{"min-local-minima"});
  EXPECT_EQ(lines[5][0], "k");
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(lines[6 + i][0], rows[i]["k"].dump());
    EXPECT_EQ(lines[6 + i][1], rows[i]["value"].dump());
    EXPECT_EQ(lines[6 + i][2], rows[i]["bound"].dump());
    EXPECT_EQ(lines[6 + i][3], "proved");
  }
  std::vector<std::size_t> widths;
  std::istringstream stream(outcome.out);
  for (std::string line; std::getline(stream, line);)
    if (line.starts_with(" ")) widths.push_back(line.size() - count_of(line, "°"));
  ASSERT_EQ(widths.size(), 3u);
  EXPECT_EQ(widths[0], widths[1]);
  EXPECT_EQ(widths[1], widths[2]);
}

TEST_F(CompareCommand, UnderstandsListsOfOrders) {
  put("points.csv", "0,0,1\n4,0,2\n0,4,3\n5,5,0\n2,1,1\n");
  EXPECT_EQ(compared("points.csv")["orders"], Json::array({0, 1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(orders("3"), Json::array({3}));
  EXPECT_EQ(orders("8,0,2-4,3,8"), Json::array({0, 2, 3, 4, 8}));
  EXPECT_EQ(orders("2-2"), Json::array({2}));
}

TEST_F(CompareCommand, RefusesBadUsage) {
  put("points.csv", "0,0,1\n4,0,2\n0,4,3\n5,5,0\n2,1,1\n");
  put("flat.csv", "0,0\n4,0\n0,4\n");
  for (const char* list : {"''", "-1", "x", "1.5", "5-", "-", "8-3", "0,,1", "1,", "0-8-9", "1e3"})
    expect_refused("compare points.csv --orders " + std::string(list), "--orders");
  expect_refused("compare points.csv --orders 0-1000000", "more than 1000");
  expect_refused("compare points.csv --objective beauty", "beauty");
  expect_refused("compare points.csv --objective min-max-angle,beauty", "beauty");
  expect_refused("compare points.csv --objective none", "none");
  expect_refused("compare points.csv --time-limit soon", "--time-limit");
  expect_refused("compare points.csv --threads 0", "--threads");
  expect_refused("compare points.csv -o report.pdf", ".html");
  expect_refused("compare points.csv -o none/report.html", "none");
  expect_refused("compare points.csv --json points.csv", "is the input");
  expect_refused("compare points.csv --truth flat.csv --json flat.csv", "flat.csv");
  expect_refused("compare points.csv --truth flat.csv", "flat.csv: the truth needs heights");
  expect_refused("compare points.csv --truth none.csv -o report.html", "none.csv");
  expect_refused("compare flat.csv --objective min-max-angle --truth points.csv", "flat.csv");
  expect_refused("compare flat.csv", "flat.csv: the objective min-local-minima needs heights");
  expect_refused("compare - --truth -", "standard input");
  expect_refused("compare none.csv", "none.csv");
  put("line.csv", "0,0,1\n1,1,2\n2,2,3\n");
  expect_refused("compare line.csv -o report.html", "line.csv");
}

TEST_F(CompareCommand, LeavesOutWhatNeedsHeights) {
  put("flat.csv", "0,0\n4,0\n0,4\n5,5\n2,1\n3,3\n1,2\n");
  sample();
  const Json flat = compared("flat.csv --orders 0-2 --objective all");
  const Json full = compared("points.csv --orders 0 --objective all");
  EXPECT_EQ(flat["objectives"].size() + 4, full["objectives"].size());
  EXPECT_GE(flat["objectives"].size(), 6u);
  for (const Json& objective : flat["objectives"]) {
    const std::string name = objective["objective"];
    EXPECT_EQ(name.find("local"), name.npos);
    EXPECT_EQ(name.find("flat"), name.npos);
    for (const Json& row : objective["rows"]) {
      EXPECT_TRUE(row["local_minima"].is_null());
      EXPECT_TRUE(row["pits"].is_null());
    }
  }
  EXPECT_TRUE(flat["delaunay_pits"].is_null());
  EXPECT_EQ(run("compare flat.csv --objective all").out.find("local minima"), std::string::npos);
}

TEST_F(CompareCommand, ComparesEachObjectiveOnce) {
  sample();
  const Json objectives = compared(
      "--objective min-sum-length points.csv --objective min-max-angle,min-sum-length "
      "--orders 0")["objectives"];
  ASSERT_EQ(objectives.size(), 2u);
  EXPECT_EQ(objectives[0]["objective"], "min-sum-length");
  EXPECT_EQ(objectives[1]["objective"], "min-max-angle");
}

TEST_F(CompareCommand, FindsNoErrorInAPlane) {
  // z = 2x + 3y - 1.
  put("points.csv", "0,0,-1\n8,0,15\n0,8,23\n8,8,39\n2,1,6\n5,6,27\n3,5,20\n6,2,17\n");
  put("truth.csv", "x,y,z\n1,1,4\n4,4,19\n0,0,-1\n8,4,27\n7,7,34\n9,9,0\n-1,0,50\n");
  const Json comparison =
      compared("points.csv --truth truth.csv --orders 0-4 --objective min-sum-length");
  EXPECT_EQ(comparison["truth"]["points"], 7);
  EXPECT_EQ(comparison["truth"]["outside"], 2);
  EXPECT_EQ(comparison["truth"]["delaunay_rmse"], 0);
  for (const Json& row : comparison["objectives"][0]["rows"]) {
    EXPECT_NEAR(row["rmse"], 0, 1e-12);
    EXPECT_NEAR(row["max_error"], 0, 1e-12);
  }
}

TEST_F(CompareCommand, MeasuresErrors) {
  put("points.csv", "0,0,0\n4,0,0\n0,4,0\n4,4,0\n2,2,8\n");
  // The pyramid is 4 high at (1, 2) and (2, 3): errors 3 and -4. The last is outside.
  put("truth.csv", "1,2,1\n2,3,8\n9,9,9\n");
  const Json comparison = compared("points.csv --truth truth.csv --orders 1,2");
  const Json& truth = comparison["truth"];
  EXPECT_EQ(truth["outside"], 1);
  EXPECT_NEAR(truth["delaunay_rmse"], std::sqrt(12.5), 1e-12);
  EXPECT_EQ(truth["delaunay_max_error"], 4);
  const Json& row = comparison["objectives"][0]["rows"][0];
  EXPECT_NEAR(row["rmse"], std::sqrt(12.5), 1e-12);
  EXPECT_EQ(row["max_error"], 4);
  const std::string table = run("compare points.csv --truth truth.csv --orders 1").out;
  EXPECT_NE(table.find("1 outside the hull"), std::string::npos) << table;
  EXPECT_NE(table.find("RMSE 3.53"), std::string::npos) << table;

  put("far.csv", "99,99,1\n");
  const Outcome outcome = run("compare points.csv --truth far.csv --orders 0 --json -");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err,
            "hodt: warning: far.csv: of its 1 point none is within the triangulation, so that no "
            "height is compared; is it of the same place, and in the same units?\n");
  const Json far = Json::parse(outcome.out, nullptr, false);
  EXPECT_EQ(far["truth"]["outside"], 1);
  EXPECT_TRUE(far["truth"]["delaunay_rmse"].is_null());
  EXPECT_TRUE(far["objectives"][0]["rows"][0]["rmse"].is_null());
}

/// A level surface over land that has a pit, 3 deep in one cell of 2 by 2.
TEST_F(CompareCommand, follows_water_on_a_raster_of_truth) {
  if (!has_gdal()) GTEST_SKIP() << "rasters are read by GDAL";
  put("points.csv", "x,y,z\n0,0,5\n12,0,5\n12,12,5\n0,12,5\n");
  const std::string row = "5 5 5 5 5 5\n";
  put("land.asc", "ncols 6\nnrows 6\nxllcorner 0\nyllcorner 0\ncellsize 2\nNODATA_value -9\n" +
                      row + row + "5 5 2 5 5 5\n" + row + row + row);
  const Json level = compared("points.csv --truth land.asc --orders 0");
  EXPECT_EQ(level["truth"]["land_fill_volume"], 12);
  EXPECT_EQ(level["truth"]["delaunay_rmse"], 0.5);
  const Json land = level["objectives"][0]["rows"][0]["land"];
  EXPECT_EQ(land, level["truth"]["delaunay_land"]);
  EXPECT_EQ(land["fill_volume"], 0);
  EXPECT_EQ(land["fill_depth"], 0);
  // Beside the pit are four of the 16 cells that have four neighbours: there it drops by 3 in 4.
  EXPECT_NEAR(land["slope_error"], std::atan(0.75) * 180 / std::acos(-1.0) / 2, 1e-9);
  EXPECT_TRUE(land["stream_agreement"].is_null());
  const std::string text = run("compare points.csv --truth land.asc --orders 0").out;
  EXPECT_NE(text.find("of the land itself 12"), std::string::npos) << text;

  // The cells of the land as points; and half of the land, where the surface ends.
  const Json same = compared("land.asc --truth land.asc --orders 0,2");
  for (const Json& each : same["objectives"][0]["rows"]) {
    EXPECT_EQ(each["land"]["fill_volume"], 12);
    EXPECT_EQ(each["land"]["fill_depth"], 3);
    EXPECT_EQ(each["land"]["slope_error"], 0);
  }
  put("half.csv", "x,y,z\n0,0,5\n12,0,5\n12,5,5\n0,5,5\n");
  EXPECT_EQ(compared("half.csv --truth land.asc --orders 0")["truth"]["land_fill_volume"], 0);

  put("cells.csv", "x,y,z\n1,1,5\n3,3,5\n");
  const Json points = compared("points.csv --truth cells.csv --orders 0");
  EXPECT_TRUE(points["truth"]["delaunay_land"].is_null());
  EXPECT_TRUE(points["objectives"][0]["rows"][0]["land"].is_null());
}

/// Streams of an eroded landscape, by a sample of a fifth of it.
TEST_F(CompareCommand, compares_streams) {
  if (!has_gdal()) GTEST_SKIP() << "rasters are read by GDAL";
  ASSERT_EQ(run("sample valley -n 20000 -o all.csv").exit_code, 0);
  ASSERT_EQ(run("triangulate all.csv -k 0 --objective none -o all.ply").exit_code, 0);
  ASSERT_EQ(shell("awk 'NR % 5 == 1' all.csv > few.csv").exit_code, 0);
  ASSERT_EQ(run("raster all.ply --resolution 10 -o land.tif").exit_code, 0);
  const Json comparison =
      compared("few.csv --truth land.tif --orders 0,8 --objective min-local-minima+min-sum-abn");
  const Json delaunay = comparison["truth"]["delaunay_land"];
  const Json& rows = comparison["objectives"][0]["rows"];
  EXPECT_EQ(rows[0]["land"], delaunay);
  EXPECT_GT(delaunay["stream_agreement"], 0.8);
  EXPECT_LT(delaunay["stream_agreement"], 1);
  EXPECT_LT(rows[1]["land"]["fill_volume"], delaunay["fill_volume"]);
}

TEST_F(CompareCommand, WritesAPage) {
  ASSERT_EQ(run("sample jacksboro -n 300 -o 'a<b.csv'").exit_code, 0);
  const Outcome outcome = run(
      "compare 'a<b.csv' --orders 0-4 --objective min-local-minima,min-max-angle -o report.html");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("report.html"), std::string::npos);
  const std::string page = content_of(directory_ / "report.html");
  EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
  EXPECT_TRUE(page.ends_with("</html>\n"));
  EXPECT_EQ(count_of(page, "<svg"), 2u);
  EXPECT_EQ(count_of(page, "<table>"), 3u);  // the summary's too
  EXPECT_EQ(count_of(page, "<circle"), 10u);
  EXPECT_EQ(count_of(page, "<tr>"), 14u);  // the summary leaves out what is folded
  EXPECT_LT(page.find("<div class=\"summary\">"), page.find("<svg"));
  EXPECT_NE(page.find("a&lt;b.csv"), std::string::npos);
  EXPECT_EQ(page.find("a<b.csv"), std::string::npos);
  for (const char* foreign : {"http", "<script", "<link", "nan", "inf<"})
    EXPECT_EQ(page.find(foreign), std::string::npos) << foreign;
}

TEST_F(CompareCommand, TheTitleIsNoPath) {
  ASSERT_EQ(shell("mkdir deep && HODT sample jacksboro -n 100 | gzip > deep/hills.v2.csv.gz && "
                  "HODT compare deep/hills.v2.csv.gz --orders 0 -o page.html")
                .exit_code,
            0);
  const std::string page = content_of(directory_ / "page.html");
  EXPECT_NE(page.find("<title>What higher orders gain: hills.v2</title>"), page.npos);
  EXPECT_EQ(page.find("deep/"), page.npos);
}

TEST_F(CompareCommand, FoldsWhatOneTriangleDecides) {
  // A lattice with a far point: the slivers towards it are the largest, and cannot go.
  std::string points = "x,y,z\n500,2,0\n";
  for (int i = 0; i < 36; ++i)
    points += std::to_string(i % 6) + "," + std::to_string(i / 6) + "," +
              std::to_string(i * 7 % 10) + "\n";
  put("points.csv", points);
  const std::string arguments =
      "points.csv --orders 0-2 --objective min-max-area,min-sum-angle,min-local-minima ";
  const Json objectives = compared(arguments)["objectives"];
  EXPECT_NE(std::string(objectives[0]["unchanged"]).find("at the outline"), std::string::npos);
  EXPECT_EQ(objectives[0]["rows"].size(), 3u);
  EXPECT_TRUE(objectives[1]["unchanged"].is_null());
  EXPECT_TRUE(objectives[2]["unchanged"].is_null());
  const Outcome outcome = run("compare " + arguments + "-o page.html");
  EXPECT_NE(outcome.out.find("min-max-area: 0 % at every order. A triangle at the outline"),
            std::string::npos)
      << outcome.out;
  EXPECT_EQ(count_of(outcome.out, "smallest angle"), 2u);
  const std::string page = content_of(directory_ / "page.html");
  EXPECT_EQ(count_of(page, "<details"), 1u);
  EXPECT_EQ(count_of(page, "<svg"), 3u);
  // Orders above 0 were not asked for.
  EXPECT_TRUE(
      compared("points.csv --orders 0 --objective min-max-area")["objectives"][0]["unchanged"]
          .is_null());
}

TEST_F(CompareCommand, TellsTheMeanOfAnglesAddedUp) {
  put("points.csv", "0,0,0\n4,0,1\n0,4,1\n4,4,5\n");
  const Json objectives = compared(
      "points.csv --orders 0 --objective min-sum-angle,min-sum-abn,min-sum-length")["objectives"];
  EXPECT_NEAR(objectives[0]["rows"][0]["value"], 180, 1e-9);
  EXPECT_NEAR(objectives[0]["rows"][0]["mean_angle"], 90, 1e-9);
  EXPECT_EQ(objectives[1]["rows"][0]["value"], objectives[1]["rows"][0]["mean_angle"]);
  EXPECT_TRUE(objectives[2]["rows"][0]["mean_angle"].is_null());
  const Outcome outcome =
      run("triangulate points.csv -o t.obj --objective max-sum-small-angle --json j.json");
  EXPECT_NE(outcome.out.find("mean angle    45.0000° -> 45.0000°"), std::string::npos)
      << outcome.out;
  EXPECT_NEAR(json("j.json")["mean"]["bound"], 45, 1e-9);
}

TEST_F(CompareCommand, TheSameOnAnyThreadCount) {
  sample();
  const auto without_seconds = [](Json comparison) {
    for (Json& objective : comparison["objectives"])
      for (Json& row : objective["rows"]) row.erase("seconds");
    return comparison;
  };
  EXPECT_EQ(without_seconds(compared("points.csv --objective all --orders 0-3 --threads 1")),
            without_seconds(compared("points.csv --objective all --orders 0-3 --threads 2")));
}

}  // namespace
}  // namespace hodt
