// The best triangulation of order k for a measure of triangles.
#pragma once

#include <span>

#include "hodt/base/deadline.h"
#include "hodt/optimize/measured_solution.h"
#include "hodt/optimize/objective.h"
#include "hodt/order/delaunay_graph.h"

namespace hodt {

struct MeasureProblem {
  const DelaunayGraph& graph;
  std::span<const double> z;  ///< may be empty unless the measure needs heights
  Index order = 0;
  Objective objective;
  Method method = Method::automatic;
  /// The search ends then with what it has; the bound stays valid.
  Deadline deadline = {};
};

/// Order 1 is always optimal: the quadrilaterals are independent (Theorem 7). Above, the fixed
/// edges cut the plane into faces (Silveira and van Kreveld). A face that is a polygon is solved by
/// dynamic programming over its valid triangles; any other one, for sums, by a linear program. What
/// is not solved is improved by flips, and bounded. docs/design/measures.md explains.
MeasuredSolution optimize_measure(const MeasureProblem& problem);

}  // namespace hodt
