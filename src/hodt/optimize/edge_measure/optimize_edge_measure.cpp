#include "hodt/optimize/edge_measure/optimize_edge_measure.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "hodt/base/parallel.h"
#include "hodt/optimize/edge_measure/edge_bound.h"
#include "hodt/optimize/edge_measure/fan_bound.h"
#include "hodt/optimize/flip/flips_across_edges.h"
#include "hodt/optimize/measure/edge_measures.h"
#include "hodt/optimize/measure/trivial_bound.h"
#include "hodt/optimize/solve/choices.h"
#include "hodt/order/first_order/first_order.h"

namespace hodt {

namespace {

/// A single triangle has none, nor have triangles that only meet in corners.
bool has_inner_edge(const TriangleMesh& mesh) {
  return std::any_of(mesh.twins().begin(), mesh.twins().end(),
                     [](Index twin) { return twin != kNone; });
}

class Optimizer {
 public:
  explicit Optimizer(const MeasureProblem& problem)
      : problem_(problem),
        graph_(problem.graph),
        delaunay_(problem.graph.mesh),
        values_(problem.objective, graph_.xy, problem.z) {}

  MeasuredSolution run() && {
    if (!has_inner_edge(delaunay_)) return measured(values_, {}, 0, 0, 0);
    try {
      MeasuredSolution first_order = choose_diagonals();
      return problem_.order > 1 ? improve(first_order) : std::move(first_order);
    } catch (const TimeIsUp&) {  // it was up before the choice began
      const double value = values_.of(delaunay_);
      return measured(values_, {}, value, value,
                      trivial_bound(problem_.objective, graph_.xy, delaunay_));
    }
  }

 private:
  using Gradient = EdgeValues::Gradient;
  using Gradients = ManyEdges::Gradients;
  /// Two Delaunay triangles with an edge that can be flipped.
  struct Quadrilateral {
    HalfEdgeId diagonal, twin;
    Gradients flipped;  // of the triangles after the flip, with its origin and with its target
  };
  struct Single {
    Index choice;
    SingleCosts costs;
  };
  /// What some edges cost, by the quadrilaterals on their sides.
  struct Costs {
    explicit Costs(const Aggregator& aggregator) : constant(aggregator) {}
    Total constant;  // of those without
    std::vector<Single> singles;
    std::vector<ChoicePair> pairs;
  };
  class CostsOfEdges;
  static constexpr Index kClosed = 0;
  static Index choice(Index quadrilateral) { return quadrilateral - 1; }

  MeasuredSolution choose_diagonals();
  void find_quadrilaterals();
  Total add_costs(Choices& choices) const;
  void add_diagonals(Choices& choices) const;
  MeasuredSolution improve(const MeasuredSolution& first_order);
  double improve(TriangleMesh& mesh) const;
  double search_on(TriangleMesh& mesh, double& result) const;

  const MeasureProblem& problem_;
  const DelaunayGraph& graph_;
  const TriangleMesh& delaunay_;
  const EdgeValues values_;
  Buffer<Gradient> gradients_;  // of the triangles
  // The first one stands for none.
  Buffer<Quadrilateral> quadrilaterals_;
  Buffer<Index> quadrilateral_;  // that a triangle is in, or kClosed
};

void Optimizer::find_quadrilaterals() {
  gradients_ = values_.gradients(delaunay_);
  quadrilateral_ = Buffer<Index>(delaunay_.triangle_count(), kClosed);
  std::vector<HalfEdgeId> flippable;
  if (problem_.order > 0) flippable = first_order_edges(graph_);
  quadrilaterals_ = Buffer<Quadrilateral>(1 + flippable.size());
  quadrilaterals_[kClosed] = {};
  parallel_for(0, flippable.size(), 1 << 12, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const HalfEdgeId h = flippable[i], twin = delaunay_.twin(h);
      const VertexId a = delaunay_.origin(h), b = delaunay_.origin(twin);
      const VertexId c = delaunay_.apex(h), d = delaunay_.apex(twin);
      quadrilaterals_[1 + i] = {h, twin, {values_.gradient(a, d, c), values_.gradient(b, c, d)}};
      quadrilateral_[TriangleMesh::triangle(h)] = quadrilateral_[TriangleMesh::triangle(twin)] =
          static_cast<Index>(1 + i);
    }
  });
}

/// The costs of edges that are no diagonals. How many quadrilaterals are at an edge is a matter of
/// chance, so that edges are sorted by it, without branches, and measured kind by kind.
class Optimizer::CostsOfEdges {
 public:
  CostsOfEdges(const Optimizer& optimizer, Costs& costs)
      : o_(optimizer), costs_(costs), many_(optimizer.values_) {}

