#include "hodt/io/places_file.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "hodt/base/error.h"
#include "hodt/io/file_name.h"
#include "hodt/io/input_text.h"
#include "hodt/io/point_file.h"

namespace hodt {

namespace {

using Json = nlohmann::json;

[[noreturn]] void refuse_syntax() {
  throw InputError("this is no GeoJSON");
}

/// The JSON library would go through an object as well, and take true for 1.
const Json& list(const Json& value) {
  if (!value.is_array()) refuse_syntax();
  return value;
}

double number(const Json& value) {
  if (!value.is_number()) refuse_syntax();
  return value.get<double>();
}

Point point_of(const Json& position) {
  return {number(list(position).at(0)), number(position.at(1))};
}

/// Corners of a polygon. A ring of fewer is no ring.
std::vector<Point> ring_of(const Json& positions) {
  std::vector<Point> ring;
  for (const Json& position : list(positions)) ring.push_back(point_of(position));
  if (ring.size() < 3) throw InputError("it has a polygon's ring of fewer than three corners");
  return ring;
}

class Collector {
 public:
  /// All that the object holds. Not recursive: a file may be nested deeper than the stack.
  Places collect(const Json& object) && {
    open_.push_back(&object);
    while (!open_.empty()) {
      const Json& next = *open_.back();
      open_.pop_back();
      add(next);
    }
    return std::move(places_);
  }

 private:
  void add(const Json& object) {
    const std::string& type = object.at("type").get_ref<const std::string&>();
    if (type == "FeatureCollection") return open(object.at("features"));
    if (type == "GeometryCollection") return open(object.at("geometries"));
    if (type == "Feature") {
      ++features_;
      const Json& geometry = object.at("geometry");
      if (!geometry.is_null()) open_.push_back(&geometry);  // a feature may be nowhere
      return;
    }
    add_geometry(type, object);
  }

  /// The first member is to be the next.
  void open(const Json& members) {
    for (std::size_t i = list(members).size(); i-- > 0;) open_.push_back(&members.at(i));
  }

  void add_geometry(std::string_view type, const Json& geometry) {
    const auto coordinates = [&]() -> const Json& { return geometry.at("coordinates"); };
    if (type == "Point")
      add_point(coordinates());
    else if (type == "MultiPoint")
      for (const Json& position : list(coordinates())) add_point(position);
    else if (type == "Polygon")
      add_polygon(coordinates());
    else if (type == "MultiPolygon")
      for (const Json& polygon : list(coordinates())) add_polygon(polygon);
    else
      throw InputError(fmt::format("it has a {}", type));
  }

  void add_point(const Json& position) {
    places_.points.push_back(point_of(position));
    places_.part_of_point.push_back(std::max(features_, Index{1}));
  }

  void add_polygon(const Json& rings) {
    Polygon polygon{{ring_of(list(rings).at(0))}};
    for (std::size_t i = 1; i < rings.size(); ++i) polygon.rings.push_back(ring_of(rings.at(i)));
    places_.polygons.push_back(std::move(polygon));
    places_.part_of_polygon.push_back(std::max(features_, Index{1}));
  }

  std::vector<const Json*> open_;
  Index features_ = 0;  // begun so far; a geometry alone is one
  Places places_;
};

Places read_table(const std::filesystem::path& path) {
  Places places{read_points(path).xy, {}, display_name(path.string()), "point", {}, {}};
  places.part_of_point.resize(places.points.size());
  std::iota(places.part_of_point.begin(), places.part_of_point.end(), Index{1});
  return places;
}

}  // namespace

Places parse_places(const InputText& text) {
  const auto collected = [&] {
    try {
      return Collector().collect(Json::parse(text.view()));
    } catch (const Json::exception&) {
      refuse_syntax();
    }
  };
  try {
    Places places = collected();
    places.source = text.name;
    places.part = "feature";
    return places;
  } catch (const InputError& error) {
    throw InputError(
        fmt::format("{}: {}; points and polygons are what it can hold", text.name, error.what()));
  }
}

Places read_places(const std::filesystem::path& path) {
  if (const std::string extension = format_extension(path);
      extension != ".geojson" && extension != ".json")
    return read_table(path);
  return parse_places(read_input(path));
}

}  // namespace hodt
