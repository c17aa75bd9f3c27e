// The edges that a segment between two vertices crosses, one after another.
// Tested by tests/order/edges_test.cpp.
#pragma once

#include <span>
#include <utility>

#include "hodt/geometry/predicates.h"
#include "hodt/mesh/find_outgoing.h"

namespace hodt {

/// The edge through which the segment leaves the triangles around `from`, as seen from there: its
/// origin on the right, its target on the left. `outgoing` leaves `from` (see outgoing_halfedges).
/// REQUIRES that from and to are not joined by an edge, and that no vertex lies between them.
/// kNone if that is beyond the first `most` triangles that are looked at.
inline HalfEdgeId first_crossed(const TriangleMesh& mesh, std::span<const Point> xy,
                                HalfEdgeId outgoing, VertexId from, VertexId to,
                                Index most = kNone) {
  const Point &a = xy[from], &b = xy[to];
  const HalfEdgeId h =
      find_outgoing(mesh, outgoing, most, [&](HalfEdgeId g) {
        return orient(a, xy[mesh.target(g)], b) > 0 && orient(a, b, xy[mesh.apex(g)]) > 0;
      }).halfedge;
  return h.valid() ? TriangleMesh::next(h) : h;
}

/// The edge through which the segment leaves the triangle beyond a crossed edge; kNone at the end.
inline HalfEdgeId next_crossed(const TriangleMesh& mesh, std::span<const Point> xy,
                               HalfEdgeId crossed, VertexId from, VertexId to) {
  const HalfEdgeId across = mesh.twin(crossed);
  const VertexId w = mesh.apex(across);
  if (w == to) return {};
  const bool w_is_left = orient(xy[from], xy[to], xy[w]) > 0;
  return w_is_left ? TriangleMesh::next(across) : TriangleMesh::prev(across);
}

/// Calls f(h) for every crossed edge, in order along the segment: from the one end, or from the
/// other if the first has very many neighbours, of which each would be looked at for each of its
/// edges. `outgoing[v]` leaves v.
template <class Outgoing, class F>
void for_each_crossed(const TriangleMesh& mesh, std::span<const Point> xy, const Outgoing& outgoing,
                      VertexId from, VertexId to, const F& f) {
  HalfEdgeId h = first_crossed(mesh, xy, outgoing[from], from, to, kFewTriangles);
  if (!h.valid()) {
    h = first_crossed(mesh, xy, outgoing[to], to, from, kFewTriangles);
    if (h.valid())
      std::swap(from, to);
    else
      h = first_crossed(mesh, xy, outgoing[from], from, to);
  }
  for (; h.valid(); h = next_crossed(mesh, xy, h, from, to)) f(h);
}

}  // namespace hodt
