#include "hodt/io/geojson_reader.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "hodt/base/error.h"
#include "hodt/io/crs.h"
#include "hodt/io/text_encoding.h"
#include "hodt/io/text_lines.h"

namespace hodt {

namespace {

using Json = nlohmann::json;

/// What makes a text no GeoJSON; "" if there is nothing to say about it.
struct NoGeoJson {
  std::string why;
};

/// All errors that say that a text is no GeoJSON.
[[noreturn]] void refuse_text(const InputText& text, const FeatureTaker& taker,
                              const std::string& why, const std::string& where) {
  throw InputError(fmt::format("{}: this is no GeoJSON{}{}{}; {} are what it can hold", text.name,
                               why.empty() ? "" : ": " + why, where.empty() ? "" : " in ", where,
                               taker.can_hold));
}

/// Goes over a text that is no JSON once more, to see where it stops being any.
class FaultFinder : public nlohmann::json_sax<Json> {
 public:
  explicit FaultFinder(const InputText& text) : text_(text) {}

  /// The fault, and behind "in" where it is.
  std::pair<std::string, std::string> find() && {
    Json::sax_parse(text_.view(), this);
    // The fault is the last character that was read.
    const std::string_view read = text_.view().substr(0, std::max<std::size_t>(read_, 1) - 1);
    const std::size_t column = read.size() - (read.rfind('\n') + 1);
    return {std::move(fault_),
            fmt::format("line {} of the text, column {}",
                        1 + count_line_feeds(read.data(), read.data() + read.size()), column + 1)};
  }

  bool parse_error(std::size_t read, const std::string& token,
                   const Json::exception& error) override {
    read_ = std::min(read, text_.size);
    constexpr int overflow = 406;
    if (error.id == overflow) fault_ = fmt::format("{} is too large a number", in_quotes(token));
    return false;
  }

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return true; }
  bool key(string_t&) override { return true; }
  bool end_object() override { return true; }
  bool start_array(std::size_t) override { return true; }
  bool end_array() override { return true; }

 private:
  const InputText& text_;
  std::size_t read_ = 0;
  std::string fault_;
};

Json parsed(const InputText& text, const FeatureTaker& taker) {
  try {
    return Json::parse(text.view());
  } catch (const Json::exception&) {
    const auto [why, where] = FaultFinder(text).find();
    refuse_text(text, taker, why, where);
  }
}

/// The JSON library would go through an object as well, and take true for 1.
const Json& list(const Json& value) {
  if (!value.is_array()) throw NoGeoJson{};
  return value;
}

double number(const Json& value) {
  if (!value.is_number()) throw NoGeoJson{"a coordinate is no number"};
  return value.get<double>();
}

Point point_of(const Json& position) {
  if (list(position).size() < 2) throw NoGeoJson{"a position is of fewer than two numbers"};
  return {number(position[0]), number(position[1])};
}

class Walker {
 public:
  Walker(const InputText& text, const FeatureTaker& taker) : text_(text), taker_(taker) {}

  /// Goes through all that the object holds. Not recursive: a file may be nested deeper than the
  /// stack.
  void walk(const Json& root) {
    try {
      open_.push_back(&root);
      while (!open_.empty()) {
        const Json& next = *open_.back();
        open_.pop_back();
        add(next);
      }
    } catch (const NoGeoJson& fault) {
      refuse_text(text_, taker_, fault.why, place());
    } catch (const Json::exception&) {
      refuse_text(text_, taker_, {}, place());
    } catch (const InputError& error) {
      const std::string where = place();
      throw InputError(
          fmt::format("{}{}{}: {}", text_.name, where.empty() ? "" : ", ", where, error.what()));
    }
  }

 private:
  /// Where the walk is, for messages: "feature 3, line 2, position 4".
  std::string place() const {
    std::string place;
    if (features_ > 0 || list_name_) place = fmt::format("feature {}", feature());
    if (list_name_) place += fmt::format(", {} {}", list_name_, lists_);
    if (positions_ > 0) place += fmt::format(", position {}", positions_);
    return place;
  }
  Index feature() const { return std::max(features_, Index{1}); }

  void add(const Json& object) {
    const std::string& type = object.at("type").get_ref<const std::string&>();
    if (type == "FeatureCollection") return open(object.at("features"));
    if (type == "GeometryCollection") return open(object.at("geometries"));
    if (type == "Feature") {
      ++features_;
      lists_ = 0;
      const Json& geometry = object.at("geometry");
      if (!geometry.is_null()) open_.push_back(&geometry);  // a feature may be nowhere
      return;
    }
    add_geometry(type, object);
    list_name_ = nullptr;
    positions_ = 0;
  }

