#include "hodt/optimize/optimize_edge_measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "hodt/base/parallel.h"
#include "hodt/optimize/choices.h"
#include "hodt/optimize/edge_bound.h"
#include "hodt/optimize/edge_measures.h"
#include "hodt/optimize/flips.h"
#include "hodt/order/first_order.h"

namespace hodt {

namespace {

class Optimizer {
 public:
  explicit Optimizer(const MeasureProblem& problem)
      : problem_(problem),
        graph_(problem.graph),
        delaunay_(problem.graph.mesh),
        values_(problem.objective, graph_.xy, problem.z) {}

  MeasuredSolution run() && {
    choose_diagonals();
    if (problem_.order > 1) improve_on_first_order();
    // By sums that are rounded in another order.
    if (values_.better(solution_.result, solution_.bound)) solution_.bound = solution_.result;
    return std::move(solution_);
  }

 private:
  using Gradient = EdgeValues::Gradient;
  /// Two Delaunay triangles with an edge that can be flipped, and what is there after the flip.
  struct Quadrilateral {
    HalfEdgeId diagonal;
    Gradient at_origin, at_target;  // of the triangles that keep one of its ends
  };
  /// What an edge costs for each choice of the quadrilaterals on its left and right, if any.
  struct EdgeCosts {
    Index left, right;
    std::array<SingleCosts, 2> costs;  // [left][right]
  };
  void choose_diagonals();
  void find_quadrilaterals();
  double add_costs(Choices& choices) const;
  void add_costs(HalfEdgeId h, EdgeCosts& edge, ManyEdges& many) const;
  const Gradient& other_gradient(HalfEdgeId side) const;
  void improve_on_first_order();

