// What the optimizers for measures are asked, and what they return.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "hodt/base/deadline.h"
#include "hodt/mesh/mesh_change.h"
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
