#include "hodt/hydrology/pit_water.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "hodt/hydrology/pit_depths.h"

namespace hodt {

namespace {

double area(const Point& a, const Point& b, const Point& c) {
  return std::fabs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
}

/// The mean over a triangle of the depth, which is linear, counted as 0 where it is negative. The
/// depths at the corners are sorted, the largest first and positive. Sums of products that are not
/// negative: nothing cancels, however thin the wedge.
double mean_depth(double a, double b, double c) {
  if (c >= 0) return (a + b + c) / 3;
  const double along_ac = a / (a - c);  // the share of that side that is under water
  if (b <= 0) return a / 3 * along_ac * (a / (a - b));
  const double along_bc = b / (b - c);
  return ((a + b) * along_bc + a * along_ac * (1 - along_bc)) / 3;
}

}  // namespace

Buffer<double> water_levels(const TriangleMesh& mesh, std::span<const double> z) {
  const Buffer<HalfEdgeId> outgoing = outgoing_halfedges(mesh);
  Buffer<double> levels(z.size(), std::numeric_limits<double>::infinity());
  using Shore = std::pair<double, Index>;
  std::priority_queue<Shore, std::vector<Shore>, std::greater<>> shores;
  const auto reach = [&](Index v, double level) {
    if (level >= levels[v]) return;
    levels[v] = level;
    shores.emplace(level, v);
  };
  for (Index v = 0; v < z.size(); ++v)
    if (outgoing[v].valid() && mesh.is_boundary(outgoing[v])) reach(v, z[v]);
  while (!shores.empty()) {
    const auto [level, v] = shores.top();
    shores.pop();
    // What is reached first is reached lowest, so each vertex enters the queue once.
    for_each_neighbour(mesh, outgoing[v],
                       [&, level = level](VertexId w) { reach(w, std::max(level, z[w])); });
  }
  return levels;
}

double water_volume(const TriangleMesh& mesh, std::span<const Point> xy,
                    std::span<const double> z) {
  const Buffer<double> levels = water_levels(mesh, z);
  double volume = 0;
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    std::array<VertexId, 3> corner = mesh.corners(TriangleId(t));
    std::sort(corner.begin(), corner.end(), [&](VertexId u, VertexId v) { return z[u] < z[v]; });
    const auto [low, middle, high] = corner;
    const double level = levels[low];
    if (level == z[low]) continue;
    volume += area(xy[low], xy[middle], xy[high]) *
              mean_depth(level - z[low], level - z[middle], level - z[high]);
  }
  return volume;
}

PitTotals pit_totals(const TriangleMesh& mesh, std::span<const Point> xy,
                     std::span<const double> z) {
  PitTotals totals;
  const Buffer<HalfEdgeId> outgoing = outgoing_halfedges(mesh);
  for (const Pit& pit : pit_depths(mesh, xy, z)) {
    if (mesh.is_boundary(outgoing[pit.bottom])) continue;
    ++totals.count;
    totals.depth += pit.depth;
    totals.deepest = std::max(totals.deepest, pit.depth);
  }
  totals.volume = water_volume(mesh, xy, z);
  return totals;
}

}  // namespace hodt