  void add(std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const HalfEdgeId h{Index(i)}, twin = o_.delaunay_.twin(h);
      if (!twin.valid()) continue;
      const Index left = quadrilateral(h), right = quadrilateral(twin);
      const bool is_left_open = left != kClosed, is_right_open = right != kClosed;
      const bool counts = (h < twin) & ((left != right) | !is_left_open);
      std::size_t& size = size_[is_left_open + is_right_open];
      auto& edges = edges_[is_left_open + is_right_open];
      // If there is one quadrilateral, it is on the left.
      edges[size] = HalfEdgeId(std::array<Index, 2>{h, twin}[is_right_open & !is_left_open]);
      size += std::size_t{counts};
      if (size == edges.size()) measure();
    }
    measure();
  }

 private:
  Index quadrilateral(HalfEdgeId h) const { return o_.quadrilateral_[TriangleMesh::triangle(h)]; }
  Gradients gradients(HalfEdgeId h) const;
  void gather(std::span<const HalfEdgeId> edges);
  void measure();
  void measure_closed(std::span<const HalfEdgeId> edges);
  void measure_singles(std::span<const HalfEdgeId> edges);
  void measure_pairs(std::span<const HalfEdgeId> edges);

  const Optimizer& o_;
  Costs& costs_;
  ManyEdges many_;
  // With no, one and two quadrilaterals.
  std::array<std::array<HalfEdgeId, ManyEdges::kSize>, 3> edges_;
  std::array<std::size_t, 3> size_{};
};

/// The gradients on the left of h without and with the flip there, if there is one.
Optimizer::Gradients Optimizer::CostsOfEdges::gradients(HalfEdgeId h) const {
  const Quadrilateral& q = o_.quadrilaterals_[quadrilateral(h)];
  // What the flip makes of the triangles with these sides has the diagonal's origin.
  const bool has_origin = (h == TriangleMesh::prev(q.diagonal)) | (h == TriangleMesh::next(q.twin));
  return {o_.gradients_[TriangleMesh::triangle(h)], q.flipped[has_origin ? 0 : 1]};
}

void Optimizer::CostsOfEdges::gather(std::span<const HalfEdgeId> edges) {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const HalfEdgeId h = edges[i], twin = o_.delaunay_.twin(h);
    many_.set(i, o_.delaunay_.origin(h), o_.delaunay_.origin(twin), gradients(h), gradients(twin));
  }
}

void Optimizer::CostsOfEdges::measure() {
  const auto take = [&](int kind) {
    return std::span<const HalfEdgeId>(edges_[kind].data(), std::exchange(size_[kind], 0));
  };
  measure_closed(take(0));
  measure_singles(take(1));
  measure_pairs(take(2));
}

void Optimizer::CostsOfEdges::measure_closed(std::span<const HalfEdgeId> edges) {
  gather(edges);
  costs_.constant.add({many_.measure(edges.size(), 0, 0), edges.size()});
}

void Optimizer::CostsOfEdges::measure_singles(std::span<const HalfEdgeId> edges) {
  gather(edges);
  const double* const now = many_.measure(edges.size(), 0, 0);
  const double* const flipped = many_.measure(edges.size(), 1, 0);
  for (std::size_t i = 0; i < edges.size(); ++i)
    costs_.singles.push_back({choice(quadrilateral(edges[i])), {now[i], flipped[i]}});
}

void Optimizer::CostsOfEdges::measure_pairs(std::span<const HalfEdgeId> edges) {
  gather(edges);
  const double* const now = many_.measure(edges.size(), 0, 0);
  const double* const right = many_.measure(edges.size(), 0, 1);
  const double* const left = many_.measure(edges.size(), 1, 0);
  const double* const both = many_.measure(edges.size(), 1, 1);
  for (std::size_t i = 0; i < edges.size(); ++i)
    costs_.pairs.push_back({choice(quadrilateral(edges[i])),
                            choice(quadrilateral(o_.delaunay_.twin(edges[i]))),
                            {{{now[i], right[i]}, {left[i], both[i]}}}});
}

/// Returns what the edges cost that depend on no choice.
Total Optimizer::add_costs(Choices& choices) const {
  Total constant(values_);
  const auto find = [&](std::size_t first, std::size_t last, std::vector<Costs>& found) {
    CostsOfEdges(*this, found.emplace_back(values_)).add(first, last);
  };
  const auto add = [&](const std::vector<Costs>& parts) {
    for (const Costs& costs : parts) {
      constant.add(costs.constant);
      for (const Single& single : costs.singles) choices.add(single.choice, single.costs);
      choices.add(costs.pairs);
    }
  };
  // Pieces that stay in the cache.
  parallel_stream<Costs>(0, delaunay_.halfedge_count(), 1 << 14, 1 << 11, find, add);
  add_diagonals(choices);
  return constant;
}

