// The Delaunay triangulation: the triangulation of order 0, unique under the perturbation.
#pragma once

#include "hodt/delaunay/spatial_order.h"
#include "hodt/geometry/point_set.h"
#include "hodt/mesh/triangle_mesh.h"

namespace hodt {

struct Delaunay {
  VertexSet vertices;
  /// On the numbering of `vertices`. Every triangle is counter-clockwise.
  TriangleMesh mesh;
  /// Of every half-edge whether it is a wall: an edge that has to be there and that nothing reaches
  /// across (see order/constrained/constrained_delaunay.h). Empty if there are none.
  Buffer<bool> walls = {};
};

/// Triangulates the distinct points. O(n log n); the same bytes on any number of threads.
/// Throws InputError for fewer than three distinct points, if all lie on one line, or if a
/// coordinate is not finite.
Delaunay delaunay(const PointView& points);

/// The mesh with the vertices renamed to input rows (dropped duplicates have no triangle).
TriangleMesh in_input_numbering(TriangleMesh mesh, const VertexSet& vertices,
                                std::size_t input_rows);

}  // namespace hodt
