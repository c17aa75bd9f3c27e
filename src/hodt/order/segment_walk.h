// The edges that a segment between two vertices crosses, one after another.
#pragma once

#include <span>

#include "hodt/geometry/predicates.h"
#include "hodt/mesh/triangle_mesh.h"

namespace hodt {

/// The edge through which the segment leaves the triangles around `from`, as seen from there: its
/// origin on the right, its target on the left. `outgoing` leaves `from` (see outgoing_halfedges).
/// REQUIRES that from and to are not joined by an edge, and that no vertex lies between them.
inline HalfEdgeId first_crossed(const TriangleMesh& mesh, std::span<const Point> xy,
                                HalfEdgeId outgoing, VertexId from, VertexId to) {
  const Point &a = xy[from], &b = xy[to];
  HalfEdgeId found;
  for_each_outgoing(mesh, outgoing, [&](HalfEdgeId h) {
    if (found.valid()) return;
    if (orient(a, xy[mesh.target(h)], b) > 0 && orient(a, b, xy[mesh.apex(h)]) > 0)
      found = TriangleMesh::next(h);
  });
  return found;
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

/// Calls f(h) for every crossed edge, in order along the segment.
template <class F>
void for_each_crossed(const TriangleMesh& mesh, std::span<const Point> xy, HalfEdgeId outgoing,
                      VertexId from, VertexId to, const F& f) {
  for (HalfEdgeId h = first_crossed(mesh, xy, outgoing, from, to); h.valid();
       h = next_crossed(mesh, xy, h, from, to))
    f(h);
}

}  // namespace hodt
