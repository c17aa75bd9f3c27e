#include <array>
#include <bit>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "gdal_files.h"
#include <gtest/gtest.h>

#include "hodt/base/error.h"
#include "hodt/geometry/point.h"
#include "hodt/io/atomic_write.h"
#include "hodt/io/crs.h"
#include "hodt/io/line_file.h"
#include "hodt/io/places_file.h"
#include "hodt/io/point_file.h"
#include "hodt/io/raster_file.h"
#include "hodt/io/tin_file.h"

namespace hodt {
namespace {

using test::message_of;

struct Spot {
  double x, y, z;
  bool operator==(const Spot&) const = default;
};

std::vector<Spot> spots(const PointSet& points) {
  std::vector<Spot> all;
  for (std::size_t i = 0; i < points.size(); ++i)
    all.push_back({points.xy[i].x, points.xy[i].y, points.has_heights() ? points.z[i] : 0});
  return all;
}

template <class Number>
std::string bytes_of(Number value) {
  const auto raw = std::bit_cast<std::array<char, sizeof value>>(value);
  return {raw.data(), raw.size()};
}

PointChoice of_layer(LayerChoice choice) {
  return {.layer = std::move(choice)};
}
PointChoice of_raster(Index band, Index stride) {
  return {.raster = {band, stride}};
}

class GdalTest : public test::GdalFiles {
 protected:
  std::vector<Spot> read(const std::string& file, const PointChoice& choice = {}) const {
    return spots(read_points(directory_ / file, choice));
  }
  template <class Error>
  void expect_refused(const std::string& file, const PointChoice& choice,
                      const std::string& message) const {
    const std::string error = message_of<Error>([&] { read_points(directory_ / file, choice); });
    EXPECT_NE(error.find(message), std::string::npos) << error;
    EXPECT_NE(error.find(file), std::string::npos) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  }
};

// Numbers whose last bits show any rounding.
constexpr const char* kTable =
    "wkt,id,Höhe m,name\n"
    "\"POINT Z (691000.1 5334000.3 451.70000000000005)\",1,1.1,a\n"
    "\"POINT Z (691001.1 5334001.3 -0.30000000000000004)\",2,2.2,b\n"
    "\"POINT Z (0.1 1e-300 1e19)\",3,3.3,c\n";
const std::vector<Spot> kSpots = {{691000.1, 5334000.3, 451.70000000000005},
                                  {691001.1, 5334001.3, -0.30000000000000004},
                                  {0.1, 1e-300, 1e19}};

TEST_F(GdalTest, PointsOfEveryFormatOfFeaturesAreTheSameBits) {
  const struct {
    const char *format, *file, *options;
  } formats[] = {{"GPKG", "p.gpkg", ""},
                 {"ESRI Shapefile", "p.shp", ""},
                 {"FlatGeobuf", "p.fgb", " -lco SPATIAL_INDEX=NO"},  // in the order of the table
                 {"SQLite", "p.sqlite", ""}};
  for (const auto& [format, file, options] : formats) {
    layer(format, file, "p", kTable, std::string("-a_srs EPSG:25832 -dim XYZ") + options);
    const PointTable table = read_point_table(directory_ / file);
    EXPECT_EQ(spots(table.points), kSpots) << file;
    EXPECT_EQ(table.points.crs, "EPSG:25832") << file;
    EXPECT_EQ(table.columns.source, "x, y and z of the points of layer 'p'") << file;
    EXPECT_TRUE(table.warnings.empty()) << file;
  }
}

TEST_F(GdalTest, PointsOfGeoJsonAreTheSameBits) {
  const std::string text =
      R"({"type": "FeatureCollection", "features": [
      {"type": "Feature", "properties": {"h": 5},
       "geometry": {"type": "Point", "coordinates": [11.1, 48.3, 451.70000000000005]}},
      {"type": "Feature", "properties": {"h": 6},
       "geometry": {"type": "MultiPoint", "coordinates": [[11.2, 48.4, 0.1], [11.3, 48.5, 0.2]]}}
      ]})";
  const std::vector<Spot> expected = {
      {11.1, 48.3, 451.70000000000005}, {11.2, 48.4, 0.1}, {11.3, 48.5, 0.2}};
  directory_.file("p.geojson", text);
  directory_.file("p.json", text);
  shell("gzip -k p.geojson");
  for (const char* file : {"p.geojson", "p.json", "p.geojson.gz"}) {
    const PointSet points = read_points(directory_ / file);
    EXPECT_EQ(spots(points), expected) << file;
    EXPECT_EQ(points.crs, "EPSG:4326") << file;
  }
}

TEST_F(GdalTest, GeoJsonThatIsNoDegreesIsOfAnUnknownSystem) {
  directory_.file("p.geojson", R"({"type": "Point", "coordinates": [691000, 5334000, 4]})");
  const PointTable table = read_point_table(directory_ / "p.geojson");
  EXPECT_EQ(table.points.crs, "");
  ASSERT_EQ(table.warnings.size(), 1u);
  EXPECT_NE(table.warnings[0].find("--crs"), std::string::npos);

  directory_.file("q.geojson",
                  R"({"type": "FeatureCollection", "crs": {"type": "name", "properties":
                      {"name": "urn:ogc:def:crs:EPSG::25832"}}, "features": [{"type": "Feature",
                      "properties": {}, "geometry": {"type": "Point",
                      "coordinates": [691000, 5334000, 4]}}]})");
  EXPECT_EQ(read_points(directory_ / "q.geojson").crs, "EPSG:25832");
}

