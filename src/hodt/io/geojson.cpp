#include "hodt/io/geojson.h"

#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "hodt/io/crs_name.h"
#include "hodt/io/feature_file.h"
#include "hodt/io/feature_texts.h"
#include "hodt/io/number_text.h"

namespace hodt {

namespace {

std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void append_position(std::string& text, const Point& p, const double* z) {
  text += '[';
  append_number(text, p.x);
  text += ',';
  append_number(text, p.y);
  if (z != nullptr) {
    text += ',';
    append_number(text, *z);
  }
  text += ']';
}

/// Begins with the comma that parts it from an earlier feature.
void append_cell(std::string& text, const PolygonFeature& feature) {
  text += ",\n{\"type\":\"Feature\",\"properties\":{\"points\":[";
  for (std::size_t i = 0; i < feature.points.size(); ++i) {
    if (i > 0) text += ',';
    append_number(text, feature.points[i]);
  }
  text += "]},\"geometry\":{\"type\":\"Polygon\",\"coordinates\":[[";
  for (const Point& p : feature.ring) {
    append_position(text, p, nullptr);
    text += ',';
  }
  append_position(text, feature.ring.front(), nullptr);
  text += "]]}}";
}

/// Writes texts of features, each of which begins with a comma, between what they are part of.
class Features {
 public:
  explicit Features(OutputFile& file) : file_(file) {}
  void write(std::string_view text) {
    file_.write(text.substr(is_first_ ? 1 : 0));
    is_first_ = false;
  }

 private:
  OutputFile& file_;
  bool is_first_ = true;
};

void append_value(std::string& text, const FieldValue& value) {
  if (const auto* const whole = std::get_if<std::int64_t>(&value)) {
    char digits[kLongestNumber];
    text.append(digits, std::to_chars(digits, digits + kLongestNumber, *whole).ptr);
  } else if (const auto* const real = std::get_if<double>(&value); real && std::isfinite(*real)) {
    append_number(text, *real);
  } else if (const auto* const words = std::get_if<std::string>(&value)) {
    text += quoted(*words);
  } else {
    text += "null";
  }
}

void append_coordinates(std::string& text, GeometryKind kind, const LayerFeature& feature) {
  const double* const z = feature.z.empty() ? nullptr : feature.z.data();
  if (kind == GeometryKind::point) return append_position(text, feature.xy[0], z);
  text += kind == GeometryKind::polygon ? "[[" : "[";
  for (std::size_t i = 0; i < feature.xy.size(); ++i) {
    if (i > 0) text += ',';
    append_position(text, feature.xy[i], z ? z + i : nullptr);
  }
  if (kind == GeometryKind::polygon) {
    text += ',';
    append_position(text, feature.xy[0], z);
    text += ']';
  }
  text += ']';
}

std::string_view type_name(GeometryKind kind) {
  switch (kind) {
    case GeometryKind::point:
      return "Point";
    case GeometryKind::line:
      return "LineString";
    case GeometryKind::polygon:
      return "Polygon";
  }
  return {};
}

/// What stands around the values and the coordinates of a layer's features, made once.
class FeatureText {
 public:
  explicit FeatureText(const FeatureLayer& layer) : kind_(layer.geometry) {
    for (const Field& field : layer.fields)
      keys_.push_back(fmt::format("{}{}:", keys_.empty() ? "" : ",", quoted(field.name)));
    before_coordinates_ =
        fmt::format("}},\"geometry\":{{\"type\":\"{}\",\"coordinates\":", type_name(kind_));
  }

  void append(const LayerFeature& feature, std::string& text) const {
    text += ",\n{\"type\":\"Feature\",\"properties\":{";
    for (std::size_t i = 0; i < keys_.size(); ++i) {
      text += keys_[i];
      append_value(text, feature.values[i]);
    }
    text += before_coordinates_;
    append_coordinates(text, kind_, feature);
    text += "}}";
  }

 private:
  GeometryKind kind_;
  std::vector<std::string> keys_;
  std::string before_coordinates_;
};

/// The member "crs"; nothing where the system is not known.
std::string crs_member(const std::string& crs) {
  if (crs.empty()) return {};
  return fmt::format("\"crs\":{{\"type\":\"name\",\"properties\":{{\"name\":{}}}}},\n",
                     quoted(crs_urn(crs)));
}

}  // namespace

std::size_t write_geojson(OutputFile& file, const std::string& crs, std::size_t count,
                          const std::function<void(std::size_t, PolygonFeature&)>& make) {
  file.write(fmt::format("{{\"type\":\"FeatureCollection\",{}\"features\":[", crs_member(crs)));
  Features features(file);
  const auto append = [&](std::size_t i, PolygonFeature& feature, std::string& text) {
    make(i, feature);
    if (!feature.ring.empty()) append_cell(text, feature);
    return !feature.ring.empty();
  };
  const std::size_t written = make_feature_texts<PolygonFeature>(
      count, append, [&](std::string_view text) { features.write(text); });
  file.write("\n]}\n");
  return written;
}

void write_geojson_layer(const FeatureLayer& layer, OutputFile& file) {
  file.write(fmt::format("{{\"type\":\"FeatureCollection\",\n\"name\":{},\n{}\"features\":[",
                         quoted(layer_name(layer, file.path())), crs_member(layer.crs)));
  Features features(file);
  const FeatureText in_text(layer);
  const auto append = [&](std::size_t i, LayerFeature& feature, std::string& text) {
    feature.values.resize(layer.fields.size());
    layer.make(i, feature);
    in_text.append(feature, text);
    return true;
  };
  make_feature_texts<LayerFeature>(layer.count, append,
                                   [&](std::string_view text) { features.write(text); });
  file.write("\n]}\n");
}

}  // namespace hodt
