// Triangulations of order k with few local minima, maxima or both, for any k.
#pragma once

#include <span>

#include "hodt/base/deadline.h"
#include "hodt/base/ids.h"
#include "hodt/base/progress.h"
#include "hodt/optimize/extrema/extrema_solution.h"
#include "hodt/optimize/objective.h"
#include "hodt/order/delaunay_graph.h"

namespace hodt {

struct ExtremaProblem {
  const DelaunayGraph& graph;
  std::span<const double> z;
  Index order = 0;
  Objective objective = Objective::min_local_minima;
  Method method = Method::automatic;
  /// Vertices that stay local minima if the Delaunay triangulation has them as such: one flag each,
  /// or none at all. The bound is then one over the triangulations that keep them.
  std::span<const bool> keep = {};
  /// The search ends then with what it has; the bound stays valid.
  Deadline deadline = {};
  Progress progress = {};
};

/// Removes extrema by useful edges from each to a lower (higher) vertex: first those of the
/// smallest order whose hulls are apart (Theorem 8); then, unless the method is greedy or no more
/// can go, by the best choice of edges that do not cross; or by flips. The mesh has order at most
/// problem.order.
/// docs/design/remove-extrema.md explains the choice and the bound.
ExtremaSolution remove_extrema(const ExtremaProblem& problem);

}  // namespace hodt
