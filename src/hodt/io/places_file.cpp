#include "hodt/io/places_file.h"

#include <functional>
#include <numeric>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/formats.h"
#include "hodt/io/geojson_reader.h"
#include "hodt/io/input_text.h"
#include "hodt/io/point_file.h"

namespace hodt {

namespace {

Places read_table(const std::filesystem::path& path) {
  PointSet points = read_points(path);
  Places places{std::move(points.xy), {}, display_name(path.string()), "point", {}, {}};
  places.crs = std::move(points.crs);
  places.part_of_point.resize(places.points.size());
  std::iota(places.part_of_point.begin(), places.part_of_point.end(), Index{1});
  return places;
}

Places places_of(const std::string& name,
                 const std::function<std::string(const FeatureTaker&)>& read) {
  Places places;
  places.source = name;
  places.part = "feature";
  FeatureTaker taker;
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
  taker.warning = [&](std::string warning) { places.warnings.push_back(std::move(warning)); };
  places.crs = read(taker);
  return places;
}

}  // namespace

Places parse_places(const InputText& text) {
  return places_of(text.name, [&](const FeatureTaker& taker) { return read_geojson(text, taker); });
}

Places read_places(const std::filesystem::path& path, const std::string& layer) {
  const Format* format = find_format(path, Use::read_features);
  if (!format && layer.empty()) return read_table(path);
  if (!format)
    throw ParameterError(
        fmt::format("{} is a table, which has no layers, and no '{}'", display_name(path), layer));
  return places_of(display_name(path), [&](const FeatureTaker& taker) {
    return format->read_features(path, layer, taker);
  });
}

}  // namespace hodt
