// What each vertex is in its triangles: the lowest corner, the highest, or the one between.
#pragma once

#include <cstdint>

#include "hodt/base/buffer.h"
#include "hodt/geometry/heights.h"
#include "hodt/mesh/triangle_mesh.h"

namespace hodt {

/// Whether at least one triangle has 0, 1 or 2 corners lower than this one of its corners.
struct HeightRanks {
  std::uint8_t with_lower[3] = {0, 0, 0};

  bool is_extremum(Extremum kind) const { return !with_lower[1] && !two_in_a_triangle(kind); }
  /// Whether two neighbours in one triangle both keep the vertex from being an extremum.
  bool two_in_a_triangle(Extremum kind) const {
    return with_lower[kind == Extremum::minimum ? 2 : 0];
  }
};

/// The ranks of all vertices: one pass over the triangles, which is much faster than a walk around
/// every vertex.
Buffer<HeightRanks> height_ranks_of(const TriangleMesh& mesh, const Heights& heights);

}  // namespace hodt
