// An existing TIN: what it has to keep to, and itself as one triangulation among all.
// Tested by tests/exhaustive/given_tin_test.cpp.
#pragma once

#include <span>
#include <vector>

#include "hodt/base/ids.h"
#include "hodt/delaunay/delaunay.h"
#include "hodt/geometry/constraints.h"
#include "hodt/mesh/triangle_mesh.h"
#include "hodt/tin/tin.h"

namespace hodt {

/// A mesh that is to be improved: its used vertices, in their order, and constraints by which any
/// triangulation of these has its outline and its holes. The mesh itself is kept among the
/// constraints, to compare with. Throws InputError if it is no embedded mesh, naming two triangles
/// or what else is wrong (see embedding.h).
struct GivenTin {
  PointSet points;
  Constraints constraints;
  std::size_t unused_vertices = 0;
  /// Of every vertex of the mesh which of the points it is; kNone of unused ones.
  std::vector<Index> number;
};
GivenTin given_tin(Tin tin);

/// The triangles on the vertices of a constrained Delaunay triangulation of the same domain, whose
/// constraints these triangles came with.
TriangleMesh mesh_of_given(const Delaunay& delaunay, const PointSet& points,
                           std::span<const std::array<Index, 3>> triangles);

}  // namespace hodt
