#include "hodt/order/triangulation_order.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "hodt/base/parallel.h"
#include "hodt/order/circle_counter.h"

namespace hodt {

namespace {

/// The half-edge that leaves a corner which the triangle has and these are not; kNone if there is
/// none.
HalfEdgeId from_lost_corner(const TriangleMesh& mesh, TriangleId t,
                            const std::array<VertexId, 3>& after) {
  for (Index i = 0; i < 3; ++i) {
    const HalfEdgeId h(TriangleMesh::halfedge(t) + i);
    if (std::find(after.begin(), after.end(), mesh.origin(h)) == after.end()) return h;
  }
  return {};
}

void check_apart(const TriangleMesh& mesh, std::span<const HalfEdgeId> flips) {
  Buffer<bool> used(mesh.triangle_count(), false);
  for (const HalfEdgeId h : flips)
    for (const HalfEdgeId side : {h, mesh.twin(h)})
      if (std::exchange(used[TriangleMesh::triangle(side)], true))
        throw std::logic_error("two flips in one triangle");
}

/// Triangles that are not in the place that they have in the Delaunay triangulation, if anywhere
/// there, with their orders.
struct Replaced {
  std::vector<TriangleId> triangles;
  std::vector<Index> orders;
};

Replaced count_replaced(const DelaunayGraph& graph, const TriangleMesh& mesh) {
  const auto find_changed = [&](std::size_t first, std::size_t last,
                                std::vector<TriangleId>& found) {
    for (auto t = TriangleId(Index(first)); t < last; t = TriangleId(t + 1))
      if (mesh.corners(t) != graph.mesh.corners(t)) found.push_back(t);
  };
  std::vector<TriangleId> changed =
      parallel_collect<TriangleId>(0, mesh.triangle_count(), 1 << 14, find_changed);
  std::vector<Index> orders(changed.size());
  SoleInside sole(graph);
  PerThread<CircleCounter> counters([&] { return CircleCounter(graph); });
  parallel_for(0, changed.size(), 256, [&](std::size_t first, std::size_t last) {
    CircleCounter& counter = counters.mine();
    for (std::size_t i = first; i < last; ++i) {
      const std::array<VertexId, 3> corners = mesh.corners(changed[i]);
      // A flip's triangle has the corner in its circle that its place had before, and mostly that
      // is all.
      const HalfEdgeId lost = from_lost_corner(graph.mesh, changed[i], corners);
      if (lost.valid() && !graph.has_walls() && sole.holds_origin_only(corners, lost)) {
        orders[i] = 1;
        continue;
      }
      const auto [a, b, c] = corners;
      orders[i] =
          counter.count(a, b, c, kUnlimited, lost.valid() ? graph.mesh.origin(lost) : VertexId());
    }
  });
  return {std::move(changed), std::move(orders)};
}

void count(std::vector<std::size_t>& histogram, std::span<const Index> orders) {
  for (const Index order : orders) {
    if (histogram.size() <= order) histogram.resize(order + 1, 0);
    ++histogram[order];
  }
}

}  // namespace

std::vector<std::size_t> order_histogram(const DelaunayGraph& graph, const TriangleMesh& mesh) {
  const Replaced replaced = count_replaced(graph, mesh);
  std::vector<std::size_t> histogram(1, mesh.triangle_count() - replaced.orders.size());
  count(histogram, replaced.orders);
  return histogram;
}

std::vector<std::size_t> order_histogram(const DelaunayGraph& graph, const MeshChange& change) {
  if (change.mesh()) return order_histogram(graph, *change.mesh());
  const std::span<const HalfEdgeId> flips = change.flips();
  check_apart(graph.mesh, flips);
  const std::size_t triangles = graph.mesh.triangle_count(), changed = 2 * flips.size();
  if (flips.empty()) return {triangles};
  return {triangles - changed, changed};
}

std::vector<Index> triangle_orders(const DelaunayGraph& graph, const MeshChange& change) {
  std::vector<Index> orders(graph.mesh.triangle_count(), 0);
  if (change.mesh()) {
    const Replaced replaced = count_replaced(graph, *change.mesh());
    for (std::size_t i = 0; i < replaced.orders.size(); ++i)
      orders[replaced.triangles[i]] = replaced.orders[i];
    return orders;
  }
  check_apart(graph.mesh, change.flips());
  for (const HalfEdgeId h : change.flips())
    for (const HalfEdgeId side : {h, graph.mesh.twin(h)}) orders[TriangleMesh::triangle(side)] = 1;
  return orders;
}

std::vector<std::size_t> order_histogram(std::span<const Index> orders) {
  std::vector<std::size_t> histogram(1, 0);
  count(histogram, orders);
  return histogram;
}

}  // namespace hodt
