// What the optimizers for local minima and maxima return.
// Tested by tests/optimize/remove_extrema_test.cpp.
#pragma once

#include <cstddef>

#include "hodt/mesh/mesh_change.h"

namespace hodt {

struct ExtremaSolution {
  MeshChange change;  ///< of the Delaunay triangulation
  /// Extrema of the kinds that the objective counts, on the boundary too: before and
  /// after.
  std::size_t delaunay = 0;
  std::size_t result = 0;
  /// No triangulation of that order has fewer.
  std::size_t bound = 0;
};

}  // namespace hodt
