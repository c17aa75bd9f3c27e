// Triangulations of order k with few local minima, maxima or both, for any k.
#pragma once

#include <cstddef>
#include <span>

#include "hodt/base/ids.h"
#include "hodt/mesh/triangle_mesh.h"
#include "hodt/optimize/heights.h"
#include "hodt/optimize/objective.h"
#include "hodt/order/delaunay_graph.h"

namespace hodt {

struct ExtremaProblem {
  const DelaunayGraph& graph;
  std::span<const double> z;
  Index order = 0;
  Objective objective = Objective::min_local_minima;
  Method method = Method::automatic;
};

struct ExtremaSolution {
  TriangleMesh mesh;
  /// Extrema of the kinds that the objective counts, on the boundary too.
  std::size_t delaunay = 0;
  std::size_t result = 0;
  /// No triangulation of that order has fewer.
  std::size_t bound = 0;
};

/// Removes extrema by useful edges from each to a lower (higher) vertex: first those of the smallest
/// order whose hulls are apart (Theorem 8), then, unless the method is greedy, also where hulls meet
/// and by moving edges chosen before. The mesh has order at most problem.order.
/// docs/design/remove-extrema.md explains the search and the bound.
ExtremaSolution remove_extrema(const ExtremaProblem& problem);

}  // namespace hodt
