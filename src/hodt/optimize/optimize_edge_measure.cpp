#include "hodt/optimize/optimize_edge_measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "hodt/geometry/predicates.h"
#include "hodt/optimize/choices.h"
#include "hodt/optimize/edge_measures.h"
#include "hodt/optimize/flips.h"
#include "hodt/order/first_order.h"
#include "hodt/order/fixed_edges.h"
#include "hodt/order/triangles.h"

namespace hodt {

namespace {

class Optimizer {
 public:
  explicit Optimizer(const MeasureProblem& problem)
      : problem_(problem),
        graph_(problem.graph),
        delaunay_(problem.graph.mesh),
        values_(problem.objective, graph_.xy, problem.z) {
    solution_.mesh = delaunay_;
    solution_.delaunay = values_.of(delaunay_);
    solution_.bound = solution_.delaunay;
  }

  MeasuredSolution run() && {
    if (problem_.order > 0) choose_diagonals();
    if (problem_.order > 1) {
      improve_by_flips(graph_, values_, problem_.order, problem_.deadline, solution_.mesh);
      solution_.bound = bound_of_pairs();
    }
    solution_.result = values_.of(solution_.mesh);
    // By sums that are rounded in another order.
    if (values_.better(solution_.result, solution_.bound)) solution_.bound = solution_.result;
    return std::move(solution_);
  }

 private:
  void choose_diagonals();
  void add_edge(HalfEdgeId h, Choices& choices, double& constant) const;
  VertexId other_apex(HalfEdgeId side) const;
  double bound_of_pairs() const;

