// Lines, outlines and places of a layer of map features.
// Tested by tests/io/gdal_test.cpp.
#include <utility>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/gdal/geometry.h"
#include "hodt/io/gdal/layer.h"
#include "hodt/io/gdal/readers.h"

namespace hodt {

namespace {

bool is_taken(const FeatureTaker& taker, Part kind) {
  if (kind == Part::point) return bool(taker.point);
  if (kind == Part::line) return bool(taker.line);
  return bool(taker.ring);
}

void hand_over(OGRGeometryH part, Part kind, Index feature, const FeatureTaker& taker) {
  if (!is_taken(taker, kind))
    throw InputError(
        fmt::format("it has a {}; {} are what it can hold", name_of(kind), taker.can_hold));
  Line line = positions_of(part, taker.heights);
  line.part = feature;
  if (kind == Part::point) return taker.point(line.xy.front(), feature);
  if (kind == Part::line) {
    if (line.xy.size() < 2)
      throw InputError("it has fewer than two positions; complete or remove it");
    return taker.line(std::move(line));
  }
  if (line.xy.size() < 3 || (line.xy.size() == 3 && line.is_closed()))
    throw InputError("a polygon's ring of fewer than three corners; complete or remove it");
  taker.ring(std::move(line), kind == Part::outer_ring);
}

}  // namespace

std::string read_layer_features(const std::filesystem::path& path, const std::string& name,
                                const FeatureTaker& taker) {
  const Layer layer(path, name);
  const Index labels = layer.for_each(-1, [&](OGRFeatureH feature, Index number) {
    const OGRGeometryH geometry = gdal().OGR_F_GetGeometryRef(feature);
    if (!geometry) return;  // a feature may be nowhere
    if (gdal().OGR_G_IsEmpty(geometry) && !taker.skips_empty)
      throw InputError("its geometry is empty; complete or remove it");
    for_each_part(geometry,
                  [&](OGRGeometryH part, Part kind) { hand_over(part, kind, number, taker); });
  });
  if (taker.warning)
    for (std::string& warning : label_warnings(labels)) taker.warning(std::move(warning));
  return layer.crs();
}

}  // namespace hodt
