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

/// The half-edge of the place in the Delaunay triangulation that leaves the corner which it lost.
HalfEdgeId from_lost_corner(const TriangleMesh& delaunay, TriangleId place,
                            const Corners& corners) {
  HalfEdgeId h = TriangleMesh::halfedge(place);
  while (has(corners, delaunay.origin(h))) h = HalfEdgeId(h + 1);
  return h;
}

/// Whether a circle holds one point only, the origin of h, given the corners on it, which the
/// triangle of h has but for one: points inside are connected in the Delaunay graph, so it is
/// enough to ask the neighbours. False, too, if the boundary is in the way, or they are very many.
bool holds_only_origin(const DelaunayGraph& graph, const Corners& corners, HalfEdgeId h) {
  const TriangleMesh& mesh = graph.mesh;
  if (graph.is_hub(mesh.origin(h))) return false;
  const auto [a, b, c] = corners;
  const Circle circle(graph.point(a), graph.point(b), graph.point(c));
  if (!circle.contains(graph.point(mesh.origin(h)))) return false;
  const VertexId last = mesh.target(h);
  for (h = mesh.rotate_ccw(h); h.valid() && mesh.apex(h) != last; h = mesh.rotate_ccw(h)) {
    const VertexId v = mesh.apex(h);
    if (!has(corners, v) && circle.contains(graph.point(v))) return false;
  }
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
      if (holds_only_origin(graph, corners, lost)) {
        orders[i] = 1;
        continue;
      }
      const auto [a, b, c] = corners;
      orders[i] = counter.count(a, b, c, kUnlimited, graph.mesh.origin(lost));
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
