#include "hodt/io/tin_layer.h"

#include "hodt/tin/slope.h"

namespace hodt {

namespace {

void make_triangle(const Tin& tin, std::size_t i, LayerFeature& feature) {
  const PointSet& points = tin.points;
  const auto& [a, b, c] = tin.triangles[i];
  feature.xy.assign({points.xy[a], points.xy[b], points.xy[c]});
  std::size_t field = 0;
  if (!tin.order.empty()) {
    feature.values[field++] = std::int64_t{tin.order[i]};
    feature.values[field++] = std::int64_t{tin.is_changed(i)};
  }
  if (!points.has_heights()) return;
  feature.z.assign({points.z[a], points.z[b], points.z[c]});
  const Slope slope =
      slope_of(points.xy[a], points.xy[b], points.xy[c], points.z[a], points.z[b], points.z[c]);
  feature.values[field++] = slope.slope;
  if (slope.aspect) {
    feature.values[field] = *slope.aspect;
  } else {
    feature.values[field] = std::monostate();
  }
}

}  // namespace

FeatureLayer triangle_layer(const Tin& tin) {
  FeatureLayer layer;
  layer.crs = tin.crs;
  layer.geometry = GeometryKind::polygon;
  layer.has_heights = tin.points.has_heights();
  if (!tin.order.empty())
    layer.fields = {{"order", FieldType::integer}, {"changed", FieldType::integer}};
  if (layer.has_heights) {
    layer.fields.push_back({"slope", FieldType::real});
    layer.fields.push_back({"aspect", FieldType::real});
  }
  layer.count = tin.triangles.size();
  layer.make = [&tin](std::size_t i, LayerFeature& feature) { make_triangle(tin, i, feature); };
  return layer;
}

}  // namespace hodt
