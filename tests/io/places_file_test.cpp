#include "hodt/io/places_file.h"

#include <string>

#include "temporary_directory.h"
#include <gtest/gtest.h>

#include "hodt/base/error.h"
#include "hodt/io/atomic_write.h"

namespace hodt {
namespace {

using test::message_of;
using test::TemporaryDirectory;

using Ring = std::vector<Point>;

Places places_of(const std::string& text, const std::string& name = "places.geojson") {
  const TemporaryDirectory directory;
  return read_places(directory.file(name, text));
}

std::string refusal_of(const std::string& text) {
  return message_of<InputError>([&] { places_of(text); });
}

TEST(PlacesFile, reads_single_geometries) {
  EXPECT_EQ(places_of(R"({"type": "Point", "coordinates": [1.5, -2, 30]})").points,
            Ring({{1.5, -2}}));
  EXPECT_EQ(places_of(R"({"type": "MultiPoint", "coordinates": [[1, 2], [3, 4]]})").points,
            Ring({{1, 2}, {3, 4}}));
  const Places polygon = places_of(
      R"({"type": "Polygon", "coordinates": [[[0, 0], [9, 0], [0, 9], [0, 0]], [[1, 1], [2, 1], [1, 2]]]})");
  EXPECT_TRUE(polygon.points.empty());
  ASSERT_EQ(polygon.polygons.size(), 1u);
  ASSERT_EQ(polygon.polygons[0].rings.size(), 2u);
  EXPECT_EQ(polygon.polygons[0].rings[0], Ring({{0, 0}, {9, 0}, {0, 9}, {0, 0}}));
  EXPECT_EQ(polygon.polygons[0].rings[1], Ring({{1, 1}, {2, 1}, {1, 2}}));
  const Places two = places_of(
      R"({"type": "MultiPolygon", "coordinates": [[[[0, 0], [1, 0], [0, 1]]], [[[5, 5], [6, 5], [5, 6]]]]})");
  ASSERT_EQ(two.polygons.size(), 2u);
  EXPECT_EQ(two.polygons[1].rings, std::vector<Ring>({{{5, 5}, {6, 5}, {5, 6}}}));
}

TEST(PlacesFile, reads_collections) {
  const Places places = places_of(R"({"type": "FeatureCollection", "features": [
      {"type": "Feature", "properties": {}, "geometry": null},
      {"type": "Feature", "geometry": {"type": "GeometryCollection", "geometries": [
          {"type": "Point", "coordinates": [1, 2]},
          {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [0, 1]]]}]}},
      {"type": "Feature", "geometry": {"type": "Point", "coordinates": [3, 4]}}]})");
  EXPECT_EQ(places.points, Ring({{1, 2}, {3, 4}}));
  EXPECT_EQ(places.part, "feature");
  EXPECT_EQ(places.part_of_point, std::vector<Index>({2, 3}));
  EXPECT_EQ(places.polygons.size(), 1u);
  EXPECT_EQ(places.part_of_polygon, std::vector<Index>({2}));
  EXPECT_TRUE(places.source.ends_with("places.geojson"));
  EXPECT_TRUE(places_of(R"({"type": "FeatureCollection", "features": []})").points.empty());
}

TEST(PlacesFile, reads_what_is_nested_deeply) {
  std::string head, tail;
  for (int i = 0; i < 100000; ++i) {
    head += R"({"type": "GeometryCollection", "geometries": [)";
    tail += "]}";
  }
  const std::string point = R"({"type": "Point", "coordinates": [1, 2]})";
  EXPECT_EQ(places_of(head + point + tail).points, Ring({{1, 2}}));
}

TEST(PlacesFile, the_name_tells_the_format) {
  const std::string point = R"({"type": "Point", "coordinates": [1, 2]})";
  EXPECT_EQ(places_of(point, "P.GeoJSON").points.size(), 1u);
  EXPECT_EQ(places_of(point, "p.json").points.size(), 1u);
  const Places table = places_of("x,y,z\n1,2,3\n4,5,6\n", "p.csv");
  EXPECT_EQ(table.points, Ring({{1, 2}, {4, 5}}));
  EXPECT_EQ(table.part_of_point, std::vector<Index>({1, 2}));
  EXPECT_THROW(places_of(point, "p.csv"), InputError);
}

