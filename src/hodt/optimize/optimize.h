// The best triangulation of an order, for any objective.
#pragma once

#include <span>

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
  /// For objectives that count minima: vertices that stay local minima if the Delaunay
  /// triangulation has them as such. One flag each, or none at all.
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

}  // namespace hodt
