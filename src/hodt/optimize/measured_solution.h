// What the optimizers for measures of triangles return.
#pragma once

#include <algorithm>
#include <cmath>

#include "hodt/mesh/triangle_mesh.h"

namespace hodt {

struct MeasuredSolution {
  TriangleMesh mesh;
  /// The objective's value of the Delaunay triangulation, and of the mesh.
  double delaunay = 0;
  double result = 0;
  /// No triangulation of that order is better than this, but for rounding: relatively 1e-9.
  double bound = 0;
  /// The mesh is proven best, but for the same.
  bool is_optimal() const { return std::fabs(result - bound) <= 1e-9 * std::max(result, bound); }
};

}  // namespace hodt
