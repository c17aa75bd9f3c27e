#include "hodt/hydrology/pit_water.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "hodt/hydrology/rising_lakes.h"
#include "hodt/hydrology/wet_triangle.h"

namespace hodt {

std::vector<double> pit_volumes(const TriangleMesh& mesh, std::span<const Point> xy,
                                std::span<const double> z, std::span<const Pit> pits) {
  std::vector<double> volumes(pits.size(), 0);
  std::vector<std::size_t> order;  // the lowest level first
  for (std::size_t i = 0; i < pits.size(); ++i)
    if (pits[i].depth > 0) order.push_back(i);
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return pits[i].level < pits[j].level || (pits[i].level == pits[j].level && i < j);
  });
  std::vector<double> levels;
  for (const std::size_t i : order)
    if (levels.empty() || levels.back() != pits[i].level) levels.push_back(pits[i].level);
  RisingLakes lakes(mesh, xy, z, levels);
  auto next = order.begin();
  for (const double level : levels) {
    lakes.rise();
    for (; next != order.end() && pits[*next].level == level; ++next)
      volumes[*next] = lakes.volume_at(pits[*next].bottom);
  }
  return volumes;
}

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
    const auto [a, b, c] = mesh.corners(TriangleId(t));
    // Water over a triangle stands as high as at its lowest corner.
    const VertexId low = z[b] < z[a] ? (z[c] < z[b] ? c : b) : (z[c] < z[a] ? c : a);
    volume += WetTriangle(mesh, TriangleId(t), xy, z).volume(levels[low]);
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
