#include "hodt/hydrology/minima_to_keep.h"

#include <algorithm>
#include <cmath>

#include "hodt/geometry/predicates.h"
#include "hodt/hydrology/pit_depths.h"

namespace hodt {

namespace {

/// By the number of times that a ray to the right leaves or enters.
bool is_inside(const std::vector<Point>& outline, const Point& p) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point &a = outline[i], &b = outline[(i + 1) % outline.size()];
    const bool up = b.y > a.y;
    if ((a.y > p.y) != (b.y > p.y) && (orient(a, b, p) > 0) == up) inside = !inside;
  }
  return inside;
}

VertexId nearest(std::span<const Point> xy, const Point& place) {
  const auto distance = [&](const Point& p) { return std::hypot(p.x - place.x, p.y - place.y); };
  const auto at = std::min_element(xy.begin(), xy.end(), [&](const Point& a, const Point& b) {
    return distance(a) < distance(b);
  });
  return VertexId(static_cast<Index>(at - xy.begin()));
}

}  // namespace

Buffer<bool> minima_to_keep(const DelaunayGraph& graph, std::span<const double> z, double min_depth,
                            std::span<const Point> places,
                            std::span<const std::vector<Point>> outlines) {
  Buffer<bool> keep(graph.xy.size(), false);
  for (const Pit& pit : pit_depths(graph.mesh, graph.xy, z)) {
    const auto contains = [&](const auto& outline) {
      return is_inside(outline, graph.point(pit.bottom));
    };
    keep[pit.bottom] = (min_depth > 0 && pit.depth >= min_depth) ||
                       std::any_of(outlines.begin(), outlines.end(), contains);
  }
  for (const Point& place : places)
    keep[drains_to(graph.mesh, graph.outgoing.all(), graph.xy, z, nearest(graph.xy, place))] = true;
  return keep;
}

}  // namespace hodt
