// What the optimizers for measures are asked, and what they return.
// Tested by tests/optimize/optimize_measure_test.cpp.
#pragma once

#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "hodt/base/deadline.h"
#include "hodt/mesh/mesh_change.h"
#include "hodt/optimize/aggregator.h"
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

/// Whether a result is as good as a bound, sums but for a relative 1e-9.
inline bool is_as_good(double result, double bound, bool is_sum) {
  const double slack = is_sum ? 1e-9 : 0;
  return std::fabs(result - bound) <= slack * std::fmax(std::fabs(result), std::fabs(bound));
}

/// These, once they are sure to be finite. Totals are rounded to the nearest double and bounds
/// outward, so that no result passes a bound.
inline MeasuredSolution measured(const Aggregator& aggregator, MeshChange change, double delaunay,
                                 double result, double bound) {
  if (bound < 0) bound = 0;  // no measure is negative
  if (!std::isfinite(delaunay) || !std::isfinite(result) || !std::isfinite(bound))
    throw_out_of_range(aggregator.objective());
  if (aggregator.better(result, bound))
    throw std::logic_error(name_of(aggregator.objective()) + ": the result " +
                           std::to_string(result) + " passes " + std::to_string(bound) +
                           ", a bound that was proven for all");
  return {std::move(change), delaunay, result, bound,
          is_as_good(result, bound, aggregator.is_sum())};
}

}  // namespace hodt
