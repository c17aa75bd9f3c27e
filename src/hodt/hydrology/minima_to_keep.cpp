#include "hodt/hydrology/minima_to_keep.h"

#include <algorithm>

#include "hodt/hydrology/check_places.h"
#include "hodt/hydrology/nearest_points.h"
#include "hodt/hydrology/pit_depths.h"
#include "hodt/hydrology/points_in_polygons.h"

namespace hodt {

MinimaToKeep minima_to_keep(const DelaunayGraph& graph, std::span<const double> z, double min_depth,
                            const Places& places) {
  check_places(places, graph.xy);
  const PointsInPolygons in_polygons = points_in_polygons(graph.xy, places.polygons);
  check_polygons_hold_points(places, in_polygons.holds_point);

  MinimaToKeep minima;
  minima.empty_polygons = std::size_t(
      std::count(in_polygons.holds_point.begin(), in_polygons.holds_point.end(), false));
  minima.is_kept = Buffer<bool>(graph.xy.size(), false);
  for (const Pit& pit : pit_depths(graph.mesh, graph.xy, z))
    minima.is_kept[pit.bottom] =
        (min_depth > 0 && pit.depth >= min_depth) || in_polygons.is_inside[pit.bottom];
  for (const VertexId v : nearest_points(graph.xy, places.points))
    minima.is_kept[drains_to(graph.mesh, graph.outgoing.all(), graph.xy, z, v)] = true;
  minima.count = std::size_t(std::count(minima.is_kept.begin(), minima.is_kept.end(), true));
  return minima;
}

}  // namespace hodt
