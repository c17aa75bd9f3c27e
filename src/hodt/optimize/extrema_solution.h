// What the optimizers for local minima and maxima return.
#pragma once

#include <cstddef>

#include "hodt/mesh/triangle_mesh.h"

namespace hodt {

struct ExtremaSolution {
  TriangleMesh mesh;
  /// Extrema of the kinds that the objective counts, on the boundary too: of the Delaunay
  /// triangulation, and of the mesh.
  std::size_t delaunay = 0;
  std::size_t result = 0;
  /// No triangulation of that order has fewer.
  std::size_t bound = 0;
};

}  // namespace hodt
