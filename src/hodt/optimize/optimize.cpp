#include "hodt/optimize/optimize.h"

#include <algorithm>
#include <utility>

#include "hodt/base/deadline.h"
#include "hodt/optimize/degree/minimize_degree.h"
#include "hodt/optimize/extrema/first_order_extrema.h"
#include "hodt/optimize/extrema/remove_extrema.h"
#include "hodt/optimize/optimize_measure.h"

namespace hodt {

namespace {

Optimum from(ExtremaSolution&& solution) {
  return {std::move(solution.change),
          {.delaunay = double(solution.delaunay),
           .result = double(solution.result),
           .bound = double(solution.bound),
           .optimal = solution.result == solution.bound}};
}

Optimum from(MeasuredSolution&& solution) {
  return {std::move(solution.change),
          {.delaunay = solution.delaunay,
           .result = solution.result,
           .bound = solution.bound,
           .optimal = solution.is_optimal}};
}

}  // namespace

Optimum optimize(const DelaunayGraph& graph, std::span<const double> z, Objective objective,
                 const OptimizeOptions& options) {
  check_heights(objective, !z.empty());
  check_method(options.method, objective);
  // More than n - 3 points are never inside a circle.
  const Index order = std::min(options.order, static_cast<Index>(graph.xy.size() - 3));
  const Deadline& deadline = options.deadline;
  if (objective == Objective::none) return {{}, {.optimal = true}};
  if (objective.kind == Objective::measured)
    return from(optimize_measure({.graph = graph,
                                  .z = z,
                                  .order = order,
                                  .objective = objective,
                                  .method = options.method,
                                  .deadline = deadline}));
  if (objective == Objective::min_max_degree) return from(minimize_degree(graph, order, deadline));
  if (order == 1 && objective == Objective::min_local_extrema && options.keep.empty())
    return from(minimize_first_order_extrema(graph, z));
  return from(remove_extrema({.graph = graph,
                              .z = z,
                              .order = order,
                              .objective = objective,
                              .method = options.method,
                              .keep = options.keep,
                              .deadline = deadline,
                              .progress = options.progress}));
}

}  // namespace hodt