void Optimizer::add_diagonals(Choices& choices) const {
  Buffer<SingleCosts> costs(quadrilaterals_.size());
  parallel_for(1, costs.size(), 1 << 12, [&](std::size_t first, std::size_t last) {
    ManyEdges many(values_);
    for (std::size_t begin = first; begin < last; begin += ManyEdges::kSize) {
      const std::size_t size = std::min(ManyEdges::kSize, last - begin);
      for (std::size_t i = 0; i < size; ++i) {
        const auto& [h, twin, flipped] = quadrilaterals_[begin + i];
        const Gradient &f = gradients_[TriangleMesh::triangle(h)],
                       &g = gradients_[TriangleMesh::triangle(twin)];
        many.set(i, delaunay_.origin(h), delaunay_.origin(twin), {f, f}, {g, g});
      }
      const double* const now = many.measure(size, 0, 0);
      for (std::size_t i = 0; i < size; ++i) {
        const auto& [h, twin, flipped] = quadrilaterals_[begin + i];
        many.set(i, delaunay_.apex(twin), delaunay_.apex(h), flipped, flipped);
      }
      const double* const flipped = many.measure(size, 0, 1);
      for (std::size_t i = 0; i < size; ++i) costs[begin + i] = {now[i], flipped[i]};
    }
  });
  for (Index q = 1; q < costs.size(); ++q) choices.add(choice(q), costs[q]);
}

MeasuredSolution Optimizer::choose_diagonals() {
  problem_.deadline.check();
  find_quadrilaterals();
  problem_.deadline.check();
  Choices choices(values_, static_cast<Index>(quadrilaterals_.size() - 1));
  const Total constant = add_costs(choices);
  problem_.deadline.check();
  const Choices::Result best = choices.best(problem_.deadline);
  std::vector<HalfEdgeId> flips;
  for (Index q = 1; q < quadrilaterals_.size(); ++q)
    if (best.chosen[choice(q)]) flips.push_back(quadrilaterals_[q].diagonal);
  const auto in_all = [&](Total total) {
    total.add(constant);
    return total;
  };
  const double before = in_all(choices.total(std::vector<bool>(best.chosen.size(), false))).value();
  const double after = in_all(choices.total(best.chosen)).value();
  const double bound = in_all(best.bound).bound();
  // What rounding suggests may be no gain.
  if (values_.better(before, after)) return measured(values_, {}, before, before, bound);
  return measured(values_, MeshChange(std::move(flips)), before, after, bound);
}

/// By flips, from there.
MeasuredSolution Optimizer::improve(const MeasuredSolution& first_order) {
  gradients_ = {}, quadrilaterals_ = {}, quadrilateral_ = {};  // their memory is wanted
  TriangleMesh mesh = first_order.change.applied_to(delaunay_);
  double result = improve(mesh), bound = 0;
  try {
    if (values_.is_sum() && problem_.method != Method::exact)
      bound = bound_by_fans(graph_, values_, problem_.order, problem_.deadline);
    else
      bound = search_on(mesh, result);
  } catch (const TimeIsUp&) {
    bound = trivial_bound(problem_.objective, graph_.xy, delaunay_);
  }
  return measured(values_, MeshChange(std::move(mesh)), first_order.delaunay, result, bound);
}

double Optimizer::improve(TriangleMesh& mesh) const {
  const int most_flips = problem_.method == Method::flip ? 1 : 6;
  improve_across_edges(graph_, values_, problem_.order, most_flips, problem_.deadline, mesh);
  return values_.of(mesh);
}

/// From what a more thorough bound suggests.
double Optimizer::search_on(TriangleMesh& mesh, double& result) const {
  EdgeBound suggestion = bound_across_edges(graph_, values_, problem_.order, result,
                                            problem_.deadline, problem_.method == Method::exact);
  const double other = problem_.method == Method::flip ? result : improve(suggestion.mesh);
  if (values_.better(other, result)) {
    result = other;
    mesh = std::move(suggestion.mesh);
  }
  return suggestion.bound;
}

}  // namespace

MeasuredSolution optimize_edge_measure(const MeasureProblem& problem) {
  return Optimizer(problem).run();
}

}  // namespace hodt
