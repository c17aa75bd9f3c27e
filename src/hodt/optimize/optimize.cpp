#include "hodt/optimize/optimize.h"

#include <algorithm>
#include <utility>

#include "hodt/base/deadline.h"
#include "hodt/base/error.h"
#include "hodt/optimize/degree/minimize_degree.h"
#include "hodt/optimize/extrema/extrema_triangulation.h"
#include "hodt/optimize/extrema/first_order_extrema.h"
#include "hodt/optimize/extrema/remove_extrema.h"
#include "hodt/optimize/in_order/first_order_in_order.h"
#include "hodt/optimize/in_order/improve_in_order.h"
#include "hodt/optimize/optimize_measure.h"
#include "hodt/optimize/touching_sides.h"
#include "hodt/optimize/value_of.h"

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

/// More than n - 3 points are never inside a circle.
Index order_within(const DelaunayGraph& graph, Index order) {
  return std::min(order, static_cast<Index>(graph.xy.size() - 3));
}

/// Where a domain touches itself, extrema and degrees are those of sides.
Optimum optimize_sides(const DelaunayGraph& graph, std::span<const double> z, Objective objective,
                       const OptimizeOptions& options) {
  const Index order = order_within(graph, options.order);
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

}  // namespace

Optimum optimize(const DelaunayGraph& graph, std::span<const double> z, Objective objective,
                 const OptimizeOptions& options) {
  check_heights(objective, !z.empty());
  check_method(options.method, objective);
  Optimum optimum = optimize_sides(graph, z, objective, options);
  if (counts_vertices(objective) && touches_itself(graph))
    count_points(graph, z, order_within(graph, options.order), objective, options.deadline,
                 optimum);
  return optimum;
}

namespace {

/// Minima of the Delaunay triangulation that have to stay, a flag for every vertex.
Buffer<bool> minima_to_keep(const DelaunayGraph& graph, std::span<const double> z,
                            std::span<const bool> keep) {
  if (keep.empty()) return Buffer<bool>(graph.xy.size(), false);
  const Heights heights{graph.xy, z};
  return kept_minima(extrema_of(graph.mesh, heights, Objective::min_local_minima), keep);
}

bool meets(const Objective& objective, double result, double bound) {
  const bool is_sum = objective.kind == Objective::measured && Aggregator(objective).is_sum();
  return is_as_good(result, bound, is_sum);
}

/// One after the other, all of them on one mesh.
class InOrder {
 public:
  InOrder(const DelaunayGraph& graph, std::span<const double> z,
          std::span<const Objective> objectives, const OptimizeOptions& options)
      : graph_(graph), z_(z), objectives_(objectives), options_(options) {
    if (!counts_minima(objectives.front())) options_.keep = {};
    counts_sides_ = touches_itself(graph) && std::ranges::any_of(objectives, counts_vertices);
  }

  OrderedOptimum run() {
    Optimum first = optimize(graph_, z_, objectives_.front(), options_);
    OrderedOptimum result{std::move(first.change), first.value, {}};
    if (objectives_.size() == 1) return result;
    kept_ = minima_to_keep(graph_, z_, options_.keep);
    mesh_ = result.change.applied_to(graph_.mesh);
    // A value that is proven is the one to keep, so that there is no need to search for a better.
    bool is_best = result.value.optimal && is_solved_at_once() && solve_first_order();
    for (std::size_t i = 1; i < objectives_.size(); ++i) {
      const Optimum alone = optimize(graph_, z_, objectives_[i], options_);
      if (options_.progress) options_.progress("objectives in order", -1);
      if (!is_best) add(i, alone.change.applied_to(graph_.mesh));
      result.then.push_back({objectives_[i], alone.value, false});
    }
    if (!is_best && is_solved_at_once()) is_best = solve_rest_of_first_order();
    // Where sides were counted, a point can have come to be worse.
    if (counts_sides_ && hodt::is_better(objectives_[0], result.value.result, value(0, mesh_)))
      mesh_ = result.change.applied_to(graph_.mesh);
    set(0, result.value);
    for (std::size_t i = 1; i < objectives_.size(); ++i) {
      LaterValue& later = result.then[i - 1];
      if (is_best) later.value.bound = value(i, mesh_);
      later.is_bound_in_order = is_best;
      set(i, later.value);
    }
    result.change = MeshChange(std::move(mesh_));
    return result;
  }

 private:
  Index order() const { return order_within(graph_, options_.order); }
  bool is_solved_at_once() const { return order() == 1 && !counts_sides_; }
  OrderedProblem problem(std::size_t count) const {
    return {.graph = graph_,
            .z = z_,
            .order = order(),
            .objectives = objectives_.first(count),
            .kept = kept_,
            .deadline = options_.deadline};
  }
  double value(std::size_t i, const TriangleMesh& mesh) const {
    return value_of(objectives_[i], mesh, graph_.xy, z_);
  }
  void set(std::size_t i, Value& value) const {
    value.result = this->value(i, mesh_);
    value.optimal = meets(objectives_[i], value.result, value.bound);
  }
  /// Makes the mesh good for one more objective, which `best` is best for: beginning with the mesh,
  /// and with what is best once as little as it takes is as in the mesh.
  void add(std::size_t i, const TriangleMesh& best) {
    TriangleMesh other = best;
    exchange_in_order(problem(i), mesh_, other);
    improve_in_order(problem(i + 1), best, mesh_);
    // What is best alone need not have the minima that are to stay.
    if (!options_.keep.empty() || is_better(mesh_, other, i)) return;
    improve_in_order(problem(i + 1), best, other);
    if (is_better(other, mesh_, i + 1)) mesh_ = std::move(other);
  }
  /// Whether a mesh is better than another by the first objective that can tell, of so many.
  bool is_better(const TriangleMesh& mesh, const TriangleMesh& other, std::size_t count) const {
    for (std::size_t i = 0; i < count; ++i)
      if (const double x = value(i, mesh), y = value(i, other); x != y)
        return hodt::is_better(objectives_[i], x, y);
    return false;
  }
  FirstOrderInOrder first_order() const {
    return first_order_in_order(problem(objectives_.size()), mesh_);
  }
  /// Whether the mesh is now the best of all.
  bool solve_first_order() {
    FirstOrderInOrder solved = first_order();
    if (solved.is_best) mesh_ = std::move(solved.mesh);
    return solved.is_best;
  }
  /// The same, taking what can be solved.
  bool solve_rest_of_first_order() {
    FirstOrderInOrder solved = first_order();
    // By sums, as they are before rounding, nothing is better than the best.
    if (!solved.is_best && is_better(mesh_, solved.mesh, objectives_.size())) return false;
    mesh_ = std::move(solved.mesh);
    return solved.is_best;
  }

  const DelaunayGraph& graph_;
  const std::span<const double> z_;
  const std::span<const Objective> objectives_;
  OptimizeOptions options_;
  Buffer<bool> kept_;
  TriangleMesh mesh_;
  bool counts_sides_ = false;  // of points where the domain touches itself
};

}  // namespace

OrderedOptimum optimize_in_order(const DelaunayGraph& graph, std::span<const double> z,
                                 std::span<const Objective> objectives,
                                 const OptimizeOptions& options) {
  check_objectives(objectives);
  if (objectives.empty()) throw ParameterError("there is no objective");
  for (const Objective& objective : objectives) {
    check_heights(objective, !z.empty());
    check_method(options.method, objective);
  }
  return InOrder(graph, z, objectives, options).run();
}

}  // namespace hodt
