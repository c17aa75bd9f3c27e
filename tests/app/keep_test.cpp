// Real pits that stay.
#include <string>

#include "command_fixture.h"

namespace hodt::test {
namespace {

class KeepCommand : public CommandTest {
 protected:
  /// Local minima of the result, interior and boundary, and how many were kept.
  struct Counts {
    int before, after, kept, bound;
  };
  Counts counts(const std::string& options) const {
    const Outcome outcome = shell(
        "HODT sample jacksboro -n 2000 | HODT triangulate - -o t.obj -k 6 --json - " + options);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const Json report = Json::parse(outcome.out);
    return {report["value"]["delaunay"], report["value"]["result"], report["kept"],
            report["value"]["bound"]};
  }
};

TEST_F(KeepCommand, deep_pits_stay) {
  const Counts all = counts("");
  EXPECT_EQ(all.kept, 0);
  EXPECT_LT(all.after, all.before);
  const Counts deep = counts("--min-pit-depth 5");
  EXPECT_GT(deep.kept, 0);
  EXPECT_GE(deep.after, deep.kept);
  EXPECT_GE(deep.bound, deep.kept);
  EXPECT_GT(deep.after, all.after);
  EXPECT_LT(deep.after, deep.before);
  const Counts hardly_any = counts("--min-pit-depth 1e9");
  EXPECT_EQ(hardly_any.kept, 0);
  EXPECT_EQ(hardly_any.after, all.after);
}

TEST_F(KeepCommand, an_outline_keeps_all_in_it_and_a_point_its_pit) {
  ASSERT_EQ(shell("echo '{\"type\": \"Polygon\", \"coordinates\": [[[-1e9, -1e9], [1e9, -1e9], "
                  "[1e9, 1e9], [-1e9, 1e9], [-1e9, -1e9]]]}' > all.geojson && "
                  "HODT sample jacksboro -n 2000 | head -2 > one.csv")
                .exit_code,
            0);
  const Counts all = counts("--keep all.geojson");
  EXPECT_EQ(all.kept, all.before);
  EXPECT_EQ(all.after, all.before);
  EXPECT_EQ(counts("--keep one.csv").kept, 1);
}

/// 20 x 20 points with heights that make many pits; the lowest is in the middle.
std::string rough_terrain() {
  std::string csv = "x,y,z\n";
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 20; ++x)
      csv += std::to_string(600000 + 10 * x) + "," + std::to_string(200000 + 10 * y) + "," +
             std::to_string((x * 7 + y * 11 + x * y) % 13) + "\n";
  return csv;
}

std::string square(double x, double y, double size) {
  const auto corner = [](double cx, double cy) {
    return "[" + std::to_string(cx) + "," + std::to_string(cy) + "]";
  };
  return "[" + corner(x, y) + "," + corner(x + size, y) + "," + corner(x + size, y + size) + "," +
         corner(x, y + size) + "," + corner(x, y) + "]";
}

std::string feature(const std::string& rings) {
  return R"({"type": "Feature", "geometry": {"type": "Polygon", "coordinates": [)" + rings + "]}}";
}

std::string collection(const std::string& features) {
  return R"({"type": "FeatureCollection", "features": [)" + features + "]}";
}

TEST_F(KeepCommand, places_in_another_coordinate_system_are_refused) {
  put("p.csv", rough_terrain());
  put("degrees.geojson", collection(feature(square(7.4, 46.9, 0.1))));
  put("mixed.geojson",
      collection(feature(square(600000, 200000, 100)) + "," + feature(square(7.4, 46.9, 0.1))));
  put("far.csv", "600100,200100\n600100,199000\n");
  put("between.geojson", collection(feature(square(600001, 200001, 5))));
  const std::string command = "triangulate p.csv -o t.obj --keep ";
  expect_refused(command + "degrees.geojson", "feature 1 of degrees.geojson");
  expect_refused(command + "mixed.geojson", "feature 2 of mixed.geojson");
  expect_refused(command + "far.csv", "point 2 of far.csv");
  expect_refused(command + "between.geojson", "no point is in feature 1 of between.geojson");
  expect_refused("compare p.csv -o t.html --keep degrees.geojson", "feature 1 of degrees.geojson");
}

TEST_F(KeepCommand, what_is_kept_is_said_also_if_it_is_nothing) {
  put("p.csv", rough_terrain());
  put("lakes.geojson",
      collection(feature(square(599999, 199999, 102)) + "," + feature(square(600001, 200001, 5))));
  put("none.geojson", collection(""));
  const std::string command = "triangulate p.csv -o t.obj --json j.json ";
  const Outcome lakes = run(command + "--keep lakes.geojson");
  EXPECT_EQ(lakes.exit_code, 0) << lakes.err;
  EXPECT_NE(lakes.out.find("local minima; no point is in 1 polygon\n"), std::string::npos)
      << lakes.out;
  EXPECT_EQ(json("j.json")["polygons_without_points"], 1);
  EXPECT_GT(int(json("j.json")["kept"]), 0);
  for (const char* nothing : {"--keep none.geojson", "--min-pit-depth 1000"}) {
    const Outcome outcome = run(command + nothing);
    EXPECT_NE(outcome.out.find("kept          0 local minima\n"), std::string::npos) << outcome.out;
    EXPECT_EQ(json("j.json")["kept"], 0);
  }
  EXPECT_EQ(run(command).out.find("kept"), std::string::npos);
}

TEST_F(KeepCommand, what_is_in_a_hole_goes) {
  put("p.csv", rough_terrain());
  const std::string outline = square(599999, 199999, 300), hole = square(600035, 200035, 100);
  put("full.geojson", collection(feature(outline)));
  put("hole.geojson", collection(feature(outline + "," + hole)));
  put("inner.geojson", collection(feature(hole)));
  const auto kept = [&](const std::string& file) {
    EXPECT_EQ(run("triangulate p.csv -o t.obj --json j.json --keep " + file).exit_code, 0);
    return int(json("j.json")["kept"]);
  };
  EXPECT_GT(kept("inner.geojson"), 0);
  EXPECT_EQ(kept("full.geojson"), kept("hole.geojson") + kept("inner.geojson"));
}

TEST_F(KeepCommand, compare_keeps_what_triangulate_keeps) {
  put("p.csv", rough_terrain());
  put("lake.geojson", collection(feature(square(599999, 199999, 102))));
  const std::string options = " --keep lake.geojson --min-pit-depth 6";
  ASSERT_EQ(run("compare p.csv --orders 0,4 --objective min-local-minima,min-max-angle --json "
                "c.json" +
                options)
                .exit_code,
            0);
  ASSERT_EQ(run("triangulate p.csv -k 4 -o t.obj --json j.json" + options).exit_code, 0);
  const Json comparison = json("c.json"), report = json("j.json");
  EXPECT_GT(int(report["kept"]), 0);
  EXPECT_EQ(comparison["kept"], report["kept"]);
  const Json& row = comparison["objectives"][0]["rows"][1];
  EXPECT_EQ(row["value"], report["value"]["result"]);
  EXPECT_EQ(row["bound"], report["value"]["bound"]);
  EXPECT_EQ(run("compare p.csv").out.find("kept"), std::string::npos);
  expect_refused("compare p.csv --objective min-max-angle" + options, "min-local-minima");
  expect_refused("compare - --keep -", "both be standard input");
  expect_refused("compare p.csv --json lake.geojson --keep lake.geojson", "is the input");
}

TEST_F(KeepCommand, duplicates_of_other_heights_are_told) {
  put("p.csv", "0,0,5\n4,0,1\n0,4,2\n4,4,3\n0,0,5\n0,0,7.5\n4,0,0.25\n");
  const Outcome outcome = run("triangulate p.csv -o t.obj --json j.json");
  EXPECT_NE(
      outcome.out.find("7, 3 duplicates dropped; 2 are up to 2.5 higher than the one that stays\n"),
      std::string::npos)
      << outcome.out;
  const Json expected = {{"different", 2}, {"largest_difference", 2.5}};
  EXPECT_EQ(json("j.json")["duplicates"], 3);
  EXPECT_EQ(json("j.json")["duplicate_heights"], expected);
  ASSERT_EQ(run("compare p.csv --orders 0 --json c.json").exit_code, 0);
  EXPECT_EQ(json("c.json")["duplicate_heights"], expected);
  const Outcome info = run("info p.csv --json -");
  EXPECT_EQ(Json::parse(info.out)["duplicate_heights"], expected);
  EXPECT_EQ(Json::parse(info.out)["duplicates"], 3);
  EXPECT_NE(run("info p.csv").out.find("2 are up to 2.5 higher"), std::string::npos);
  put("same.csv", "0,0,5\n4,0,1\n0,4,2\n0,0,5\n");
  EXPECT_EQ(run("triangulate same.csv -o t.obj").out.find("higher"), std::string::npos);
  put("flat.csv", "0,0\n4,0\n0,4\n0,0\n");
  ASSERT_EQ(run("triangulate flat.csv -o t.obj --objective none --json j.json").exit_code, 0);
  EXPECT_TRUE(json("j.json")["duplicate_heights"].is_null());
}

TEST_F(KeepCommand, errors_say_what_is_wrong) {
  ASSERT_EQ(shell("echo nonsense > bad.geojson; echo '{\"type\": \"LineString\"}' > line.geojson; "
                  "HODT sample jacksboro -n 100 > p.csv")
                .exit_code,
            0);
  expect_refused("triangulate p.csv -o t.obj --keep bad.geojson", "no GeoJSON");
  expect_refused("triangulate p.csv -o t.obj --keep line.geojson", "LineString");
  expect_refused("triangulate - -o t.obj --keep -", "both be standard input");
  expect_refused("triangulate p.csv -o t.obj --keep none.geojson", "none.geojson");
  expect_refused("triangulate p.csv -o t.obj --keep p.csv --json p.csv", "p.csv is the input");
  expect_refused("triangulate p.csv -o t.obj --min-pit-depth deep", "--min-pit-depth");
  expect_refused("triangulate p.csv -o t.obj --min-pit-depth 1 --objective min-max-angle",
                 "min-max-angle");
}

}  // namespace
}  // namespace hodt::test
