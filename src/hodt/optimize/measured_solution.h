// What the optimizers for measures of triangles return.
#pragma once

#include <algorithm>
#include <cmath>

#include "hodt/mesh/mesh_change.h"

namespace hodt {

struct MeasuredSolution {
  MeshChange change;  ///< of the Delaunay triangulation
  /// The objective's value before and after.
  double delaunay = 0;
  double result = 0;
  /// No triangulation of that order is better than this, but for rounding: relatively 1e-9.
  double bound = 0;
  /// The result is proven best, but for the same.
  bool is_optimal() const { return std::fabs(result - bound) <= 1e-9 * std::max(result, bound); }
};

}  // namespace hodt