  const MeasureProblem& problem_;
  const DelaunayGraph& graph_;
  const TriangleMesh& delaunay_;
  const EdgeValues values_;
  MeasuredSolution solution_;
  Buffer<Gradient> gradients_;  // of the triangles
  std::vector<Quadrilateral> quadrilaterals_;
  Buffer<Index> quadrilateral_;  // of a triangle, or kNone
};

void Optimizer::find_quadrilaterals() {
  gradients_ = values_.gradients(delaunay_);
  quadrilateral_ = Buffer<Index>(delaunay_.triangle_count(), kNone);
  if (problem_.order == 0) return;
  for (const HalfEdgeId h : first_order_edges(graph_)) {
    const HalfEdgeId twin = delaunay_.twin(h);
    const VertexId a = delaunay_.origin(h), b = delaunay_.target(h);
    const VertexId c = delaunay_.apex(h), d = delaunay_.apex(twin);
    quadrilateral_[TriangleMesh::triangle(h)] = quadrilateral_[TriangleMesh::triangle(twin)] =
        static_cast<Index>(quadrilaterals_.size());
    quadrilaterals_.push_back({h, values_.gradient(a, d, c), values_.gradient(b, c, d)});
  }
}

/// Returns what the edges cost that depend on no choice.
double Optimizer::add_costs(Choices& choices) const {
  double constant = values_.neutral();
  const auto find = [&](std::size_t first, std::size_t last, std::vector<EdgeCosts>& found) {
    found.reserve(last - first);  // no value moves before it is measured
    ManyEdges many(values_);
    for (std::size_t i = first; i < last; ++i)
      if (const HalfEdgeId h{Index(i)}; !delaunay_.is_boundary(h) && h < delaunay_.twin(h))
        add_costs(h, found.emplace_back(), many);
    many.measure();
  };
  const auto add = [&](const std::vector<EdgeCosts>& edges) {
    for (const auto& [left, right, costs] : edges) {
      if (left == kNone && right == kNone)
        constant = values_.combine(constant, costs[0][0]);
      else if (right == kNone || left == right)
        choices.add(left, {costs[0][0], costs[1][0]});
      else if (left == kNone)
        choices.add(right, costs[0]);
      else
        choices.add(left, right, costs);
    }
  };
  // Pieces that stay in the cache.
  parallel_stream<EdgeCosts>(0, delaunay_.halfedge_count(), 1 << 16, 1 << 13, find, add);
  return constant;
}

void Optimizer::choose_diagonals() {
  find_quadrilaterals();
  Choices choices(values_, static_cast<Index>(quadrilaterals_.size()));
  const double constant = add_costs(choices);
  const Choices::Result best = choices.best(problem_.deadline);
  std::vector<HalfEdgeId> flips;
  for (Index q = 0; q < quadrilaterals_.size(); ++q)
    if (best.chosen[q]) flips.push_back(quadrilaterals_[q].diagonal);
  solution_.change = MeshChange(std::move(flips));
  const auto in_all = [&](double cost_of_choices) {
    const double value = values_.combine(constant, cost_of_choices);
    return std::isfinite(value) ? value : 0;  // no inner edge
  };
  solution_.delaunay = in_all(choices.value(std::vector<bool>(best.chosen.size(), false)));
  solution_.result = in_all(choices.value(best.chosen));
  solution_.bound = in_all(best.bound);
}

/// At the side of a quadrilateral when its other diagonal is taken: of the triangle with the end of
/// the diagonal that the side has, too.
const Optimizer::Gradient& Optimizer::other_gradient(HalfEdgeId side) const {
  const Quadrilateral& q = quadrilaterals_[quadrilateral_[TriangleMesh::triangle(side)]];
  const VertexId origin = delaunay_.origin(q.diagonal);
  const bool has_origin = delaunay_.origin(side) == origin || delaunay_.target(side) == origin;
  return has_origin ? q.at_origin : q.at_target;
}

/// Those of one edge, to be measured with many.
void Optimizer::add_costs(HalfEdgeId h, EdgeCosts& edge, ManyEdges& many) const {
  const HalfEdgeId twin = delaunay_.twin(h);
  const TriangleId left_triangle = TriangleMesh::triangle(h);
  const TriangleId right_triangle = TriangleMesh::triangle(twin);
  const VertexId a = delaunay_.origin(h), b = delaunay_.target(h);
  const Gradient &f = gradients_[left_triangle], &g = gradients_[right_triangle];
  edge.left = quadrilateral_[left_triangle];
  edge.right = quadrilateral_[right_triangle];
  auto& costs = edge.costs;
  many.add(a, b, f, g, costs[0][0]);
  if (edge.left != kNone && edge.left == edge.right) {  // its diagonal, or the other one
    const Quadrilateral& q = quadrilaterals_[edge.left];
    const VertexId c = delaunay_.apex(h), d = delaunay_.apex(twin);
    many.add(c, d, q.at_origin, q.at_target, costs[1][0]);
    return;
  }
  const bool is_left_open = edge.left != kNone, is_right_open = edge.right != kNone;
  const Gradient& other_f = is_left_open ? other_gradient(h) : f;
  const Gradient& other_g = is_right_open ? other_gradient(twin) : g;
  if (is_left_open) many.add(a, b, other_f, g, costs[1][0]);
  if (is_right_open) many.add(a, b, f, other_g, costs[0][1]);
  if (is_left_open && is_right_open) many.add(a, b, other_f, other_g, costs[1][1]);
}

/// By flips, from there and from what the bound suggests.
void Optimizer::improve_on_first_order() {
  const auto improve = [&](TriangleMesh& mesh) {
    improve_by_flips(graph_, values_, problem_.order, problem_.deadline, mesh);
    return values_.of(mesh);
  };
  TriangleMesh mesh = solution_.change.applied_to(delaunay_);
  solution_.result = improve(mesh);
  EdgeBound suggestion = bound_across_edges(graph_, values_, problem_.order, solution_.result,
                                            problem_.deadline, problem_.method == Method::exact);
  solution_.bound = suggestion.bound;
  if (problem_.method != Method::flip) {
    const double other = improve(suggestion.mesh);
    if (values_.better(other, solution_.result)) {
      solution_.result = other;
      mesh = std::move(suggestion.mesh);
    }
  }
  solution_.change = MeshChange(std::move(mesh));
}

}  // namespace

MeasuredSolution optimize_edge_measure(const MeasureProblem& problem) {
  return Optimizer(problem).run();
}

}  // namespace hodt