TEST_F(GdalTest, GeoJsonWhoseSystemIsNotUnderstoodIsNotTakenForDegrees) {
  const auto table_with = [&](const std::string& crs) {
    directory_.file("c.geojson", R"({"type": "FeatureCollection", "crs": )" + crs +
                                     R"(, "features": [{"type": "Feature", "properties": {"crs": 1},
        "geometry": {"type": "Point", "coordinates": [11, 48, 4]}}]})");
    return read_point_table(directory_ / "c.geojson");
  };
  const auto name = [](const std::string& text) {
    return R"({"type": "name", "properties": {"name": ")" + text + "\"}}";
  };
  EXPECT_EQ(table_with("null").points.crs, "");
  EXPECT_TRUE(table_with("null").warnings.empty()) << "that is how one says so";
  for (const std::string& crs :
       {name("urn:ogc:def:crs:EPSG::99999999"), name("ours"), name("http://example.invalid/crs"),
        std::string(R"("EPSG:4326")"),
        std::string(R"({"type": "link", "properties": {"href": "a"}})"), std::string("{}")}) {
    const PointTable table = table_with(crs);
    EXPECT_EQ(table.points.crs, "") << crs;
    ASSERT_EQ(table.warnings.size(), 1u) << crs;
    EXPECT_TRUE(table.warnings[0].starts_with("its member crs, ")) << table.warnings[0];
  }
  for (const char* world :
       {"urn:ogc:def:crs:OGC:1.3:CRS84", "urn:ogc:def:crs:EPSG::4326", "EPSG:4326",
        "urn:ogc:def:crs:OGC::CRS84", "http://www.opengis.net/def/crs/OGC/1.3/CRS84"}) {
    const PointTable table = table_with(name(world));
    EXPECT_TRUE(is_same_crs(table.points.crs, "EPSG:4326")) << world;
    EXPECT_TRUE(table.warnings.empty()) << world << table.warnings[0];
  }
  directory_.file("plain.geojson",
                  R"({"type": "Point", "coordinates": [11, 48, 4], "b": "\"crs\""})");
  EXPECT_EQ(read_points(directory_ / "plain.geojson").crs, "EPSG:4979");
}

TEST_F(GdalTest, LinesOfGeoJsonMayBeNoDegreesEither) {
  const std::string feature = R"({"type": "Feature", "properties": {}, "geometry":
      {"type": "Point", "coordinates": [X, 5334000, 4]}})";
  std::string text;
  for (const char* x : {"691000", "691001"}) {
    std::string line = feature;
    line.erase(line.find('\n'), 1).replace(line.find('X'), 1, x);
    text += line + "\n";
  }
  directory_.file("p.geojson", text);
  const PointTable table = read_point_table(directory_ / "p.geojson");
  EXPECT_EQ(table.points.size(), 2u);
  EXPECT_EQ(table.points.crs, "");
  ASSERT_EQ(table.warnings.size(), 1u);
  EXPECT_NE(table.warnings[0].find("these are no degrees"), std::string::npos);
}

/// An entity of a DXF drawing at a place; `more` are further lines of its text.
std::string entity(const std::string& type, const std::string& x, const std::string& y,
                   const std::string& z, const std::string& more = "") {
  return "0\n" + type + "\n8\nL\n10\n" + x + "\n20\n" + y + "\n30\n" + z + "\n" + more;
}
std::string drawing(const std::string& entities) {
  return "0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n";
}
const std::string kLabels = entity("TEXT", "5", "5", "0", "40\n1\n1\n412.5\n") +
                            entity("MTEXT", "5", "6", "0", "40\n1\n1\nspring\n") +
                            entity("TEXT", "5", "7", "0", "100\nAcDbText\n40\n1\n1\n\n");

TEST_F(GdalTest, LabelsOfDrawingsAreNoPoints) {
  const std::string points = entity("POINT", "0", "0", "1") + entity("POINT", "10", "0", "2");
  directory_.file("p.dxf", drawing(points + kLabels + entity("POINT", "0", "10", "3")));
  const PointTable table = read_point_table(directory_ / "p.dxf");
  EXPECT_EQ(spots(table.points), (std::vector<Spot>{{0, 0, 1}, {10, 0, 2}, {0, 10, 3}}));
  EXPECT_EQ(table.warnings, std::vector<std::string>({"3 labels of the drawing are left out"}));
  directory_.file("q.dxf", drawing(points + entity("TEXT", "1", "1", "0", "1\nx\n")));
  EXPECT_EQ(read_point_table(directory_ / "q.dxf").warnings,
            std::vector<std::string>({"1 label of the drawing is left out"}));
  directory_.file("r.dxf", drawing(points));
  EXPECT_TRUE(read_point_table(directory_ / "r.dxf").warnings.empty());
}

TEST_F(GdalTest, AttributesOfBlocksAreNoPoints) {
  const std::string attribute =
      "0\nATTRIB\n100\nAcDbEntity\n8\nL\n100\nAcDbText\n10\n1\n20\n1\n30\n0\n40\n1\n1\n44.5\n"
      "100\nAcDbAttribute\n2\nTAG\n70\n0\n0\nSEQEND\n8\nL\n";
  directory_.file("p.dxf",
                  "0\nSECTION\n2\nHEADER\n0\nENDSEC\n0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n8\nL\n2\nSPOT"
                  "\n10\n0\n20\n0\n30\n0\n" +
                      entity("POINT", "0", "0", "0") + "0\nENDBLK\n0\nENDSEC\n" +
                      drawing(entity("INSERT", "7", "8", "9", "2\nSPOT\n66\n1\n") + attribute));
  const PointTable table = read_point_table(directory_ / "p.dxf");
  EXPECT_EQ(spots(table.points), (std::vector<Spot>{{7, 8, 9}}));
  EXPECT_EQ(table.warnings, std::vector<std::string>({"1 label of the drawing is left out"}));
}

