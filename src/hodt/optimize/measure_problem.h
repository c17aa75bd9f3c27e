// What the optimizers for measures are asked, and what they return.
#pragma once

#include <cmath>
#include <span>
#include <utility>

#include "hodt/base/deadline.h"
#include "hodt/mesh/mesh_change.h"
#include "hodt/optimize/combination.h"
#include "hodt/optimize/objective.h"
#include "hodt/optimize/range.h"
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
  /// No triangulation of that order is better than this.
  double bound = 0;
  /// The result is proven best; a sum but for a relative 1e-9.
  bool is_optimal = false;
};

/// These, once they are sure to be finite. A bound that the result passes was a sum rounded in
/// another way: what the result is, is a bound as well then.
inline MeasuredSolution measured(const Combination& combination, MeshChange change, double delaunay,
                                 double result, double bound) {
  if (combination.better(result, bound)) bound = result;
  if (bound < 0) bound = 0;  // no measure is negative
  if (!std::isfinite(delaunay) || !std::isfinite(result) || !std::isfinite(bound))
    throw_out_of_range(combination.objective());
  const double slack = combination.is_sum() ? 1e-9 : 0;
  const bool is_optimal =
      std::fabs(result - bound) <= slack * std::fmax(std::fabs(result), std::fabs(bound));
  return {std::move(change), delaunay, result, bound, is_optimal};
}

}  // namespace hodt