TEST(PlacesFile, refuses_what_it_cannot_use) {
  for (const char* text :
       {"", "nonsense", "[]", "3", "null", "{}", R"({"type": 3})", R"({"type": "Point"})",
        R"({"type": "Point", "coordinates": [1]})", R"({"type": "Point", "coordinates": ["1", 2]})",
        R"({"type": "Point", "coordinates": [1e999, 2]})",
        R"({"type": "Polygon", "coordinates": []})",
        R"({"type": "Polygon", "coordinates": [[0, 0], [1, 0], [0, 1]]})", R"({"type": "Feature"})",
        R"({"type": "FeatureCollection"})"})
    EXPECT_NE(refusal_of(text).find("places.geojson: this is no GeoJSON"), std::string::npos)
        << text;
  // No lists, no numbers: the JSON library would take them all the same.
  for (
      const char* text :
      {R"({"type": "MultiPoint", "coordinates": {"a": [1, 2]}})",
       R"({"type": "MultiPoint", "coordinates": null})",
       R"({"type": "MultiPolygon", "coordinates": {"a": [[[0, 0], [1, 0], [0, 1]]]}})",
       R"({"type": "Polygon", "coordinates": [{"a": [0, 0]}]})",
       R"({"type": "FeatureCollection", "features": {"a": {"type": "Feature", "geometry": null}}})",
       R"({"type": "GeometryCollection", "geometries": null})",
       R"({"type": "Point", "coordinates": [true, false]})",
       R"({"type": "Point", "coordinates": {"0": 1, "1": 2}})"})
    EXPECT_NE(refusal_of(text).find("this is no GeoJSON"), std::string::npos) << text;
  EXPECT_NE(refusal_of(R"({"type": "LineString", "coordinates": [[0, 0], [1, 1]]})")
                .find("places.geojson: it has a LineString"),
            std::string::npos);
  for (const char* rings : {"[[]]", "[[[0, 0], [1, 0]]]", "[[[0, 0], [1, 0], [0, 1]], []]"})
    EXPECT_NE(refusal_of(R"({"type": "Polygon", "coordinates": )" + std::string(rings) + "}")
                  .find("ring of fewer than three corners"),
              std::string::npos)
        << rings;
  EXPECT_THROW(read_places("no/such/file.geojson"), FileError);
}

TEST(PlacesFile, says_which_feature_it_cannot_use) {
  const auto second = [](const std::string& geometry) {
    return R"({"type": "FeatureCollection", "features": [{"type": "Feature", "geometry": null},
               {"type": "Feature", "geometry": )" +
           geometry + "}]}";
  };
  const std::string tail = "; points and polygons are what it can hold";
  EXPECT_TRUE(refusal_of(second(R"({"type": "LineString", "coordinates": [[0, 0], [1, 1]]})"))
                  .ends_with("places.geojson, feature 2: it has a LineString" + tail));
  EXPECT_TRUE(refusal_of(second(R"({"type": "MultiPoint", "coordinates": [[0, 0], [1]]})"))
                  .ends_with("places.geojson: this is no GeoJSON: a position is of fewer than two "
                             "numbers in feature 2, position 2" +
                             tail));
  // A corner repeated at the end is no other corner. Heights are not looked at.
  EXPECT_TRUE(
      refusal_of(second(R"({"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [0, 0]]]})"))
          .ends_with("places.geojson, feature 2, ring 1: a polygon's ring of fewer than three "
                     "corners; complete or remove it"));
  EXPECT_EQ(
      places_of(
          second(R"({"type": "Polygon", "coordinates": [[[0, 0, 1], [1, 0], [0, 1, null]]]})"))
          .polygons.size(),
      1u);
}

}  // namespace
}  // namespace hodt