TEST_F(GdalTest, LabelsOfDrawingsAreNoLinesAndNoPlaces) {
  directory_.file("lines.dxf",
                  drawing(kLabels + entity("LINE", "0", "0", "1", "11\n4\n21\n5\n31\n2\n")));
  const Lines lines = read_lines(directory_ / "lines.dxf");
  ASSERT_EQ(lines.lines.size(), 1u);
  EXPECT_EQ(lines.lines[0].xy, (std::vector<Point>{{0, 0}, {4, 5}}));
  EXPECT_EQ(lines.warnings, std::vector<std::string>({"3 labels of the drawing are left out"}));
  directory_.file("places.dxf", drawing(kLabels + entity("POINT", "1", "2", "3")));
  const Places places = read_places(directory_ / "places.dxf");
  EXPECT_EQ(places.points, (std::vector<Point>{{1, 2}}));
  EXPECT_EQ(places.warnings, std::vector<std::string>({"3 labels of the drawing are left out"}));
}

TEST_F(GdalTest, LayersMayNotKnowTheirSystem) {
  for (const char* format : {"GPKG", "ESRI Shapefile", "FlatGeobuf"}) {
    const std::string file = std::string("p.") + (format[0] == 'G'   ? "gpkg"
                                                  : format[0] == 'E' ? "shp"
                                                                     : "fgb");
    layer(format, file, "p", kTable, "-dim XYZ");
    EXPECT_EQ(read_points(directory_ / file).crs, "") << format;
  }
}

TEST_F(GdalTest, HeightsOfAFieldCount) {
  layer("GPKG", "p.gpkg", "p", kTable);
  EXPECT_EQ(read("p.gpkg", of_layer({.z_field = "Höhe m"})),
            (std::vector<Spot>{
                {691000.1, 5334000.3, 1.1}, {691001.1, 5334001.3, 2.2}, {0.1, 1e-300, 3.3}}));
  EXPECT_EQ(read("p.gpkg", of_layer({.z_field = "id"}))[2].z, 3);
  expect_refused<ParameterError>("p.gpkg", of_layer({.z_field = "z"}),
                                 "has no field 'z'; its fields are 'id', 'Höhe m', 'name'");
  expect_refused<ParameterError>("p.gpkg", of_layer({.z_field = "name"}), "no field of numbers");
}

TEST_F(GdalTest, FlatPointsNeedAFieldOrAWord) {
  layer("GPKG", "flat.gpkg", "p", "wkt,h\n\"POINT (1 2)\",7.5\n\"POINT (3 4)\",8.5\n");
  expect_refused<InputError>("flat.gpkg", {}, "feature 1: its geometry has no z");
  expect_refused<InputError>("flat.gpkg", {}, "--z-field (h)");
  EXPECT_EQ(read("flat.gpkg", of_layer({.z_field = "h"})),
            (std::vector<Spot>{{1, 2, 7.5}, {3, 4, 8.5}}));
  const PointSet points = read_points(directory_ / "flat.gpkg", of_layer({.no_z = true}));
  EXPECT_FALSE(points.has_heights());
  EXPECT_EQ(points.size(), 2u);
  // A layer of which only some points are flat is none of heights either.
  layer("GPKG", "mixed.gpkg", "p", "wkt\n\"POINT Z (1 2 3)\"\n\"POINT (3 4)\"\n");
  expect_refused<InputError>("mixed.gpkg", {}, "feature 2: its geometry has no z");
}

TEST_F(GdalTest, MeasuresAreNoHeights) {
  layer("GPKG", "zm.gpkg", "p", "wkt,h\n\"POINT ZM (1 2 3 9)\",4\n\"MULTIPOINT ZM (5 6 7 9)\",5\n");
  EXPECT_EQ(read("zm.gpkg"), (std::vector<Spot>{{1, 2, 3}, {5, 6, 7}}));
  layer("GPKG", "m.gpkg", "p", "wkt,h\n\"POINT M (1 2 9)\",4\n\"POINT M (5 6 9)\",5\n");
  expect_refused<InputError>("m.gpkg", {}, "has no z");
  EXPECT_EQ(read("m.gpkg", of_layer({.z_field = "h"})), (std::vector<Spot>{{1, 2, 4}, {5, 6, 5}}));
}

TEST_F(GdalTest, FeaturesWithoutGeometryAreLeftOutWithAWord) {
  layer("GPKG", "null.gpkg", "p",
        "wkt,h\n\"POINT Z (1 2 3)\",1\n\"\",2\n\"POINT Z EMPTY\",3\n\"POINT Z (4 5 6)\",4\n");
  const PointTable table = read_point_table(directory_ / "null.gpkg");
  EXPECT_EQ(spots(table.points), (std::vector<Spot>{{1, 2, 3}, {4, 5, 6}}));
  ASSERT_EQ(table.warnings.size(), 1u);
  EXPECT_EQ(table.warnings[0], "2 of 4 features have no geometry and are left out");
}

