#include "app/what_changed.h"

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/feature_file.h"

namespace hodt::app {

namespace {

std::string name_of(Fate fate) {
  switch (fate) {
    case Fate::removed:
      return "removed";
    case Fate::kept:
      return "kept";
    case Fate::left:
      return "left";
    case Fate::made:
      return "new";
  }
  return {};
}

void append_position(const PointSet& points, Index v, LayerFeature& feature) {
  feature.xy.push_back(points.xy[v]);
  if (points.has_heights()) feature.z.push_back(points.z[v]);
}

/// Depth and volume, or nothing.
void append_size(const std::optional<PitSize>& size, std::vector<FieldValue>& values) {
  values.push_back(size ? FieldValue(size->depth) : FieldValue());
  values.push_back(size ? FieldValue(size->volume) : FieldValue());
}

FeatureLayer layer_of(const Tin& tin, GeometryKind geometry) {
  FeatureLayer layer;
  layer.crs = tin.crs;
  layer.geometry = geometry;
  layer.has_heights = tin.points.has_heights();
  return layer;
}

/// The names fit into ten bytes, which is what a shapefile has for them.
FeatureLayer pits_layer(const Tin& tin, const std::vector<MinimumChange>& minima) {
  using enum FieldType;
  FeatureLayer layer = layer_of(tin, GeometryKind::point);
  layer.fields = {{"vertex", integer}, {"fate", text},       {"boundary", integer},
                  {"pit", integer},    {"depth", real},      {"volume", real},
                  {"new_depth", real}, {"new_volume", real}, {"drains_to", integer},
                  {"drain_x", real},   {"drain_y", real},    {"drain_z", real}};
  layer.count = minima.size();
  layer.make = [&](std::size_t i, LayerFeature& feature) {
    const MinimumChange& minimum = minima[i];
    const PointSet& points = tin.points;
    feature = {};
    append_position(points, minimum.vertex, feature);
    feature.values = {std::int64_t{minimum.vertex}, name_of(minimum.fate),
                      std::int64_t{minimum.on_boundary}, std::int64_t{minimum.is_pit}};
    append_size(minimum.before, feature.values);
    append_size(minimum.after, feature.values);
    if (const Index to = minimum.drains_to; to != kNone) {
      feature.values.push_back(std::int64_t{to});
      for (const double value : {points.xy[to].x, points.xy[to].y, points.z[to]})
        feature.values.push_back(value);
    }
    feature.values.resize(12);
  };
  return layer;
}

FeatureLayer edges_layer(const Tin& tin, const std::vector<EdgeChange>& edges) {
  FeatureLayer layer = layer_of(tin, GeometryKind::line);
  layer.fields = {{"kind", FieldType::text},
                  {"order", FieldType::integer},
                  {"u", FieldType::integer},
                  {"v", FieldType::integer}};
  layer.count = edges.size();
  layer.make = [&](std::size_t i, LayerFeature& feature) {
    const EdgeChange& edge = edges[i];
    feature = {};
    append_position(tin.points, edge.u, feature);
    append_position(tin.points, edge.v, feature);
    feature.values = {std::string(edge.is_new ? "new" : "old"),
                      edge.is_new ? FieldValue(std::int64_t{edge.order}) : FieldValue(),
                      std::int64_t{edge.u}, std::int64_t{edge.v}};
  };
  return layer;
}

}  // namespace

void add_changes(CLI::App& command, ChangesArguments& arguments) {
  command
      .add_option("--pits", arguments.pits,
                  "Write local minima before and after, as points: removed, kept, left or new,\n"
                  "depth, volume, and what a removed one drains to (.gpkg, .geojson, ...)")
      ->type_name("FILE");
  command
      .add_option("--changed", arguments.changed,
                  "Write edges that went and that came, as lines with their orders")
      ->type_name("FILE");
}

void check_changes(const ChangesArguments& arguments, std::span<const std::string> read,
                   std::span<const std::string> written) {
  std::vector<std::string> others(written.begin(), written.end());
  for (const auto& [option, file] :
       {std::pair{"--pits", arguments.pits}, std::pair{"--changed", arguments.changed}}) {
    if (file.empty()) continue;
    check_features_extension(file);
    for (const std::string& input : read) check_targets(input, file, {});
    check_other_outputs(option, file, others);
    others.push_back(file);
  }
}

void write_changes(const ChangesArguments& arguments, const TriangulateResult& result,
                   Outputs& outputs) {
  if (!arguments.pits.empty()) {
    if (!result.tin.points.has_heights())
      throw ParameterError("--pits needs heights, and the points have none; add a z column");
    write_features(pits_layer(result.tin, result.report.changes.minima),
                   outputs.open(arguments.pits));
  }
  if (!arguments.changed.empty())
    write_features(edges_layer(result.tin, result.report.changes.edges),
                   outputs.open(arguments.changed));
}

}  // namespace hodt::app