  const MeasureProblem& problem_;
  const DelaunayGraph& graph_;
  const TriangleMesh& delaunay_;
  const EdgeValues values_;
  MeasuredSolution solution_;
  std::vector<HalfEdgeId> diagonals_;  // of the quadrilaterals
  Buffer<Index> quadrilateral_;        // of a triangle, or kNone
};

void Optimizer::choose_diagonals() {
  diagonals_ = first_order_edges(graph_);
  quadrilateral_ = Buffer<Index>(delaunay_.triangle_count(), kNone);
  Choices choices(values_, static_cast<Index>(diagonals_.size()));
  for (Index q = 0; q < diagonals_.size(); ++q) {
    const HalfEdgeId h = diagonals_[q], twin = delaunay_.twin(h);
    quadrilateral_[TriangleMesh::triangle(h)] = quadrilateral_[TriangleMesh::triangle(twin)] = q;
    choices.add(q,
                {values_.of(delaunay_, h), values_.of(delaunay_.apex(twin), delaunay_.apex(h),
                                                      delaunay_.origin(h), delaunay_.target(h))});
  }
  double constant = values_.neutral();
  for_each_inner_edge(delaunay_, [&](HalfEdgeId h) { add_edge(h, choices, constant); });
  const Choices::Result best = choices.best();
  for (Index q = 0; q < diagonals_.size(); ++q)
    if (best.chosen[q]) solution_.mesh.flip(diagonals_[q]);
  solution_.bound = values_.combine(constant, best.bound);
  if (!std::isfinite(solution_.bound)) solution_.bound = 0;  // no inner edge
}

/// The corner opposite to the side of a quadrilateral when its other diagonal is taken: the one
/// beyond the diagonal.
VertexId Optimizer::other_apex(HalfEdgeId side) const {
  const HalfEdgeId h = diagonals_[quadrilateral_[TriangleMesh::triangle(side)]];
  const bool is_left = TriangleMesh::triangle(h) == TriangleMesh::triangle(side);
  return is_left ? delaunay_.apex(delaunay_.twin(h)) : delaunay_.apex(h);
}

void Optimizer::add_edge(HalfEdgeId h, Choices& choices, double& constant) const {
  const HalfEdgeId twin = delaunay_.twin(h);
  const Index left = quadrilateral_[TriangleMesh::triangle(h)];
  const Index right = quadrilateral_[TriangleMesh::triangle(twin)];
  if (left != kNone && left == right) return;  // its diagonal
  const VertexId a = delaunay_.origin(h), b = delaunay_.target(h);
  const VertexId c = delaunay_.apex(h), d = delaunay_.apex(twin);
  const VertexId other_c = left == kNone ? c : other_apex(h);
  const VertexId other_d = right == kNone ? d : other_apex(twin);
  const double value = values_.of(a, b, c, d);
  if (left == kNone && right == kNone)
    constant = values_.combine(constant, value);
  else if (right == kNone)
    choices.add(left, {value, values_.of(a, b, other_c, d)});
  else if (left == kNone)
    choices.add(right, {value, values_.of(a, b, c, other_d)});
  else
    choices.add(left, right,
                {{{value, values_.of(a, b, c, other_d)},
                  {values_.of(a, b, other_c, d), values_.of(a, b, other_c, other_d)}}});
}

/// Every fixed edge is in, with two of the valid triangles at it; and so many others, each at best
/// as good as the best of all.
double Optimizer::bound_of_pairs() const {
  struct Use {
    Index low, high;
    bool is_left;  // of low -> high
    VertexId apex;
    auto key() const { return std::tuple(low, high); }
  };
  std::vector<Use> uses;
  for_each_triangle(graph_, TriangleClass::valid, problem_.order, own_numbering(graph_.xy.size()),
                    [&](std::span<const TriangleRecord> piece) {
                      for (const TriangleRecord& t : piece) {
                        const bool ccw = orient(graph_.xy[t.a], graph_.xy[t.b], graph_.xy[t.c]) > 0;
                        uses.push_back({t.a, t.b, ccw, VertexId(t.c)});
                        uses.push_back({t.b, t.c, ccw, VertexId(t.a)});
                        uses.push_back({t.a, t.c, !ccw, VertexId(t.b)});
                      }
                    });
  std::sort(uses.begin(), uses.end(), [](const Use& x, const Use& y) { return x.key() < y.key(); });
  const Buffer<bool> fixed = fixed_edges(graph_, problem_.order);
  std::vector<std::tuple<Index, Index>> fixed_keys;
  std::size_t inner = 0;
  for_each_inner_edge(delaunay_, [&](HalfEdgeId h) {
    ++inner;
    const Index a = delaunay_.origin(h), b = delaunay_.target(h);
    if (fixed[h]) fixed_keys.emplace_back(std::min(a, b), std::max(a, b));
  });
  std::sort(fixed_keys.begin(), fixed_keys.end());

  const auto better = [&](double x, double y) { return values_.better(x, y) ? x : y; };
  const double worst = problem_.objective.direction == Direction::minimize ? 1e300 : 0;
  double bound = values_.neutral(), best_of_all = worst;
  for (std::size_t first = 0, last = 0; first < uses.size(); first = last) {
    while (last < uses.size() && uses[last].key() == uses[first].key()) ++last;
    double best = worst;
    for (std::size_t l = first; l < last; ++l)
      for (std::size_t r = first; r < last; ++r)
        if (uses[l].is_left && !uses[r].is_left)
          best = better(best, values_.of(VertexId(uses[l].low), VertexId(uses[l].high),
                                         uses[l].apex, uses[r].apex));
    if (std::binary_search(fixed_keys.begin(), fixed_keys.end(), uses[first].key()))
      bound = values_.combine(bound, best);
    else
      best_of_all = better(best_of_all, best);
  }
  const std::size_t others = inner - fixed_keys.size();
  if (others > 0)
    bound = values_.combine(bound, problem_.objective.aggregate == Aggregate::sum
                                       ? double(others) * best_of_all
                                       : best_of_all);
  return std::isfinite(bound) ? bound : 0;
}

}  // namespace

MeasuredSolution optimize_edge_measure(const MeasureProblem& problem) {
  return Optimizer(problem).run();
}

}  // namespace hodt