TEST_F(GdalTest, HeightsThatAreNoNumbersAreRefused) {
  layer("GPKG", "null.gpkg", "p", "wkt,h\n\"POINT (1 2)\",1\n\"POINT (3 4)\",\n");
  expect_refused<InputError>("null.gpkg", of_layer({.z_field = "h"}),
                             "feature 2: its field 'h' holds no number");
  // GDAL's programs write no NaN, so the bytes of a number give way to it.
  layer("FlatGeobuf", "nan.fgb", "p", "wkt\n\"POINT Z (1 2 451.75)\"\n",
        "-dim XYZ -lco SPATIAL_INDEX=NO");
  std::string bytes = test::content_of(directory_ / "nan.fgb");
  const std::size_t at = bytes.find(bytes_of(451.75));
  ASSERT_NE(at, std::string::npos);
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    directory_.file("nan.fgb", bytes.replace(at, sizeof bad, bytes_of(bad)));
    expect_refused<InputError>("nan.fgb", {}, "feature 1: it has a coordinate that is not finite");
  }
}

TEST_F(GdalTest, LayersAreChosenByName) {
  layer("GPKG", "two.gpkg", "Höhen & \"Punkte\"", "wkt\n\"POINT Z (1 2 3)\"\n");
  EXPECT_EQ(read("two.gpkg").size(), 1u) << "the only one";
  layer("GPKG", "two.gpkg", "main", "wkt\n\"POINT Z (4 5 6)\"\n");
  expect_refused<ParameterError>(
      "two.gpkg", {}, "has 2 layers: 'Höhen & \"Punkte\"', 'main'; choose one with --layer");
  EXPECT_EQ(read("two.gpkg", of_layer({.layer = "Höhen & \"Punkte\""})),
            (std::vector<Spot>{{1, 2, 3}}));
  EXPECT_EQ(read("two.gpkg", of_layer({.layer = "main"})), (std::vector<Spot>{{4, 5, 6}}));
  expect_refused<ParameterError>("two.gpkg", of_layer({.layer = "Main"}), "has no layer 'Main'");
}

TEST_F(GdalTest, FileNamesMayHoldAnything) {
  layer("GPKG", "Höhen von 2024.GPKG", "p", "wkt\n\"POINT Z (1 2 3)\"\n");
  EXPECT_EQ(read("Höhen von 2024.GPKG"), (std::vector<Spot>{{1, 2, 3}}));
}

TEST_F(GdalTest, EmptyLayersAreRefused) {
  layer("GPKG", "empty.gpkg", "p", "wkt,h\n\"POINT Z (1 2 3)\",1\n", "-where 'h > 5'");
  expect_refused<InputError>("empty.gpkg", {}, "its layer 'p' holds no points");
}

TEST_F(GdalTest, TablesWithoutGeometryAreNoLayers) {
  layer("GPKG", "t.gpkg", "p", "wkt,h\n\"POINT Z (1 2 3)\",1\n");
  layer("GPKG", "t.gpkg", "words", "a,b\n1,2\n");
  EXPECT_EQ(read("t.gpkg").size(), 1u);
}

constexpr const char* kMixed =
    "wkt,elev\n"
    "\"POINT Z (9 9 9)\",1\n"
    "\"LINESTRING Z (0 0 1,1 0 2,1 1 3)\",2\n"
    "\"POLYGON Z ((0 0 5,4 0 6,4 4 7,0 0 5),(1 0.5 8,2 0.5 8,2 1 8,1 0.5 8))\",3\n"
    "\"GEOMETRYCOLLECTION Z (POINT Z (7 7 7),MULTILINESTRING Z ((5 5 1,6 6 2)))\",4\n";

TEST_F(GdalTest, LinesAndPolygonsGiveTheirVerticesWhenAsked) {
  layer("GPKG", "mixed.gpkg", "m", kMixed);
  expect_refused<InputError>("mixed.gpkg", {}, "feature 2: it is a line; --vertices takes");
  EXPECT_EQ(read("mixed.gpkg", of_layer({.vertices = true})), (std::vector<Spot>{{9, 9, 9},
                                                                                 {0, 0, 1},
                                                                                 {1, 0, 2},
                                                                                 {1, 1, 3},
                                                                                 {0, 0, 5},
                                                                                 {4, 0, 6},
                                                                                 {4, 4, 7},
                                                                                 {1, 0.5, 8},
                                                                                 {2, 0.5, 8},
                                                                                 {2, 1, 8},
                                                                                 {7, 7, 7},
                                                                                 {5, 5, 1},
                                                                                 {6, 6, 2}}));
  const std::vector<Spot> by_field =
      read("mixed.gpkg", of_layer({.z_field = "elev", .vertices = true}));
  ASSERT_EQ(by_field.size(), 13u);
  EXPECT_EQ(by_field[3], (Spot{1, 1, 2}));
  EXPECT_EQ(by_field[12], (Spot{6, 6, 4}));
}

TEST_F(GdalTest, CurvesAreRefused) {
  layer("GPKG", "curve.gpkg", "c", "wkt\n\"CIRCULARSTRING Z (0 0 1,1 1 1,2 0 1)\"\n");
  expect_refused<InputError>("curve.gpkg", of_layer({.vertices = true}), "CONVERT_TO_LINEAR");
}