  /// The first member is to be the next.
  void open(const Json& members) {
    for (std::size_t i = list(members).size(); i-- > 0;) open_.push_back(&members.at(i));
  }

  void add_geometry(const std::string& type, const Json& geometry) {
    const bool points = type == "Point" || type == "MultiPoint";
    const bool lines = type == "LineString" || type == "MultiLineString";
    const bool polygons = type == "Polygon" || type == "MultiPolygon";
    if (!points && !lines && !polygons) refuse(in_quotes(type));
    if ((points && !taker_.point) || (lines && !taker_.line) || (polygons && !taker_.ring))
      refuse(type);
    const Json& coordinates = geometry.at("coordinates");
    if (list(coordinates).empty() && taker_.skips_empty) return;
    if (!type.starts_with("Multi")) return add_part(coordinates, points, lines);
    for (const Json& part : coordinates) {
      if (points) ++positions_;
      add_part(part, points, lines);
    }
  }

  void add_part(const Json& part, bool is_point, bool is_line) {
    if (is_point) return taker_.point(point_of(part), feature());
    if (is_line) return add_line(part);
    if (list(part).empty()) throw NoGeoJson{"a polygon without a ring"};
    for (const Json& ring : part) add_ring(ring, &ring == &part.front());
  }

  void add_line(const Json& positions) {
    Line line = line_of(positions, "line");
    if (line.xy.size() < 2)
      throw InputError("it has fewer than two positions; complete or remove it");
    taker_.line(std::move(line));
  }

  void add_ring(const Json& positions, bool outer) {
    Line ring = line_of(positions, "ring");
    if (ring.xy.size() < 3 || (ring.xy.size() == 3 && ring.is_closed()))
      throw InputError("a polygon's ring of fewer than three corners; complete or remove it");
    taker_.ring(std::move(ring), outer);
  }

  Line line_of(const Json& positions, const char* name) {
    ++lists_;
    list_name_ = name;
    Line line{{}, {}, feature()};
    line.xy.reserve(list(positions).size());
    for (const Json& position : positions) {
      ++positions_;
      line.xy.push_back(point_of(position));
      if (taker_.heights) add_height(position, line);
    }
    positions_ = 0;
    return line;
  }

  /// Of the position that is the line's last. What a position has behind its height means nothing.
  static void add_height(const Json& position, Line& line) {
    const bool has_height = position.size() > 2;
    if (line.xy.size() > 1 && has_height != line.has_heights())
      throw InputError(fmt::format(
          "it has {} height, unlike those before; give each position of a line one, or none",
          has_height ? "a" : "no"));
    if (has_height) line.z.push_back(number(position[2]));
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(fmt::format("it has a {}; {} are what it can hold", what, taker_.can_hold));
  }

  const InputText& text_;
  const FeatureTaker& taker_;
  std::vector<const Json*> open_;
  Index features_ = 0;               // begun so far
  std::size_t lists_ = 0;            // lines and rings of the feature so far
  const char* list_name_ = nullptr;  // what the walk is in: "line", "ring"
  std::size_t positions_ = 0;        // of that so far
};

/// Empty if there is no name.
std::string crs_name(const Json& root) {
  const Json::json_pointer name("/crs/properties/name");
  const bool has_name = root.contains(name) && root.at(name).is_string();
  return has_name ? crs_of_urn(root.at(name).get<std::string>()) : std::string();
}

}  // namespace

std::string read_geojson(const InputText& text, const FeatureTaker& taker) {
  const Json root = parsed(text, taker);
  Walker(text, taker).walk(root);
  return crs_name(root);
}

GeoJsonCrs crs_of_geojson(const InputText& text) {
  constexpr std::string_view key = "\"crs\"";
  if (text.view().find(key) == std::string_view::npos) return {};
  // All else is read over.
  const auto is_crs = [](int depth, Json::parse_event_t event, const Json& parsed) {
    return depth != 1 || event != Json::parse_event_t::key || parsed == "crs";
  };
  const Json root = Json::parse(text.view(), is_crs, false);
  if (!root.is_object() || !root.contains("crs")) return {};
  const Json& crs = root.at("crs");
  constexpr std::size_t longest = 80;
  return {true, crs.is_null(), crs_name(root), crs.dump().substr(0, longest)};
}

}  // namespace hodt
