#include "hodt/io/line_file.h"

#include <string>
#include <vector>

#include "temporary_directory.h"
#include <gtest/gtest.h>

#include "hodt/base/error.h"
#include "hodt/io/gzip.h"

namespace hodt {
namespace {

using test::message_of;
using test::TemporaryDirectory;

using Path = std::vector<Point>;
using Heights = std::vector<double>;

Lines lines_of(const std::string& text, const std::string& name = "roads.geojson") {
  const TemporaryDirectory directory;
  return read_lines(directory.file(name, text));
}

Outline outline_of(const std::string& text) {
  const TemporaryDirectory directory;
  return read_outline(directory.file("area.geojson", text));
}

std::string geometry(const std::string& type, const std::string& coordinates) {
  return R"({"type": ")" + type + R"(", "coordinates": )" + coordinates + "}";
}

/// The geometry as the third of three features; the first is nowhere, the second is a line.
std::string third_feature(const std::string& geometry_text) {
  return R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": null, "geometry": null},
    {"type": "Feature", "properties": {"type": "Point"}, "geometry":
      {"type": "LineString", "coordinates": [[0, 0], [1, 1], [2, 0], [0, 0]]}},
    {"type": "Feature", "geometry": )" +
         geometry_text + "}]}";
}

/// What is said after the name of the file.
template <class Read>
std::string said(const Read& read, const std::string& text, const std::string& name) {
  const std::string message = message_of<InputError>([&] { read(text); });
  const std::size_t at = message.find(name);
  return at == message.npos ? message : message.substr(at + name.size());
}

std::string refusal_of(const std::string& text) {
  return said([](const std::string& t) { lines_of(t); }, text, "roads.geojson");
}

std::string outline_refusal_of(const std::string& text) {
  return said([](const std::string& t) { outline_of(t); }, text, "area.geojson");
}

const std::string kTail = "; lines and polygons are what it can hold";

TEST(LineFile, reads_lines_and_rings) {
  const Lines line = lines_of(geometry("LineString", "[[0, 1.5], [-2e3, 3], [-2e3, 3]]"));
  ASSERT_EQ(line.lines.size(), 1u);
  EXPECT_EQ(line.lines[0].xy, Path({{0, 1.5}, {-2000, 3}, {-2000, 3}}));
  EXPECT_FALSE(line.lines[0].has_heights());
  EXPECT_EQ(line.lines[0].part, 1u);
  EXPECT_EQ(line.part, "feature");
  EXPECT_TRUE(line.source.ends_with("roads.geojson"));

  const Lines lines =
      lines_of(geometry("MultiLineString", "[[[0, 0, 7], [1, 1, 8.5]], [[5, 5], [6, 6], [7, 5]]]"));
  ASSERT_EQ(lines.lines.size(), 2u);
  EXPECT_EQ(lines.lines[0].z, Heights({7, 8.5}));
  EXPECT_EQ(lines.lines[1].xy, Path({{5, 5}, {6, 6}, {7, 5}}));
  EXPECT_TRUE(lines.lines[1].z.empty());

  // The first ring is closed in the file, the second is not.
  const Lines rings = lines_of(
      geometry("Polygon", "[[[0, 0], [9, 0], [0, 9], [0, 0]], [[1, 1, 4], [2, 1, 5], [1, 2, 6]]]"));
  ASSERT_EQ(rings.lines.size(), 2u);
  EXPECT_EQ(rings.lines[0].xy, Path({{0, 0}, {9, 0}, {0, 9}, {0, 0}}));
  EXPECT_EQ(rings.lines[1].xy, Path({{1, 1}, {2, 1}, {1, 2}, {1, 1}}));
  EXPECT_EQ(rings.lines[1].z, Heights({4, 5, 6, 4}));
  EXPECT_EQ(lines_of(geometry("MultiPolygon",
                              "[[[[0, 0], [1, 0], [0, 1], [0, 0]]],"
                              " [[[5, 5], [6, 5], [5, 6], [5, 5]]]]"))
                .lines.size(),
            2u);
}

TEST(LineFile, reads_collections_in_their_order) {
  const Lines lines =
      lines_of(third_feature(R"({"type": "GeometryCollection", "geometries": [)" +
                             geometry("Polygon", "[[[0, 0, 1], [1, 0, 2], [0, 1, 3]]]") + "," +
                             R"({"type": "GeometryCollection", "geometries": []},)" +
                             geometry("LineString", "[[3, 4], [5, 6]]") + "]}"));
  ASSERT_EQ(lines.lines.size(), 3u);
  EXPECT_EQ(lines.lines[0].part, 2u);
  EXPECT_EQ(lines.lines[1].part, 3u);
  EXPECT_EQ(lines.lines[1].z, Heights({1, 2, 3, 1}));
  EXPECT_EQ(lines.lines[2].part, 3u);
  EXPECT_EQ(lines.lines[2].xy, Path({{3, 4}, {5, 6}}));
  EXPECT_FALSE(lines.lines[2].has_heights());
}

TEST(LineFile, ignores_what_means_nothing) {
  // The old member crs, boxes, and what a position has behind its height.
  const Lines lines = lines_of(
      R"({"type": "LineString", "crs": {"type": "name", "properties": {"name": "EPSG:2056"}},
          "bbox": [0, 0, 1, 1], "coordinates": [[0, 0, 5, 17], [1, 1, 6, "m", null]]})");
  ASSERT_EQ(lines.lines.size(), 1u);
  EXPECT_EQ(lines.lines[0].z, Heights({5, 6}));
  // A geometry of no coordinates is one that is nowhere.
  for (const char* type : {"LineString", "MultiLineString", "Polygon", "MultiPolygon"}) {
    EXPECT_EQ(lines_of(third_feature(geometry(type, "[]"))).lines.size(), 1u) << type;
    EXPECT_EQ(outline_of(third_feature(geometry(type, "[]"))).rings.size(), 1u) << type;
  }
}

TEST(LineFile, odd_numbers_are_exact) {
  const Lines lines =
      lines_of(geometry("LineString",
                        "[[-0, 1e-400, 9007199254740993], [1.7976931348623157e308, 5e-324, "
                        "18446744073709551615], [0.1, -0.30000000000000004, 1E+2], "
                        "[123456789012345678901234567890, -9223372036854775808, 0.0]]"));
  EXPECT_EQ(lines.lines[0].xy, Path({{0, 0},
                                     {1.7976931348623157e308, 5e-324},
                                     {0.1, -0.30000000000000004},
                                     {123456789012345678901234567890.0, -9223372036854775808.0}}));
  EXPECT_EQ(lines.lines[0].z, Heights({9007199254740992, 18446744073709551616.0, 100, 0}));
}

TEST(LineFile, bytes_may_be_packed_marked_or_of_windows) {
  const std::string text = geometry("LineString", "[[0, 0],\r\n [1, 1]]\r\n");
  EXPECT_EQ(lines_of(text).lines[0].xy, Path({{0, 0}, {1, 1}}));
  EXPECT_EQ(lines_of("\xEF\xBB\xBF" + text, "R.GeoJSON").lines[0].xy, Path({{0, 0}, {1, 1}}));
  const Buffer<char> packed = gzip(text);
  const std::string bytes(packed.data(), packed.size());
  EXPECT_EQ(lines_of(bytes, "r.json.gz").lines[0].xy, Path({{0, 0}, {1, 1}}));
  EXPECT_EQ(lines_of(bytes, "r.geojson").lines[0].xy, Path({{0, 0}, {1, 1}}));
  std::string wide("\xFF\xFE");
  for (const char c : text) wide += {c, '\0'};
  EXPECT_EQ(lines_of(wide).lines[0].xy, Path({{0, 0}, {1, 1}}));
}

TEST(LineFile, reads_what_is_nested_deeply) {
  std::string head, tail;
  for (int i = 0; i < 100000; ++i) {
    head += R"({"type": "GeometryCollection", "geometries": [)";
    tail += "]}";
  }
  EXPECT_EQ(lines_of(head + geometry("LineString", "[[0, 0], [1, 1]]") + tail).lines.size(), 1u);
  const std::string brackets(100000, '['), ends(100000, ']');
  EXPECT_EQ(refusal_of(geometry("LineString", brackets + ends)),
            ": this is no GeoJSON: a position is of fewer than two numbers in feature 1, line 1, "
            "position 1" +
                kTail);
}

TEST(LineFile, the_name_tells_the_format) {
  const std::string message = message_of<ParameterError>([] { read_lines("no/such/roads.shpx"); });
  EXPECT_TRUE(
      message.starts_with("cannot read lines and places from no/such/roads.shpx: unknown "
                          "extension '.shpx'; known are .geojson, .json, "))
      << message;
  EXPECT_NE(message.find(".shp, "), std::string::npos) << message;
  EXPECT_TRUE(message.ends_with(", .geojson, .json also with .gz")) << message;
  EXPECT_NE(message_of<ParameterError>([] {
              read_outline("-");
            }).find("cannot read lines and places from standard input: the name has no extension"),
            std::string::npos);
  EXPECT_THROW(read_lines("no/such/file.geojson"), FileError);
  EXPECT_THROW(read_outline("no/such/file.geojson"), FileError);
}

TEST(LineFile, refuses_other_geometries) {
  EXPECT_EQ(refusal_of(third_feature(geometry("Point", "[1, 2]"))),
            ", feature 3: it has a Point" + kTail);
  EXPECT_EQ(refusal_of(third_feature(geometry("MultiPoint", "[[1, 2]]"))),
            ", feature 3: it has a MultiPoint" + kTail);
  EXPECT_EQ(refusal_of(geometry("Point", "[]")), ": it has a Point" + kTail);
  EXPECT_EQ(refusal_of(third_feature(geometry("linestring", "[]"))),
            ", feature 3: it has a 'linestring'" + kTail);
  EXPECT_EQ(refusal_of(geometry("Topology", "[]")), ": it has a 'Topology'" + kTail);
}

TEST(LineFile, refuses_what_is_too_short) {
  const std::string line = "it has fewer than two positions; complete or remove it";
  EXPECT_EQ(refusal_of(third_feature(geometry("LineString", "[[1, 2]]"))),
            ", feature 3, line 1: " + line);
  EXPECT_EQ(refusal_of(third_feature(geometry("MultiLineString", "[[[1, 2], [3, 4]], []]"))),
            ", feature 3, line 2: " + line);
  EXPECT_EQ(refusal_of(geometry("MultiLineString", "[[]]")), ", feature 1, line 1: " + line);
  const std::string ring = "a polygon's ring of fewer than three corners; complete or remove it";
  for (const std::string corners :
       {"[]", "[[0, 0]]", "[[0, 0], [1, 0]]", "[[0, 0], [1, 0], [0, 0]]"}) {
    const std::string rings = "[[[0, 0], [9, 0], [0, 9], [0, 0]], " + corners + "]";
    EXPECT_EQ(refusal_of(third_feature(geometry("Polygon", rings))), ", feature 3, ring 2: " + ring)
        << corners;
    EXPECT_EQ(outline_refusal_of(geometry("Polygon", rings)), ", feature 1, ring 2: " + ring)
        << corners;
  }
  // The rings of a feature count on from geometry to geometry.
  EXPECT_EQ(refusal_of(third_feature(geometry(
                "MultiPolygon", "[[[[0, 0], [1, 0], [0, 1]]], [[[0, 0], [1, 0], [0, 0]]]]"))),
            ", feature 3, ring 2: " + ring);
}

TEST(LineFile, refuses_what_is_no_position) {
  const auto no_geojson = [&](const std::string& why, const std::string& where) {
    return ": this is no GeoJSON: " + why + " in " + where + kTail;
  };
  for (const std::string position : {"[]", "[3]"})
    EXPECT_EQ(
        refusal_of(third_feature(
            geometry("MultiLineString", "[[[0, 0], [1, 1]], [[0, 0], [2, 2], " + position + "]]"))),
        no_geojson("a position is of fewer than two numbers", "feature 3, line 2, position 3"));
  for (const std::string position : {"[null, 0]", "[0, \"1\"]", "[true, 0]", "[0, [1]]",
                                     "[1, 2, null]", "[0, 0, \"5\"]", "[{}, {}]"})
    EXPECT_EQ(refusal_of(geometry("LineString", "[" + position + ", [1, 1, 1]]")),
              no_geojson("a coordinate is no number", "feature 1, line 1, position 1"))
        << position;
  for (const std::string position : {"{\"0\": 1, \"1\": 2}", "3", "null", "\"0 0\""})
    EXPECT_EQ(
        refusal_of(third_feature(geometry("Polygon", "[[[0, 0], " + position + ", [1, 1]]]"))),
        ": this is no GeoJSON in feature 3, ring 1, position 2" + kTail)
        << position;
}

TEST(LineFile, refuses_heights_of_some_positions) {
  EXPECT_EQ(refusal_of(third_feature(geometry("LineString", "[[0, 0, 1], [1, 1, 2], [2, 2]]"))),
            ", feature 3, line 1, position 3: it has no height, unlike those before; give each "
            "position of a line one, or none");
  EXPECT_EQ(refusal_of(third_feature(geometry("Polygon", "[[[0, 0], [1, 0, 5], [0, 1, 5]]]"))),
            ", feature 3, ring 1, position 2: it has a height, unlike those before; give each "
            "position of a line one, or none");
  EXPECT_EQ(
      refusal_of(
          third_feature(geometry("Polygon", "[[[0, 0, 1.5], [1, 0, 5], [0, 1, 5], [0, 0, 2]]]"))),
      ", feature 3, ring 1: it begins at height 1.5 and ends at the same place at 2; correct one "
      "of them");
  // A line may come back to where it was at another height, as a ramp does: whoever uses it
  // decides.
  EXPECT_EQ(
      lines_of(geometry("LineString", "[[0, 0, 1], [1, 0, 2], [0, 1, 3], [0, 0, 4]]")).lines[0].z,
      Heights({1, 2, 3, 4}));
}

TEST(LineFile, refuses_files_without_a_line) {
  for (const char* text :
       {R"({"type": "FeatureCollection", "features": []})",
        R"({"type": "Feature", "geometry": null})", R"({"type": "LineString", "coordinates": []})",
        R"({"type": "GeometryCollection", "geometries": []})"}) {
    EXPECT_EQ(refusal_of(text), " holds nothing" + kTail) << text;
    EXPECT_EQ(outline_refusal_of(text),
              " holds nothing; polygons and closed lines are what it can hold");
  }
}

TEST(LineFile, refuses_what_is_no_geojson) {
  const auto text_at = [&](int line, int column) {
    return ": this is no GeoJSON in line " + std::to_string(line) + " of the text, column " +
           std::to_string(column) + kTail;
  };
  EXPECT_EQ(refusal_of(""), text_at(1, 1));
  EXPECT_EQ(refusal_of("nonsense"), text_at(1, 2));
  EXPECT_EQ(refusal_of("{\"type\":\n\n  nonsense}"), text_at(3, 4));
  EXPECT_EQ(refusal_of(geometry("LineString", "[[0, 0], [1, NaN]]")), text_at(1, 52));
  EXPECT_EQ(refusal_of(geometry("LineString", "[[0, 0], [1, 1]]") + "]"), text_at(1, 56));
  for (const char* number : {"1e999", "-1e309", "1.8e308"}) {
    const std::string message =
        refusal_of(geometry("LineString", "[[0, 0],\n[1, " + std::string(number) + "]]"));
    EXPECT_EQ(message, ": this is no GeoJSON: '" + std::string(number) +
                           "' is too large a number in line 2 of the text, column " +
                           std::to_string(4 + std::string(number).size()) + kTail);
  }
  for (const char* text :
       {"[]", "3", "null", "{}", R"({"type": 3})", R"({"type": "LineString"})",
        R"({"type": "LineString", "coordinates": {"a": [0, 0]}})",
        R"({"type": "LineString", "coordinates": null})", R"({"type": "FeatureCollection"})",
        R"({"type": "FeatureCollection", "features": {"a": 1}})"})
    EXPECT_EQ(refusal_of(text), ": this is no GeoJSON" + kTail) << text;
  EXPECT_EQ(refusal_of(R"({"type": "Feature"})"), ": this is no GeoJSON in feature 1" + kTail);
  EXPECT_EQ(refusal_of(third_feature("7")), ": this is no GeoJSON in feature 3" + kTail);
  EXPECT_EQ(refusal_of(third_feature(geometry("MultiPolygon", "[[]]"))),
            ": this is no GeoJSON: a polygon without a ring in feature 3" + kTail);
}

TEST(Outline, reads_polygons_and_closed_lines) {
  const Outline outline = outline_of(third_feature(
      geometry("MultiPolygon", "[[[[0, 0], [9, 0], [0, 9]], [[1, 1, 5], [2, 1, 5], [1, 2, 5]]]]")));
  ASSERT_EQ(outline.rings.size(), 3u);
  EXPECT_EQ(outline.rings[0].xy, Path({{0, 0}, {1, 1}, {2, 0}, {0, 0}}));
  EXPECT_EQ(outline.rings[0].part, 2u);
  EXPECT_EQ(outline.rings[1].xy, Path({{0, 0}, {9, 0}, {0, 9}, {0, 0}}));
  EXPECT_EQ(outline.rings[2].z, Heights({5, 5, 5, 5}));
  EXPECT_EQ(outline.rings[2].part, 3u);
  EXPECT_EQ(outline.part, "feature");
  EXPECT_TRUE(outline.source.ends_with("area.geojson"));
}

TEST(Outline, refuses_lines_that_are_no_rings) {
  EXPECT_EQ(
      outline_refusal_of(third_feature(geometry(
          "MultiLineString", "[[[0, 0], [9, 0], [0, 9], [0, 0]], [[0.5, 0], [1, 0], [0, 1.25]]]"))),
      ", feature 3, line 2: it is open: it begins at 0.5, 0 and ends at 0, 1.25; repeat the "
      "first position of an outline at its end, or make it a polygon");
  for (const char* line : {"[[0, 0], [0, 0]]", "[[0, 0], [1, 0], [0, 0]]"})
    EXPECT_EQ(outline_refusal_of(geometry("LineString", line)),
              ", feature 1, line 1: it has fewer than three corners; complete or remove it");
  EXPECT_EQ(
      outline_refusal_of(geometry("LineString", "[[0, 0, 1], [1, 0, 2], [0, 1, 3], [0, 0, 4]]")),
      ", feature 1, line 1: it begins at height 1 and ends at the same place at 4; correct "
      "one of them");
  EXPECT_EQ(outline_refusal_of(third_feature(geometry("Point", "[1, 2]"))),
            ", feature 3: it has a Point; polygons and closed lines are what it can hold");
}

}  // namespace
}  // namespace hodt