TEST_F(GdalTest, DamagedAndMissingFilesGetOneLine) {
  directory_.file("a.gpkg", "no geopackage");
  directory_.file("a.tif", "no raster");
  expect_refused<InputError>("a.gpkg", {}, "cannot read");
  expect_refused<InputError>("a.tif", {}, "cannot read");
  expect_refused<FileError>("none.gpkg", {}, "No such file");
  layer("FlatGeobuf", "p.fgb", "p", kTable, "-dim XYZ -lco SPATIAL_INDEX=NO");
  const std::string bytes = test::content_of(directory_ / "p.fgb");
  directory_.file("cut.fgb", bytes.substr(0, bytes.size() - 20));
  expect_refused<InputError>("cut.fgb", {}, "damaged");
  std::string grid = "ncols 100\nnrows 100\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
  for (int i = 0; i < 10000; ++i) grid += std::to_string(i) + " ";
  raster("whole.tif", grid + "\n", "");
  directory_.file("cut.tif", test::content_of(directory_ / "whole.tif").substr(0, 20000));
  expect_refused<InputError>("cut.tif", {}, "cannot read");
}

TEST_F(GdalTest, ChoicesOfOtherFilesAreRefused) {
  layer("GPKG", "p.gpkg", "p", kTable);
  directory_.file("p.csv", "x,y,z\n1,2,3\n");
  raster("r.tif", "ncols 1\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n5\n", "");
  const PointChoice columns{.columns = {{"1", "2", "3"}}};
  expect_refused<ParameterError>("p.gpkg", columns, "--columns is for tables of points, and");
  expect_refused<ParameterError>("r.tif", columns, "is a raster");
  for (const char* file : {"p.csv", "r.tif"})
    expect_refused<ParameterError>(file, of_layer({.layer = "p"}), "are for files of map features");
  for (const char* file : {"p.csv", "p.gpkg"})
    expect_refused<ParameterError>(file, of_raster(1, 0), "--band and --stride are for rasters");
}

// ---- Rasters. ----

constexpr const char* kGrid =
    "ncols 3\nnrows 2\nxllcorner 500000\nyllcorner 5000000\ncellsize 10\nNODATA_value -9999\n"
    "451.70000000000005 -9999 3\n4.1 5.2 6.3\n";
const std::vector<Spot> kCells = {{500005, 5000015, 451.70000000000005},
                                  {500025, 5000015, 3},
                                  {500005, 5000005, 4.1},
                                  {500015, 5000005, 5.2},
                                  {500025, 5000005, 6.3}};

TEST_F(GdalTest, CentresOfCellsAreTheSameBits) {
  raster("dem.tif", kGrid, "-a_srs EPSG:25832");
  shell("gdal_translate dem.tif dem.img -of HFA && gdal_translate dem.tif dem.vrt -of VRT");
  for (const char* file : {"dem.tif", "dem.img", "dem.vrt"}) {
    const PointTable table = read_point_table(directory_ / file);
    EXPECT_EQ(spots(table.points), kCells) << file;
    EXPECT_TRUE(is_same_crs(table.points.crs, "EPSG:25832") ||
                table.points.crs.starts_with("BOUNDCRS"))
        << table.points.crs << " of " << file;
    EXPECT_EQ(table.columns.source, "centres of cells, z = band 1 of 1") << file;
  }
}

TEST_F(GdalTest, AsciiGridsKeepTheirDecimalsAndTablesOfThatNameStayTables) {
  directory_.file("grid.asc", kGrid);
  shell("gzip -k grid.asc");
  EXPECT_EQ(read("grid.asc"), kCells);
  EXPECT_EQ(read("grid.asc.gz"), kCells);
  directory_.file("table.asc", "1 2 3\n4 5 6\n7 8 10\n");
  EXPECT_EQ(read("table.asc"), (std::vector<Spot>{{1, 2, 3}, {4, 5, 6}, {7, 8, 10}}));
}

TEST_F(GdalTest, AsciiGridsHaveAsManyNumbersAsTheySay) {
  const std::string header =
      "ncols 4\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 1\nNODATA_value -9999\n";
  const auto refused = [&](const std::string& values, const std::string& message) {
    directory_.file("g.asc", header + values);
    directory_.file("g.grd", header + values);
    for (const char* file : {"g.asc", "g.grd"}) expect_refused<InputError>(file, {}, message);
  };
  const std::string all = "; in all there are ";
  refused("1 2 3 4\n5 6 7\n9 10 11 12\n",
          "line 8: 3 values, where a row has 4" + all + "11 for 3 rows of 4 columns");
  shell("gzip -k g.asc");
  expect_refused<InputError>("g.asc.gz", {}, "line 8: 3 values");
  refused("1 2 3 4\n5 6 7 8 8.5\n9 10 11 12\n", "line 8: 5 values, where a row has 4" + all + "13");
  refused("1 2 3 4\n5 6 7\n9 10 11 12 13\n", "line 8: 3 values, where a row has 4" + all + "12");
  refused("1 2 3 4\n5 6 7 8\n", "line 8: with this last line of values, in all there are 8");
  refused("1 2 3 4\n5 6 7 8\n9 10 11 12\n13 14 15 16\n", "line 10: with this last line");
  refused("1 2 3\n4 5 6\n7 8 9\n10 11\n",
          "line 10: with this last line of values, in all there are 11");
  for (const std::string word : {"NA", "x", "-", "3.06.1", "1.5d3", "3,06,1", "1e999", "inf", "7m"})
    refused("1 2 3 4\n5 6 7 8\n9 " + word + " 11 12\n", "line 9: '" + word + "' is no number");

  const std::vector<Spot> cells = {{0.5, 2.5, 1},  {1.5, 2.5, 20},  {2.5, 2.5, 3}, {3.5, 2.5, -4},
                                   {0.5, 1.5, 5},  {1.5, 1.5, 6.5}, {2.5, 1.5, 7}, {3.5, 1.5, 0.8},
                                   {1.5, 0.5, 10}, {2.5, 0.5, 11}};
  for (const std::string values :
       {"1 2e1 3 -4\n5 6.5 7 .8\n-9999 10 +11 nan\n",
        "1 2e1 3 -4\r\n5 6.5 7. .8\r\n-9999 10 11 NaN",
        "1 2e1 3\n-4 5 6.5\n7 .8 -9999\n10 11 nan\n", " 1 2e1 3 -4 5 6.5 7 .8 -9999 10 11 nan \n\n",
        "1 2e1 3 -4\n\n5 6,5 7 ,8\n-9999 10 11 nan\n"}) {
    directory_.file("g.asc", header + values);
    EXPECT_EQ(read("g.asc"), cells) << values;
  }
}

