#include "hodt/order/triangulation_order.h"

#include <algorithm>
#include <array>

#include "hodt/base/parallel.h"
#include "hodt/order/circle_counter.h"

namespace hodt {

namespace {

using Corners = std::array<VertexId, 3>;

bool has(const Corners& corners, VertexId v) {
  return corners[0] == v || corners[1] == v || corners[2] == v;
}

/// The half-edge of the place in the Delaunay triangulation that leaves a corner which it lost;
/// kNone if it has the same corners in another order.
HalfEdgeId from_lost_corner(const TriangleMesh& delaunay, TriangleId place,
                            const Corners& corners) {
  for (Index i = 0; i < 3; ++i)
    if (const HalfEdgeId h(3 * place + i); !has(corners, delaunay.origin(h))) return h;
  return {};
}

/// Whether the circle through the corners holds one point only, the origin of `start`: points
/// inside are connected in the Delaunay graph, so it is enough to ask the neighbours. False, too,
/// if these are very many, or the boundary is in the way.
bool holds_only_origin(const DelaunayGraph& graph, const Corners& corners, HalfEdgeId start) {
  const TriangleMesh& mesh = graph.mesh;
  const VertexId origin = mesh.origin(start);
  const auto [a, b, c] = corners;
  const Circle circle(graph.point(a), graph.point(b), graph.point(c));
  if (graph.is_hub(origin) || !circle.contains(graph.point(origin))) return false;
  HalfEdgeId h = start;
  do {
    const VertexId v = mesh.target(h);
    if (!has(corners, v) && circle.contains(graph.point(v))) return false;
    h = mesh.rotate_ccw(h);
  } while (h.valid() && h != start);
  return h.valid();
}

}  // namespace

std::vector<std::size_t> order_histogram(const DelaunayGraph& graph, const TriangleMesh& mesh) {
  const auto find_changed = [&](std::size_t first, std::size_t last,
                                std::vector<TriangleId>& found) {
    for (auto t = TriangleId(Index(first)); t < last; t = TriangleId(t + 1))
      if (mesh.corners(t) != graph.mesh.corners(t)) found.push_back(t);
  };
  const std::vector<TriangleId> changed =
      parallel_collect<TriangleId>(0, mesh.triangle_count(), 1 << 14, find_changed);
  std::vector<Index> orders(changed.size());
  PerThread<CircleCounter> counters([&] { return CircleCounter(graph); });
  parallel_for(0, changed.size(), 256, [&](std::size_t first, std::size_t last) {
    CircleCounter& counter = counters.mine();
    for (std::size_t i = first; i < last; ++i) {
      const Corners corners = mesh.corners(changed[i]);
      // A flip's triangle has the corner in its circle that its place had before.
      const HalfEdgeId lost = from_lost_corner(graph.mesh, changed[i], corners);
      if (lost.valid() && holds_only_origin(graph, corners, lost)) {
        orders[i] = 1;
        continue;
      }
      const auto [a, b, c] = corners;
      orders[i] =
          counter.count(a, b, c, kUnlimited, lost.valid() ? graph.mesh.origin(lost) : VertexId());
    }
  });

  std::vector<std::size_t> histogram(1, mesh.triangle_count() - changed.size());
  for (const Index order : orders) {
    if (histogram.size() <= order) histogram.resize(order + 1, 0);
    ++histogram[order];
  }
  return histogram;
}

}  // namespace hodt
