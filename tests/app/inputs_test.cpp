// Several inputs, their coordinate systems, and heights of duplicates: what --help promises.
#include <string>

#include "command_fixture.h"
#include <gtest/gtest.h>

#include "hodt/io/formats.h"

namespace hodt::test {
namespace {

class InputsTest : public CommandTest {
 protected:
  void SetUp() override {
    put("a.csv", "x,y,z\n0,0,1\n4,0,2\n0,4,3\n");
    put("b.csv", "y,x,z\n4,4,4\n2,2,5\n");
    put("mesh.ply", "");
  }

  /// A layer of points or lines, by GDAL's program; false where it is missing.
  bool layer(const std::string& file, const std::string& table, const std::string& more) const {
    if (!has_gdal()) return false;
    put("table.csv", table);
    return shell("ogr2ogr -append " + file +
                 " table.csv -oo GEOM_POSSIBLE_NAMES=wkt -oo KEEP_GEOM_COLUMNS=NO " + more)
               .exit_code == 0;
  }
};

constexpr const char* kSquare =
    "wkt,n\n\"POINT Z (0 0 1)\",0\n\"POINT Z (4 0 2)\",0\n\"POINT Z (0 4 3)\",0\n\"POINT Z (4 4 "
    "4)\",0\n";

TEST_F(InputsTest, FilesAreTakenTogether) {
  put("whole.csv", "x,y,z\n0,0,1\n4,0,2\n0,4,3\n4,4,4\n2,2,5\n");
  ASSERT_EQ(run("triangulate a.csv b.csv -o parts.ply --json parts.json").exit_code, 0);
  ASSERT_EQ(run("triangulate whole.csv -o whole.ply --json whole.json").exit_code, 0);
  EXPECT_EQ(content_of(directory_ / "parts.ply"), content_of(directory_ / "whole.ply"));
  const Json parts = json("parts.json"), whole = json("whole.json");
  EXPECT_EQ(parts["points"], 5);
  EXPECT_EQ(parts["files"], 2);
  EXPECT_EQ(parts["columns"].size(), 2u);
  EXPECT_EQ(parts["columns"][1]["file"], "b.csv");
  EXPECT_EQ(parts["columns"][1]["points"], 2);
  EXPECT_EQ(parts["columns"][1]["columns"]["x"]["number"], 2);
  EXPECT_EQ(whole["files"], 1);
  EXPECT_EQ(whole["columns"]["x"]["number"], 1);
  EXPECT_TRUE(whole["crs"].is_null());
  for (const std::string command : {"edges", "triangles", "voronoi -m 1"}) {
    ASSERT_EQ(run(command + " a.csv b.csv -o parts.csv").exit_code, 0) << command;
    ASSERT_EQ(run(command + " whole.csv -o whole.out").exit_code, 0) << command;
    EXPECT_EQ(content_of(directory_ / "parts.csv"), content_of(directory_ / "whole.out"))
        << command;
  }
  const Outcome info = run("info a.csv b.csv");
  EXPECT_NE(info.out.find("files   2\n"), std::string::npos) << info.out;
  EXPECT_NE(info.out.find("columns b.csv: x = column 2 'x'"), std::string::npos) << info.out;
  EXPECT_NE(run("compare a.csv b.csv --orders 0-1").out.find("files     2\n"), std::string::npos);
}

TEST_F(InputsTest, FilesThatDoNotGoTogetherAreRefused) {
  put("flat.csv", "x,y\n1,2\n");
  expect_refused("triangulate a.csv flat.csv -o o.ply", "flat.csv has no heights, unlike a.csv");
  expect_refused("triangulate a.csv - -o o.ply", "standard input cannot be one of several files");
  expect_refused("triangulate a.csv mesh.ply -o o.ply", "mesh.ply is a mesh");
  expect_refused("triangulate a.csv b.csv -o b.csv.ply --json b.csv", "b.csv is the input");
  put("line.csv", "x,y,z\n1,1,1\n2,2,2\n");
  expect_refused("triangulate line.csv line.csv line.csv -o o.ply", "line.csv and 2 more files: ");
}

TEST_F(InputsTest, HeightsOfDuplicatesAreChosen) {
  put("d.csv", "x,y,z\n0,0,1\n4,0,2\n0,4,3\n4,0,6\n4,0,1\n");
  const struct {
    const char *rule, *row, *text;
    double height, largest;
  } rules[] = {{"lowest", "4 0 1", "2 are up to 5 higher than the one that stays", 1, 5},
               {"highest", "4 0 6", "2 are up to 5 lower than the one that stays", 6, 5},
               {"mean", "4 0 3", "3 are up to 3 from the mean, which stays", 3, 3},
               {"first", "4 0 2", "2 are up to 4 from the first, which stays", 2, 4}};
  for (const auto& rule : rules) {
    const std::string option = std::string(" --duplicates ") + rule.rule;
    const Outcome outcome = run("triangulate d.csv -o d.obj --json d.json" + option);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(content_of(directory_ / "d.obj").find(std::string("v ") + rule.row + "\n"),
              std::string::npos)
        << rule.rule;
    EXPECT_NE(outcome.out.find(std::string("2 duplicates dropped; ") + rule.text),
              std::string::npos)
        << outcome.out;
    EXPECT_EQ(json("d.json")["duplicate_rule"], rule.rule);
    EXPECT_EQ(json("d.json")["duplicate_heights"]["largest_difference"], rule.largest);
    EXPECT_NE(run("info d.csv" + option).out.find(rule.text), std::string::npos);
    EXPECT_NE(run("compare d.csv --orders 0" + option).out.find(rule.text), std::string::npos);
  }
  expect_refused("triangulate d.csv -o o.ply --duplicates error",
                 "d.csv: points 1 and 3 (counted from 0) have the same x and y");
  expect_refused("triangulate d.csv -o o.ply --duplicates median",
                 "--duplicates must be lowest, highest, mean, first or error, not 'median'");
}

TEST_F(InputsTest, TheCoordinateSystemIsKept) {
  ASSERT_EQ(run("triangulate a.csv -o a.ply --crs epsg:25832 --json a.json").exit_code, 0);
  EXPECT_NE(content_of(directory_ / "a.ply").find("comment crs: EPSG:25832\n"), std::string::npos);
  EXPECT_EQ(json("a.json")["crs"], "EPSG:25832");
  const Outcome again = run("triangulate a.ply -o again.obj --json again.json");
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_NE(content_of(directory_ / "again.obj").find("# crs: EPSG:25832\n"), std::string::npos);
  EXPECT_EQ(json("again.json")["crs"], "EPSG:25832");
  EXPECT_NE(again.out.find("crs           EPSG:25832"), std::string::npos) << again.out;
  expect_refused("triangulate a.csv -o o.ply --crs 25832", "like EPSG:25832, not '25832'");
  ASSERT_EQ(run("triangulate again.obj -o other.ply --crs EPSG:25833").exit_code, 0);
  EXPECT_NE(content_of(directory_ / "other.ply").find("crs: EPSG:25833\n"), std::string::npos);
}

TEST_F(InputsTest, LinesOfAnotherCoordinateSystemAreRefused) {
  const auto roads = [](const char* code) {
    std::string text = R"({"type": "FeatureCollection", "crs": {"type": "name", "properties":
        {"name": "urn:ogc:def:crs:EPSG::CODE"}}, "features": [{"type": "Feature", "properties": {},
        "geometry": {"type": "LineString", "coordinates": [[0, 0], [4, 4]]}}]})";
    return text.replace(text.find("CODE"), 4, code);
  };
  put("roads.geojson", roads("25833"));
  put("plain.geojson", R"({"type": "LineString", "coordinates": [[0, 0], [4, 4]]})");
  put("ring.geojson", R"({"crs": {"type": "name", "properties": {"name": "EPSG:25833"}},
      "type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 4], [0, 0]]]})");
  const std::string points = "triangulate a.csv b.csv -o o.ply --crs EPSG:25832";
  for (const std::string option :
       {"--breaklines roads", "--keep-edges roads", "--outline ring", "--keep ring"}) {
    const Outcome outcome = run(points + " " + option + ".geojson");
    EXPECT_EQ(outcome.exit_code, 2) << option;
    EXPECT_NE(outcome.err.find("a.csv and 1 more file is in EPSG:25832"), std::string::npos)
        << outcome.err;
    EXPECT_NE(outcome.err.find(".geojson in EPSG:25833"), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(run(points + " --breaklines plain.geojson").exit_code, 0);
  put("same.geojson", roads("25832"));
  EXPECT_EQ(run(points + " --breaklines same.geojson").exit_code, 0);
  EXPECT_EQ(run("triangulate a.csv b.csv -o o.ply --breaklines roads.geojson").exit_code, 0)
      << "of the points it is unknown";
}

TEST_F(InputsTest, LayersAndRastersComeInWithTheirSystem) {
  if (!layer("p.gpkg", kSquare, "-nln p -a_srs EPSG:25832")) GTEST_SKIP() << "no GDAL";
  put("grid.asc", "ncols 2\nnrows 1\nxllcorner 10\nyllcorner 0\ncellsize 1\n5 6\n");
  ASSERT_EQ(shell("gdal_translate -a_srs EPSG:25832 grid.asc grid.tif").exit_code, 0);
  const Outcome both = run("triangulate p.gpkg grid.tif -o both.ply --json both.json");
  ASSERT_EQ(both.exit_code, 0) << both.err;
  EXPECT_EQ(both.err, "");
  EXPECT_EQ(json("both.json")["points"], 6);
  EXPECT_EQ(json("both.json")["crs"], "EPSG:25832");
  EXPECT_EQ(json("both.json")["columns"][1]["columns"]["source"],
            "centres of cells, z = band 1 of 1");
  EXPECT_NE(both.out.find("crs           EPSG:25832 (ETRS89 / UTM zone 32N)\n"), std::string::npos);

  ASSERT_EQ(shell("gdal_translate -a_srs EPSG:25833 grid.asc other.tif").exit_code, 0);
  expect_refused("triangulate p.gpkg other.tif -o o.ply",
                 "p.gpkg is in EPSG:25832 (ETRS89 / UTM zone 32N), and other.tif in EPSG:25833");
  expect_refused("triangulate p.gpkg other.tif -o o.ply --crs EPSG:25832",
                 "other.tif in EPSG:25833");
  expect_refused("triangulate p.gpkg a.csv -o o.ply",
                 "of a.csv the coordinate reference system is unknown");
  EXPECT_EQ(run("triangulate p.gpkg a.csv -o o.ply --crs EPSG:25832").exit_code, 0);

  ASSERT_TRUE(
      layer("roads.gpkg", "wkt,n\n\"LINESTRING (0 0,4 4)\",0\n", "-nln paved -a_srs EPSG:25832"));
  ASSERT_TRUE(
      layer("roads.gpkg", "wkt,n\n\"LINESTRING (9 9,9 8)\",0\n", "-nln other -a_srs EPSG:31467"));
  const std::string lines = "triangulate p.gpkg -o o.ply --breaklines ";
  EXPECT_EQ(run(lines + "'roads.gpkg|layername=paved'").exit_code, 0);
  expect_refused(lines + "roads.gpkg", "has 2 layers: 'paved', 'other'");
  expect_refused(lines + "'roads.gpkg|layername=other'", "roads.gpkg in EPSG:31467");
}

TEST_F(InputsTest, SystemsAreComparedWithTheOneThatTellsMost) {
  if (!layer("v0.gpkg", kSquare, "-nln p -a_srs EPSG:25832")) GTEST_SKIP() << "no GDAL";
  ASSERT_TRUE(layer("v1.gpkg", kSquare, "-nln p -a_srs EPSG:25832+7837"));
  ASSERT_TRUE(layer("v2.gpkg", kSquare, "-nln p -a_srs EPSG:25832+5783"));
  const std::string line = "wkt,n\n\"LINESTRING Z (0 0 1,4 4 4)\",0\n";
  ASSERT_TRUE(layer("l1.gpkg", line, "-nln l -a_srs EPSG:25832+7837"));
  ASSERT_TRUE(layer("l2.gpkg", line, "-nln l -a_srs EPSG:25832+5783"));
  const std::string message = "1.gpkg is in ETRS89 / UTM zone 32N + DHHN2016 height, and ";
  for (const std::string files : {"v0 v1 v2", "v1 v0 v2", "v1 v2 v0"}) {
    std::string named = files + " ";
    for (std::size_t at = 0; (at = named.find(' ', at)) != named.npos; at += 6)
      named.insert(at, ".gpkg");
    expect_refused("triangulate " + named + "-o o.ply", message);
    expect_refused("info " + named, message);
  }
  EXPECT_EQ(run("triangulate v0.gpkg v1.gpkg v0.gpkg -o o.ply").exit_code, 0);
  for (const std::string points : {"v0.gpkg", "v0.gpkg v1.gpkg", "a.csv b.csv"})
    expect_refused("triangulate " + points + " -o p.ply --breaklines l1.gpkg --breaklines l2.gpkg",
                   message);
  EXPECT_EQ(run("triangulate v0.gpkg v1.gpkg -o o.ply --breaklines l1.gpkg").exit_code, 0);
  expect_refused("triangulate v0.gpkg v1.gpkg -o p.ply --breaklines l2.gpkg", message);
  expect_refused("compare v0.gpkg v1.gpkg --orders 1 --truth v2.gpkg", message);
}

/// A raster of two rows in a system, whose band may tell its unit.
std::string raster_of(const std::string& system, const std::string& unit) {
  return "<VRTDataset rasterXSize=\"2\" rasterYSize=\"2\"><SRS>" + system +
         "</SRS><GeoTransform>0, 1, 0, 4, 0, -1</GeoTransform><VRTRasterBand "
         "dataType=\"Float64\" band=\"1\"><UnitType>" +
         unit +
         "</UnitType><SimpleSource><SourceFilename relativeToVRT=\"1\">grid.asc</SourceFilename>"
         "</SimpleSource></VRTRasterBand></VRTDataset>";
}

TEST_F(InputsTest, HeightsInDifferentUnitsAreRefused) {
  if (!layer("lines.gpkg", "wkt,n\n\"LINESTRING Z (0.5 2.5 1,1.5 3.5 4)\",0\n",
             "-nln l -a_srs EPSG:25832+7837"))
    GTEST_SKIP() << "no GDAL";
  put("grid.asc", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 2\ncellsize 1\n5 6\n7 9\n");
  put("m.vrt", raster_of("EPSG:25832", "metre"));
  put("also_m.vrt", raster_of("EPSG:25832", "m"));
  put("ft.vrt", raster_of("EPSG:25832", "ft"));
  put("us_ft.vrt", raster_of("EPSG:25832", "US survey foot"));
  put("unknown.vrt", raster_of("EPSG:25832", ""));
  put("unknown_ft.vrt", raster_of("", "ft"));
  put("unknown_m.vrt", raster_of("", "m"));
  expect_refused("triangulate m.vrt ft.vrt -o o.ply",
                 "m.vrt has heights in metre, and ft.vrt in ft; bring them to one unit");
  expect_refused("triangulate unknown.vrt us_ft.vrt m.vrt -o o.ply",
                 "us_ft.vrt has heights in US survey foot, and m.vrt in metre");
  expect_refused("triangulate unknown_ft.vrt unknown_m.vrt -o o.ply", "in ft, and ");
  expect_refused("triangulate m.vrt ft.vrt -o o.ply --crs EPSG:25832", "in ft");
  expect_refused("triangulate ft.vrt -o o.ply --breaklines lines.gpkg",
                 "ft.vrt has heights in ft, and lines.gpkg in m");
  expect_refused("edges ft.vrt -k 1 -o o.csv --breaklines lines.gpkg", "lines.gpkg in m");
  expect_refused("compare m.vrt --orders 1 --truth ft.vrt",
                 "m.vrt has heights in metre, and ft.vrt in ft");
  expect_refused("compare m.vrt --orders 1 --breaklines lines.gpkg --truth ft.vrt", "ft.vrt in ft");
  for (const std::string command :
       {"info m.vrt also_m.vrt", "info m.vrt unknown.vrt", "info ft.vrt us_ft.vrt",
        "triangulate m.vrt -o o.ply --breaklines lines.gpkg",
        "compare m.vrt --orders 1 --truth also_m.vrt"}) {
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.exit_code, 0) << command << ": " << outcome.err;
  }
}

TEST_F(InputsTest, DegreesGetOneWarningThatNamesTheRemedy) {
  if (!layer("p.gpkg", kSquare, "-nln p -a_srs EPSG:4326")) GTEST_SKIP() << "no GDAL";
  const Outcome outcome = run("triangulate p.gpkg -o o.ply");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(outcome.err.starts_with("hodt: warning: p.gpkg: x and y are degrees (WGS 84)"))
      << outcome.err;
  EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
  EXPECT_NE(run("info p.gpkg").out.find("hint    x and y are degrees"), std::string::npos);
  EXPECT_EQ(run("triangulate p.gpkg -o o.ply --crs EPSG:25832").err, "");
  EXPECT_NE(run("triangulate a.csv -o o.ply --crs EPSG:4326").err.find("degrees"),
            std::string::npos);
}

TEST_F(InputsTest, DegreesByTheNamesOfColumnsGetTheWarning) {
  put("d.csv", "id,lat,lon,height\n1,48,11,5\n2,48.1,11,6\n3,48,11.1,7\n");
  const std::string message = "d.csv: x and y are degrees (longitude and latitude, by the names";
  const Outcome outcome = run("triangulate d.csv -o o.ply");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
  EXPECT_NE(run("triangulate d.csv -o o.ply --columns x=lon,y=lat").err.find(message),
            std::string::npos);
  EXPECT_EQ(run("triangulate d.csv -o o.ply --crs EPSG:25832").err, "");
  if (has_gdal()) {
    const std::string known = run("triangulate d.csv -o o.ply --crs EPSG:4326").err;
    EXPECT_NE(known.find("x and y are degrees (WGS 84)"), std::string::npos) << known;
    EXPECT_EQ(known.find('\n'), known.size() - 1) << known;
  }
  EXPECT_EQ(run("triangulate a.csv b.csv -o o.ply").err, "");
}

TEST_F(InputsTest, ThreeDimensionalDegreesBecomeARaster) {
  if (!has_gdal()) GTEST_SKIP() << "built without GDAL";
  put("g.geojson",
      R"({"type": "MultiPoint", "coordinates": [[11, 48, 4], [11.01, 48, 5], [11, 48.01, 6]]})");
  const Outcome outcome = run("triangulate g.geojson -o x.tif --resolution 0.001");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Outcome info = run("info x.tif");
  EXPECT_NE(info.out.find("EPSG:4979 (WGS 84)"), std::string::npos) << info.out;
}

TEST_F(InputsTest, TruthThatIsElsewhereIsTold) {
  put("far.csv", "x,y,z\n100,100,1\n101,100,2\n");
  put("near.csv", "x,y,z\n100,100,1\n1,1,2\n");
  const std::string hint = "far.csv: of its 2 points none is within the triangulation";
  const Outcome far = run("compare a.csv b.csv --orders 1 --truth far.csv");
  EXPECT_NE(far.err.find(hint), std::string::npos) << far.err;
  EXPECT_EQ(run("compare a.csv b.csv --orders 1 --truth near.csv").err, "");
}

TEST_F(InputsTest, LabelsOfDrawingsAreToldWhereverTheyAreLeftOut) {
  if (!has_gdal()) GTEST_SKIP() << "built without GDAL";
  const std::string text = "0\nTEXT\n8\nL\n10\n1\n20\n1\n30\n0\n40\n1\n1\n412.5\n";
  const auto drawing = [&](const std::string& entity) {
    return "0\nSECTION\n2\nENTITIES\n" + text + entity + "0\nENDSEC\n0\nEOF\n";
  };
  put("lines.dxf", drawing("0\nLINE\n8\nL\n10\n0\n20\n0\n30\n1\n11\n4\n21\n0\n31\n2\n"));
  put("keep.dxf", drawing("0\nPOINT\n8\nL\n10\n4\n20\n0\n30\n2\n"));
  const std::string lines = "lines.dxf: 1 label of the drawing is left out";
  const std::string keep = "keep.dxf: 1 label of the drawing is left out";
  for (const std::string command :
       {"triangulate a.csv b.csv -o o.ply --keep keep.dxf", "edges a.csv b.csv -k 1 -o o.csv",
        "compare a.csv b.csv --orders 1 --keep keep.dxf"}) {
    const Outcome outcome = run(command + " --breaklines lines.dxf");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find(lines), std::string::npos) << command << ": " << outcome.err;
    const bool keeps = command.ends_with("keep.dxf");
    EXPECT_EQ(outcome.err.find(keep) != std::string::npos, keeps) << command << ": " << outcome.err;
  }
}

TEST_F(InputsTest, OptionsOfOtherFilesAreRefused) {
  expect_refused("triangulate a.csv -o o.ply --layer p", "are for files of map features");
  expect_refused("triangulate a.csv -o o.ply --stride 2", "are for rasters");
  expect_refused("triangulate a.csv -o o.ply --stride 0", "--stride must be a whole number from 1");
  ASSERT_EQ(run("triangulate a.csv -o a.ply").exit_code, 0);
  expect_refused("triangulate a.ply -o o.ply --vertices", "a.ply is a mesh");
}

}  // namespace
}  // namespace hodt::test