TEST_F(GdalTest, FloatsThatAreNoDataAreLeftOutWhateverTheDecimals) {
  // As text the value is no float: the nearest one is in the cells.
  raster("dem.tif",
         "ncols 2\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n"
         "-3.4028234663852886e+38 7.1\n",
         "-ot Float32 -a_nodata -3.40282346638529e+38");
  EXPECT_EQ(read("dem.tif"), (std::vector<Spot>{{1.5, 0.5, 7.1f}}));
  raster("nan.tif", "ncols 2\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n5.5 7.1\n",
         "-ot Float32");
  std::string bytes = test::content_of(directory_ / "nan.tif");
  const std::size_t at = bytes.find(bytes_of(5.5f));
  ASSERT_NE(at, std::string::npos);
  directory_.file("nan.tif", bytes.replace(at, sizeof(float), bytes_of(std::nanf(""))));
  EXPECT_EQ(read("nan.tif"), (std::vector<Spot>{{1.5, 0.5, 7.1f}}));
}

TEST_F(GdalTest, ScaleAndOffsetApply) {
  raster("dem.tif",
         "ncols 3\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\nNODATA_value -1\n-1 0 3\n",
         "-ot Int16 -a_scale 0.1 -a_offset 100");
  EXPECT_EQ(read("dem.tif"),
            (std::vector<Spot>{{1.5, 0.5, 0 * 0.1 + 100}, {2.5, 0.5, 3 * 0.1 + 100}}));
}

TEST_F(GdalTest, StrideTakesEveryNthRowAndColumn) {
  std::string grid = "ncols 5\nnrows 4\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
  for (int i = 0; i < 20; ++i) grid += std::to_string(i) + (i % 5 == 4 ? "\n" : " ");
  raster("dem.tif", grid, "");
  EXPECT_EQ(read("dem.tif", of_raster(0, 2)), (std::vector<Spot>{{0.5, 3.5, 0},
                                                                 {2.5, 3.5, 2},
                                                                 {4.5, 3.5, 4},
                                                                 {0.5, 1.5, 10},
                                                                 {2.5, 1.5, 12},
                                                                 {4.5, 1.5, 14}}));
  EXPECT_EQ(read("dem.tif", of_raster(0, 1000000000)), (std::vector<Spot>{{0.5, 3.5, 0}}));
  EXPECT_EQ(read("dem.tif", of_raster(0, 1)).size(), 20u);
}

TEST_F(GdalTest, RotatedRastersAreRead) {
  raster("dem.tif", "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n3 4\n",
         "-of VRT");
  std::string text = test::content_of(directory_ / "dem.tif");
  const std::size_t begin = text.find("<GeoTransform>"), end = text.find("</GeoTransform>");
  ASSERT_NE(begin, std::string::npos);
  text.replace(begin, end - begin, "<GeoTransform>100.1, 3, -4, 200.2, 4, 3");
  directory_.file("turned.vrt", text);
  std::vector<Spot> expected;
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 2; ++column)
      expected.push_back({100.1 + (column + 0.5) * 3 + (row + 0.5) * -4,
                          200.2 + (column + 0.5) * 4 + (row + 0.5) * 3, 1.0 + 2 * row + column});
  EXPECT_EQ(read("turned.vrt"), expected);
}

TEST_F(GdalTest, BandsAreChosen) {
  raster("one.tif", "ncols 1\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n5\n", "");
  raster("two.tif", "ncols 1\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n6\n", "");
  shell("gdalbuildvrt -separate both.vrt one.tif two.tif");
  EXPECT_EQ(read("both.vrt"), (std::vector<Spot>{{0.5, 0.5, 5}}));
  EXPECT_EQ(read("both.vrt", of_raster(2, 0)), (std::vector<Spot>{{0.5, 0.5, 6}}));
  expect_refused<ParameterError>("both.vrt", of_raster(3, 0), "has no band 3; it has 2");
}

TEST_F(GdalTest, MaskedCellsAreLeftOut) {
  raster("dem.tif", "ncols 2\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n5 6\n", "");
  raster("mask.tif", "ncols 2\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n0 255\n", "-ot Byte");
  shell(
      "gdalbuildvrt -separate both.vrt dem.tif mask.tif && gdal_translate -b 1 -mask 2 both.vrt "
      "masked.tif");
  EXPECT_EQ(read("masked.tif"), (std::vector<Spot>{{1.5, 0.5, 6}}));
}

