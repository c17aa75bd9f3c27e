// How many edges end at a vertex.
#pragma once

#include "hodt/base/buffer.h"
#include "hodt/mesh/triangle_mesh.h"

namespace hodt {

/// The degree of every vertex.
inline Buffer<Index> degrees_of(const TriangleMesh& mesh) {
  Buffer<Index> degrees(mesh.vertex_count(), 0);
  // As many edges as leave it, and on a boundary one more, which only ends there.
  for (const Index v : mesh.origins()) ++degrees[v];
  for (Index i = 0; i < mesh.halfedge_count(); ++i)
    if (const HalfEdgeId h(i); mesh.is_boundary(h)) ++degrees[mesh.target(h)];
  return degrees;
}

}  // namespace hodt
