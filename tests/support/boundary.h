// The way around a mesh.
#pragma once

#include <algorithm>

#include "hodt/mesh/triangle_mesh.h"

namespace hodt {

/// A boundary half-edge; kNone if there is none.
inline HalfEdgeId first_on_boundary(const TriangleMesh& mesh) {
  const Buffer<Index>& twins = mesh.twins();
  const auto first = std::find(twins.begin(), twins.end(), kNone);
  return first == twins.end() ? HalfEdgeId()
                              : HalfEdgeId(static_cast<Index>(first - twins.begin()));
}

/// The boundary half-edge that starts where h, another one, ends.
inline HalfEdgeId following_on_boundary(const TriangleMesh& mesh, HalfEdgeId h) {
  HalfEdgeId following = TriangleMesh::next(h);
  while (!mesh.is_boundary(following)) following = mesh.rotate_cw(following);
  return following;
}

}  // namespace hodt
