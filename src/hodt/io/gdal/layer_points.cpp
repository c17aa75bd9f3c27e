// Points of a layer of map features.
// Tested by tests/io/gdal_test.cpp.
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "hodt/base/error.h"
#include "hodt/io/crs.h"
#include "hodt/io/gdal/geometry.h"
#include "hodt/io/gdal/layer.h"
#include "hodt/io/gdal/readers.h"
#include "hodt/io/geojson_reader.h"
#include "hodt/io/input_text.h"
#include "hodt/io/point_doubts.h"

namespace hodt {

namespace {

class PointTaker {
 public:
  PointTaker(const Layer& layer, const LayerChoice& choice) : layer_(layer), choice_(choice) {
    if (!choice.z_field.empty()) field_ = layer.number_field(choice.z_field);
    points_.xy.reserve(layer.size());
    if (!choice.no_z) points_.z.reserve(layer.size());
  }

  PointSet take_all() {
    labels_ = layer_.for_each(field_, [&](OGRFeatureH feature, Index) { take(feature); });
    return std::move(points_);
  }
  Index labels() const { return labels_; }
  std::size_t features() const { return features_; }
  std::size_t without_geometry() const { return without_geometry_; }

 private:
  void take(OGRFeatureH feature) {
    ++features_;
    const std::size_t before = points_.size();
    if (const OGRGeometryH geometry = gdal().OGR_F_GetGeometryRef(feature))
      for_each_part(geometry, [&](OGRGeometryH part, Part kind) { add(feature, part, kind); });
    if (points_.size() == before) ++without_geometry_;
    if (points_.size() >= kNone) throw InputError("with it there are too many points for hodt");
  }

  void add(OGRFeatureH feature, OGRGeometryH part, Part kind) {
    if (kind != Part::point && !choice_.vertices)
      throw InputError(
          fmt::format("it is a {}; --vertices takes the vertices of lines and polygons as points",
                      name_of(kind)));
    const bool of_geometry = field_ < 0 && !choice_.no_z;
    Line line = positions_of(part, of_geometry);
    if (of_geometry && line.z.empty()) refuse_flat();
    // A ring's last vertex is its first one.
    if (kind != Part::point && line.xy.size() > 1 && line.is_closed() &&
        (line.z.empty() || line.z.front() == line.z.back())) {
      line.xy.pop_back();
      if (!line.z.empty()) line.z.pop_back();
    }
    points_.xy.insert(points_.xy.end(), line.xy.begin(), line.xy.end());
    points_.z.insert(points_.z.end(), line.z.begin(), line.z.end());
    if (field_ >= 0) points_.z.insert(points_.z.end(), line.xy.size(), height_of(feature));
  }

  double height_of(OGRFeatureH feature) const {
    const double z = gdal().OGR_F_IsFieldSetAndNotNull(feature, field_)
                         ? gdal().OGR_F_GetFieldAsDouble(feature, field_)
                         : std::nan("");
    if (!std::isfinite(z))
      throw InputError(fmt::format(
          "its field '{}' holds no number; give it one, or remove the feature", choice_.z_field));
    return z;
  }

  [[noreturn]] void refuse_flat() const {
    const std::vector<std::string> fields = layer_.fields();
    throw InputError(fmt::format(
        "its geometry has no z; name the field that holds the heights with --z-field{}, or add "
        "--no-z for x and y alone",
        fields.empty() ? " (it has none)" : fmt::format(" ({})", fmt::join(fields, ", "))));
  }

  const Layer& layer_;
  const LayerChoice& choice_;
  int field_ = -1;
  PointSet points_;
  Index labels_ = 0;
  std::size_t features_ = 0, without_geometry_ = 0;
};

/// "layer 'spots': x and y of its points, z = field 'height'".
std::string source_text(const Layer& layer, const LayerChoice& choice) {
  const char* const parts = choice.vertices ? "vertices" : "points";
  if (choice.no_z) return fmt::format("x and y of the {} of layer '{}', no z", parts, layer.name());
  if (choice.z_field.empty())
    return fmt::format("x, y and z of the {} of layer '{}'", parts, layer.name());
  return fmt::format("x and y of the {} of layer '{}', z = field '{}'", parts, layer.name(),
                     choice.z_field);
}

/// WGS 84 in two or three dimensions, which is what GDAL says of GeoJSON that says nothing.
bool is_world(const std::string& crs) {
  return crs == "EPSG:4326" || crs == "EPSG:4979";
}

bool are_degrees(const PointSet& points) {
  return std::all_of(points.xy.begin(), points.xy.end(),
                     [](const Point& p) { return std::fabs(p.x) <= 180 && std::fabs(p.y) <= 90; });
}

/// Whether a name that may be anything is one of WGS 84. GDAL would look up addresses.
bool is_name_of_world(const std::string& name) {
  const bool is_address = name.find("://") != name.npos;
  const bool is_known_address = name.starts_with("http://www.opengis.net/def/crs/") ||
                                name.starts_with("https://www.opengis.net/def/crs/");
  return (!is_address || is_known_address) && is_same_crs(name, "EPSG:4326");
}

/// GDAL takes GeoJSON for WGS 84 that says nothing, which is right, but also what says something
/// that GDAL does not understand.
void check_world(const InputText& text, PointTable& table) {
  if (!are_degrees(table.points)) {
    table.points.crs.clear();
    table.warnings.emplace_back(
        "by the standard GeoJSON is WGS 84, but these are no degrees: the coordinate reference "
        "system is unknown; say it with --crs");
    return;
  }
  const GeoJsonCrs crs = crs_of_geojson(text);
  if (!crs.is_there || is_name_of_world(crs.name)) return;
  table.points.crs.clear();
  if (!crs.is_null)
    table.warnings.push_back(
        fmt::format("its member crs, {}, is not understood: the coordinate reference system is "
                    "unknown; say it with --crs",
                    crs.text));
}

}  // namespace

PointTable read_layer_points(const std::filesystem::path& path, const PointChoice& choice) {
  const std::string name = display_name(path);
  check_choice(choice, PointKind::features, name);
  if (choice.layer.no_z && !choice.layer.z_field.empty())
    throw ParameterError("--z-field and --no-z cannot both be given");
  const Layer layer(path, choice.layer.layer);
  PointTaker taker(layer, choice.layer);
  PointTable table;
  table.points = taker.take_all();
  if (table.points.size() == 0)
    throw InputError(fmt::format("{}: its layer '{}' holds no points", name, layer.name()));
  table.columns.source = source_text(layer, choice.layer);
  if (taker.without_geometry() > 0)
    table.warnings.push_back(fmt::format("{} of {} features have no geometry and are left out",
                                         taker.without_geometry(), taker.features()));
  for (std::string& warning : label_warnings(taker.labels()))
    table.warnings.push_back(std::move(warning));
  table.points.crs = layer.crs();
  const bool is_geojson = layer.driver() == "GeoJSON" || layer.driver() == "GeoJSONSeq";
  if (is_geojson && is_world(table.points.crs)) check_world(read_input(path), table);
  for (std::string& warning : warn_of_no_data(table.points))
    table.warnings.push_back(std::move(warning));
  return table;
}

}  // namespace hodt
