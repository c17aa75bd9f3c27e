#include "hodt/io/places_file.h"

#include <string>
#include <string_view>
#include <utility>

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

std::vector<Point> points_of(const Json& positions) {
  std::vector<Point> points;
  for (const Json& position : list(positions)) points.push_back(point_of(position));
  return points;
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
      const Json& geometry = object.at("geometry");
      if (!geometry.is_null()) open_.push_back(&geometry);  // a feature may be nowhere
      return;
    }
    add_geometry(type, object);
  }

  void open(const Json& members) {
    for (const Json& member : list(members)) open_.push_back(&member);
  }

  void add_geometry(std::string_view type, const Json& geometry) {
    const auto coordinates = [&]() -> const Json& { return geometry.at("coordinates"); };
    if (type == "Point")
      places_.points.push_back(point_of(coordinates()));
    else if (type == "MultiPoint")
      for (const Json& position : list(coordinates())) places_.points.push_back(point_of(position));
    else if (type == "Polygon")
      places_.outlines.push_back(points_of(list(coordinates()).at(0)));
    else if (type == "MultiPolygon")
      for (const Json& polygon : list(coordinates()))
        places_.outlines.push_back(points_of(list(polygon).at(0)));
    else
      throw InputError(fmt::format("it has a {}", type));
  }

  std::vector<const Json*> open_;
  Places places_;
};

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
    return collected();
  } catch (const InputError& error) {
    throw InputError(
        fmt::format("{}: {}; points and polygons are what it can hold", text.name, error.what()));
  }
}

Places read_places(const std::filesystem::path& path) {
  if (const std::string extension = format_extension(path);
      extension != ".geojson" && extension != ".json")
    return {read_points(path).xy, {}};
  return parse_places(read_input(path));
}

}  // namespace hodt
