#include "hodt/io/places_file.h"

#include <numeric>
#include <string>
#include <utility>

#include "hodt/io/file_name.h"
#include "hodt/io/geojson_reader.h"
#include "hodt/io/input_text.h"
#include "hodt/io/point_file.h"

namespace hodt {

namespace {

Places read_table(const std::filesystem::path& path) {
  Places places{read_points(path).xy, {}, display_name(path.string()), "point", {}, {}};
  places.part_of_point.resize(places.points.size());
  std::iota(places.part_of_point.begin(), places.part_of_point.end(), Index{1});
  return places;
}

}  // namespace

Places parse_places(const InputText& text) {
  Places places;
  places.source = text.name;
  places.part = "feature";
  GeoJsonTaker taker;
  taker.can_hold = "points and polygons";
  taker.point = [&](const Point& point, Index feature) {
    places.points.push_back(point);
    places.part_of_point.push_back(feature);
  };
  taker.ring = [&](Line ring, bool outer) {
    if (outer) {
      places.polygons.emplace_back();
      places.part_of_polygon.push_back(ring.part);
    }
    places.polygons.back().rings.push_back(std::move(ring.xy));
  };
  read_geojson(text, taker);
  return places;
}

Places read_places(const std::filesystem::path& path) {
  if (!is_geojson_name(path)) return read_table(path);
  return parse_places(read_input(path));
}

}  // namespace hodt