TEST_F(GdalTest, RastersWithoutAnyHeightOrPlaceAreRefused) {
  raster("empty.tif",
         "ncols 2\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\nNODATA_value 7\n7 7\n", "");
  expect_refused<InputError>("empty.tif", {}, "no cell of it has a value");
  directory_.file("nowhere.pgm", "P5 2 1 255\n56");
  shell("gdal_translate nowhere.pgm nowhere.tif");
  expect_refused<InputError>("nowhere.tif", {}, "does not say where its cells are");
}

// ---- Lines, outlines, places. ----

TEST_F(GdalTest, LinesOutlinesAndPlacesAreThoseOfTheFile) {
  const char* const lines =
      "wkt\n\"LINESTRING Z (0 0 1.1,1 0 2.2,1 1 3.3)\"\n\"\"\n"
      "\"MULTILINESTRING Z ((5 5 1,6 6 2),(7 7 3,8 8 4))\"\n";
  const char* const areas =
      "wkt\n\"POLYGON ((0 0,4 0,4 4,0 0),(1 0.5,2 0.5,2 1,1 0.5))\"\n"
      "\"MULTIPOLYGON (((10 0,14 0,14 4,10 0)))\"\n";
  const struct {
    const char *format, *lines, *areas;
  } formats[] = {{"GPKG", "l.gpkg", "a.gpkg"},
                 {"ESRI Shapefile", "l.shp", "a.shp"},
                 {"FlatGeobuf", "l.fgb", "a.fgb"}};
  for (const auto& [format, line_file, area_file] : formats) {
    const std::string unsorted =
        std::string(format) == "FlatGeobuf" ? " -lco SPATIAL_INDEX=NO" : "";
    layer(format, line_file, "l", lines, "-a_srs EPSG:25832 -dim XYZ" + unsorted);
    layer(format, area_file, "a", areas, "-a_srs EPSG:25832" + unsorted);
    const Lines read = read_lines(directory_ / line_file);
    ASSERT_EQ(read.lines.size(), 3u) << format;
    EXPECT_EQ(read.crs, "EPSG:25832") << format;
    EXPECT_EQ(read.lines[0].xy, (std::vector<Point>{{0, 0}, {1, 0}, {1, 1}})) << format;
    EXPECT_EQ(read.lines[0].z, (std::vector<double>{1.1, 2.2, 3.3})) << format;
    // FlatGeobuf holds no features without geometry.
    EXPECT_EQ(read.lines[1].part, unsorted.empty() ? 3u : 2u) << format;
    EXPECT_EQ(read.lines[2].z, (std::vector<double>{3, 4})) << format;

    const Outline outline = read_outline(directory_ / area_file);
    ASSERT_EQ(outline.rings.size(), 3u) << format;
    EXPECT_EQ(outline.crs, "EPSG:25832") << format;
    EXPECT_FALSE(outline.rings[0].has_heights()) << format;
    EXPECT_EQ(outline.rings[2].part, 2u) << format;

    const Places places = read_places(directory_ / area_file);
    ASSERT_EQ(places.polygons.size(), 2u) << format;
    EXPECT_EQ(places.polygons[0].rings.size(), 2u) << format;
    EXPECT_EQ(places.crs, "EPSG:25832") << format;
    EXPECT_EQ(places.part_of_polygon, (std::vector<Index>{1, 2})) << format;
  }
}

TEST_F(GdalTest, WhatNoTakerTakesIsRefused) {
  layer("GPKG", "m.gpkg", "m", kMixed);
  const std::string lines = message_of<InputError>([&] { read_lines(directory_ / "m.gpkg"); });
  EXPECT_NE(
      lines.find("m.gpkg, feature 1: it has a point; lines and polygons are what it can hold"),
      std::string::npos)
      << lines;
  const std::string places = message_of<InputError>([&] { read_places(directory_ / "m.gpkg"); });
  EXPECT_NE(places.find("feature 2: it has a line"), std::string::npos) << places;
  layer("GPKG", "m.gpkg", "n", "wkt\n\"LINESTRING (0 0,1 1)\"\n");
  EXPECT_EQ(read_lines(directory_ / "m.gpkg", "n").lines.size(), 1u);
  EXPECT_NE(message_of<ParameterError>([&] {
              read_lines(directory_ / "m.gpkg");
            }).find("m.gpkg|layername=m"),
            std::string::npos);
}

TEST(WithoutGdal, UsingAFormatSaysWhatIsMissing) {
  if (has_gdal()) GTEST_SKIP() << "built with GDAL";
  for (const char* file : {"a.gpkg", "a.tif", "a.geojson"}) {
    const std::string error = message_of<ParameterError>([&] { read_points(file); });
    EXPECT_NE(error.find("apt install libgdal-dev"), std::string::npos) << error;
  }
  EXPECT_NE(message_of<ParameterError>([&] { read_lines("a.gpkg"); }).find("libgdal-dev"),
            std::string::npos);
}

