// The edges of a mesh between two triangles.
#pragma once

#include "hodt/mesh/triangle_mesh.h"

namespace hodt {

/// Calls f(h) for one half-edge of every edge between two triangles: the smaller of the two.
template <class F>
void for_each_inner_edge(const TriangleMesh& mesh, const F& f) {
  for (Index i = 0; i < mesh.halfedge_count(); ++i) {
    const HalfEdgeId h(i);
    if (!mesh.is_boundary(h) && h < mesh.twin(h)) f(h);
  }
}

}  // namespace hodt
