#include "hodt/order/fixed_edges.h"

#include <algorithm>
#include <atomic>

#include "hodt/base/parallel.h"
#include "hodt/geometry/predicates.h"
#include "hodt/order/first_order/first_order.h"
#include "hodt/order/segment_walk.h"
#include "hodt/order/useful_edges.h"

namespace hodt {

namespace {

/// An edge of useful order 1 crosses one Delaunay edge only (Corollary 3).
Buffer<bool> fixed_at_first_order(const DelaunayGraph& graph) {
  Buffer<bool> fixed(graph.mesh.halfedge_count(), true);
  for (const HalfEdgeId h : first_order_edges(graph)) fixed[h] = fixed[graph.mesh.twin(h)] = false;
  return fixed;
}

}  // namespace

Buffer<bool> fixed_edges(const DelaunayGraph& graph, Index k, const Deadline& deadline) {
  if (k == 1) return fixed_at_first_order(graph);
  const TriangleMesh& mesh = graph.mesh;
  Buffer<bool> fixed(mesh.halfedge_count(), true);
  // Threads may meet at an edge, but all they ever write is false.
  const auto cross = [&](HalfEdgeId h) {
    std::atomic_ref<bool>(fixed[h]).store(false, std::memory_order_relaxed);
  };
  UsefulEdgeSearches searches(graph, k, deadline);
  parallel_for(0, graph.xy.size(), 1 << 9, [&](std::size_t first, std::size_t last) {
    UsefulEdgeSearch& search = searches.mine();
    for (std::size_t i = first; i < last; ++i) {
      const VertexId u{Index(i)};
      for (const UsefulEdge& edge : search.to_larger(u, k)) {
        deadline.check();
        for_each_crossed(mesh, graph.xy, graph.outgoing.all(), u, edge.to, [&](HalfEdgeId h) {
          cross(h);
          cross(mesh.twin(h));
        });
      }
    }
  });
  return fixed;
}

FixedFaces::FixedFaces(const DelaunayGraph& graph, const Buffer<bool>& fixed)
    : graph_(graph), fixed_(fixed), face_of_(graph.mesh.triangle_count(), kNone) {
  const TriangleMesh& mesh = graph.mesh;
  std::vector<TriangleId> stack;
  for (Index seed = 0; seed < mesh.triangle_count(); ++seed) {
    if (face_of_[seed] != kNone) continue;
    const auto face = static_cast<Index>(first_triangle_.size());
    const std::size_t begin = triangles_.size();
    first_triangle_.push_back(static_cast<Index>(begin));
    face_of_[seed] = face;
    stack.push_back(TriangleId(seed));
    while (!stack.empty()) {
      const TriangleId t = stack.back();
      stack.pop_back();
      triangles_.push_back(t);
      for (Index i = 0; i < 3; ++i) {
        const HalfEdgeId h(3 * t + i);
        if (fixed[h]) continue;  // boundary edges are fixed
        const TriangleId other = TriangleMesh::triangle(mesh.twin(h));
        if (face_of_[other] != kNone) continue;
        face_of_[other] = face;
        stack.push_back(other);
      }
    }
    std::sort(triangles_.begin() + std::ptrdiff_t(begin), triangles_.end());
  }
  first_triangle_.push_back(static_cast<Index>(triangles_.size()));
}

FixedFaces::Boundary FixedFaces::boundary(Index face) const {
  const TriangleMesh& mesh = graph_.mesh;
  std::vector<HalfEdgeId> sides;
  std::vector<VertexId> corners;
  for (const TriangleId t : triangles(face))
    for (Index i = 0; i < 3; ++i) {
      const HalfEdgeId h(3 * t + i);
      if (fixed_[h]) sides.push_back(h);
      corners.push_back(mesh.origin(h));
    }

  // At the end of a side, the walk goes on along the next fixed edge around the face: through the
  // triangles at that vertex, across edges that are not fixed.
  std::vector<bool> walked(sides.size(), false);
  const auto place = [&](HalfEdgeId h) {
    return std::size_t(std::lower_bound(sides.begin(), sides.end(), h) - sides.begin());
  };
  std::vector<Walk> walks;
  std::vector<VertexId> on_walks;
  for (const HalfEdgeId start : sides) {
    if (walked[place(start)]) continue;
    Walk walk;
    for (HalfEdgeId h = start; !walked[place(h)];) {
      walked[place(h)] = true;
      walk.push_back(h);
      on_walks.push_back(mesh.origin(h));
      h = TriangleMesh::next(h);
      while (!fixed_[h]) h = TriangleMesh::next(mesh.twin(h));
    }
    walks.push_back(std::move(walk));
  }

  // The outer walk passes the face's lowest corner of all, and turns left there.
  const auto lower = [&](VertexId a, VertexId b) {
    return lexicographically_less(graph_.point(a), graph_.point(b));
  };
  const VertexId lowest = *std::min_element(corners.begin(), corners.end(), lower);
  Boundary boundary;
  for (Walk& walk : walks) {
    const bool is_outer = boundary.outer.empty() &&
                          std::any_of(walk.begin(), walk.end(),
                                      [&](HalfEdgeId h) { return mesh.origin(h) == lowest; });
    if (is_outer)
      boundary.outer = std::move(walk);
    else
      boundary.inner.push_back(std::move(walk));
  }
  std::sort(on_walks.begin(), on_walks.end());
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  std::set_difference(corners.begin(), corners.end(), on_walks.begin(), on_walks.end(),
                      std::back_inserter(boundary.isolated));
  return boundary;
}

}  // namespace hodt
