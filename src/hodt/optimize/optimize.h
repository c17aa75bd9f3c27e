// The best triangulation of an order, for any objective.
#pragma once

#include <span>
#include <vector>

#include "hodt/base/deadline.h"
#include "hodt/base/progress.h"
#include "hodt/mesh/mesh_change.h"
#include "hodt/optimize/objective.h"
#include "hodt/order/delaunay_graph.h"

namespace hodt {

struct OptimizeOptions {
  /// No circumcircle of the result holds more than so many points; more than n - 3 is unrestricted.
  Index order = 4;
  Method method = Method::automatic;
  /// Searching ends soon after, with what it has and a bound that is valid. None: a fixed amount of
  /// work, the same on every machine.
  Deadline deadline = {};
  /// For objectives that count minima, of several the first: vertices that stay local minima if the
  /// Delaunay triangulation has them as such. One flag each, or none at all.
  std::span<const bool> keep = {};
  /// Told what is going on; may be empty.
  Progress progress = {};
};

/// What the objective counts, before and after.
struct Value {
  double delaunay = 0;
  double result = 0;
  /// Proven: no triangulation of order k does better.
  double bound = 0;
  /// The result is proven best.
  bool optimal = false;
};

struct Optimum {
  /// Of the Delaunay triangulation; `change.applied_to(delaunay.mesh)` is the best triangulation.
  MeshChange change;
  Value value;
};

/// Optimises a Delaunay triangulation. `z` has a height for each vertex, or none at all. Throws
/// ParameterError if the objective needs heights and there are none, or cannot be optimised by the
/// method. For Objective::none nothing changes, and the values are 0.
Optimum optimize(const DelaunayGraph& graph, std::span<const double> z, Objective objective,
                 const OptimizeOptions& options = {});

/// Of an objective that is not the first of several.
struct LaterValue {
  Objective objective;
  /// `optimal`: the best of all triangulations that keep the values of the objectives before.
  Value value;
  /// The bound is one over these; otherwise over all triangulations of the order, which is valid
  /// all the same, and mostly better than any of these can be.
  bool is_bound_in_order = false;
};

struct OrderedOptimum {
  MeshChange change;  ///< as that of Optimum
  Value value;        ///< of the first objective
  std::vector<LaterValue> then;
};

/// Optimises for the first objective; then, among the triangulations that keep its value, for the
/// next, and so on. A value of a sum is kept by an exact sum that is no worse. Of the first
/// objective the result is no worse than without the others. At order 1 each result is the best
/// there is wherever the choices that depend on each other are few; docs/design/in-order.md says
/// more. Throws ParameterError also for what check_objectives() refuses, or none at all.
OrderedOptimum optimize_in_order(const DelaunayGraph& graph, std::span<const double> z,
                                 std::span<const Objective> objectives,
                                 const OptimizeOptions& options = {});

}  // namespace hodt
