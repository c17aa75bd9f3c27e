// A look around a vertex for one edge, which ends before a hub takes long.
#pragma once

#include "hodt/mesh/triangle_mesh.h"

namespace hodt {

/// Vertices with more triangles are asked last: mostly another one has the answer, too.
inline constexpr Index kFewTriangles = 128;

struct FoundOutgoing {
  HalfEdgeId halfedge;    ///< kNone if there is none, or it is not among the first
  bool is_known = false;  ///< it was found, or all were looked at
};

/// The first half-edge that leaves the origin of `start`, counter-clockwise, with is_it(h); `start`
/// as outgoing_halfedges gives it. Looks at `most` of them.
template <class F>
FoundOutgoing find_outgoing(const TriangleMesh& mesh, HalfEdgeId start, Index most,
                            const F& is_it) {
  HalfEdgeId h = start;
  do {
    if (most-- == 0) return {};
    if (is_it(h)) return {h, true};
    h = mesh.rotate_ccw(h);
  } while (h.valid() && h != start);
  return {{}, true};
}

/// A half-edge along the edge uv, in either direction; kNone if there is none. `outgoing[v]` leaves
/// v. Asks the end that is no hub.
template <class Outgoing>
HalfEdgeId find_edge(const TriangleMesh& mesh, const Outgoing& outgoing, VertexId u, VertexId v) {
  const auto find_at = [&](VertexId from, VertexId to, Index most) {
    FoundOutgoing found = find_outgoing(mesh, outgoing[from], most, [&](HalfEdgeId h) {
      return mesh.target(h) == to || mesh.apex(h) == to;
    });
    const HalfEdgeId h = found.halfedge;
    if (h.valid() && mesh.target(h) != to) found.halfedge = TriangleMesh::prev(h);
    return found;
  };
  if (const FoundOutgoing found = find_at(u, v, kFewTriangles); found.is_known)
    return found.halfedge;
  if (const FoundOutgoing found = find_at(v, u, kFewTriangles); found.is_known)
    return found.halfedge;
  return find_at(u, v, kNone).halfedge;
}

}  // namespace hodt