TEST_F(GdalTest, SystemsWithoutACodeAreWrittenAsTheyAreOrRefused) {
  Tin tin;
  tin.points = {{{0, 0}, {9, 0}, {0, 9}}, {1, 2, 3}};
  tin.triangles = {{0, 1, 2}};
  const auto written = [&](const std::string& crs, const std::string& file) {
    tin.crs = parse_crs("--crs", crs);
    write_tin(tin, directory_ / file);
    return is_same_crs(read_lines(directory_ / file).crs, tin.crs);
  };
  const std::string feet = "+proj=utm +zone=32 +datum=WGS84 +units=us-ft";
  const std::string metres = "+proj=utm +zone=32 +datum=WGS84 +units=m";
  const std::string own = "+proj=tmerc +lon_0=9.5 +x_0=500000 +ellps=bessel +units=us-ft";
  // A shapefile calls a datum without a name by that of its ellipsoid.
  EXPECT_TRUE(written(feet, "a.shp"));
  EXPECT_TRUE(written(metres, "a.shp"));
  for (const std::string file : {"a.gpkg", "a.geojson"})
    for (const std::string& crs : {feet, metres, own})
      EXPECT_TRUE(written(crs, file)) << file << crs;
  EXPECT_TRUE(written(metres, "a.fgb"));
  EXPECT_TRUE(written(own, "a.fgb"));
  const std::string message = message_of<ParameterError>([&] { written(feet, "b.fgb"); });
  EXPECT_NE(
      message.find("b.fgb: in this format GDAL would take the coordinate reference system for "
                   "EPSG:32632, which it is not"),
      std::string::npos)
      << message;
  EXPECT_FALSE(std::filesystem::exists(directory_ / "b.fgb"));

  tin.crs = parse_crs("--crs", feet);
  OutputFile raster(directory_ / "a.tif");
  write_heights(tin, {0, 9, 1, 1, 9, 9}, raster);
  raster.commit();
  EXPECT_TRUE(is_same_crs(read_grid(directory_ / "a.tif").crs, tin.crs));
}

TEST_F(GdalTest, ExtensionsInCapitalsAreWrittenAsTheyAre) {
  Tin tin;
  tin.points = {{{0, 0}, {9, 0}, {0, 9}}, {1, 2, 3}};
  tin.triangles = {{0, 1, 2}};
  tin.crs = "EPSG:25832";
  directory_.file("A.PRJ", "of an old file");
  directory_.file("A.QIX", "of an old file");
  for (const char* file : {"A.SHP", "B.FGB", "d.Fgb"}) {
    write_tin(tin, directory_ / file);
    const Lines lines = read_lines(directory_ / file);
    ASSERT_EQ(lines.lines.size(), 1u) << file;
    EXPECT_EQ(lines.lines[0].z[1] + lines.lines[0].z[2], 5) << file;
    EXPECT_TRUE(is_same_crs(lines.crs, tin.crs)) << file;
  }
  for (const char* file : {"A.SHX", "A.DBF", "A.PRJ", "A.CPG"})
    EXPECT_TRUE(std::filesystem::exists(directory_ / file)) << file;
  for (const char* file : {"A.shp", "A.shx", "A.QIX", "c.shp"})
    EXPECT_FALSE(std::filesystem::exists(directory_ / file)) << file;
  EXPECT_THROW(write_tin(tin, directory_ / "c.Shp"), ParameterError) << "GDAL does not read it";
}

TEST_F(GdalTest, SystemsOfHeightsAreKept) {
  const std::string grid = "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n3 4\n";
  const std::string both = parse_crs("--crs", "EPSG:25832+7837");
  for (const char* version : {"1.0", "1.1"}) {
    raster("h.tif", grid, std::string("-a_srs EPSG:25832+7837 -co GEOTIFF_VERSION=") + version);
    const PointTable table = read_point_table(directory_ / "h.tif");
    EXPECT_TRUE(is_same_crs(table.points.crs, both)) << version << ": " << table.points.crs;
    EXPECT_EQ(crs_units(table.points.crs).vertical, "m");
    EXPECT_TRUE(table.warnings.empty());
  }
  // And written where that can be: what a reader finds is the same system.
  for (const char* name : {"w.gpkg", "w.fgb", "w.ply", "w.tif"}) {
    const Tin tin{{{{0, 0}, {2, 0}, {0, 2}}, {1, 2, 3}}, {{0, 1, 2}}, both};
    const std::filesystem::path path = directory_ / name;
    if (is_raster_name(path)) {
      OutputFile file(path);
      write_heights(tin, grid_over(tin, 1), file);
      file.commit();
    } else {
      write_tin(tin, path);
    }
    const PointChoice choice{.layer = {.vertices = !is_raster_name(path)}};
    const std::string crs =
        path.extension() == ".ply" ? read_tin(path).crs : read_points(path, choice).crs;
    EXPECT_TRUE(is_same_crs(crs, both)) << name << ": " << crs;
    EXPECT_EQ(crs_units(crs).vertical, "m") << name;
  }
}

TEST_F(GdalTest, UnitsOfABandAreComparedWithThoseOfXAndY) {
  const std::string grid = "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n3 4\n";
  raster("u.tif", grid, "-a_srs EPSG:25832");
  shell(
      "gdal_translate -of VRT u.tif u.vrt && "
      "sed -i 's|<ColorInterp>|<UnitType>ft</UnitType><ColorInterp>|' u.vrt");
  const auto feet = read_point_table(directory_ / "u.vrt").warnings;
  ASSERT_EQ(feet.size(), 1u);
  EXPECT_NE(feet[0].find("heights are in ft, x and y in metre"), std::string::npos) << feet[0];
  shell("sed -i 's|<UnitType>ft|<UnitType>m|' u.vrt");
  EXPECT_TRUE(read_point_table(directory_ / "u.vrt").warnings.empty());
}

}  // namespace
}  // namespace hodt
