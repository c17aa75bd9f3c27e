#include "hodt/optimize/in_order/first_order_in_order.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "hodt/geometry/heights.h"
#include "hodt/mesh/mesh_change.h"
#include "hodt/optimize/measure/edge_measures.h"
#include "hodt/optimize/measure/measures.h"
#include "hodt/optimize/solve/ordered_choices.h"
#include "hodt/optimize/value_of.h"
#include "hodt/order/first_order/first_order.h"

namespace hodt {

namespace {

constexpr std::array<bool, 2> kBoth{false, true};

/// The quadrilaterals, each with the choice whether its Delaunay diagonal is flipped, and what the
/// choices are for the objectives.
class FirstOrder {
 public:
  explicit FirstOrder(const OrderedProblem& problem)
      : problem_(problem),
        graph_(problem.graph),
        delaunay_(problem.graph.mesh),
        diagonals_(first_order_edges(problem.graph)),
        quadrilateral_(delaunay_.triangle_count(), kNone) {
    for (Index q = 0; q < diagonals_.size(); ++q)
      for (const HalfEdgeId h : {diagonals_[q], delaunay_.twin(diagonals_[q])})
        quadrilateral_[TriangleMesh::triangle(h)] = q;
  }

  FirstOrderInOrder solve(const TriangleMesh& at_hand) const;

 private:
  using Choices = OrderedChoices;
  struct Corners {
    VertexId a, b, c, d;  // abc on the left of the diagonal ab, and bad
  };

  Corners corners(Index q) const {
    const HalfEdgeId h = diagonals_[q], twin = delaunay_.twin(h);
    return {delaunay_.origin(h), delaunay_.target(h), delaunay_.apex(h), delaunay_.apex(twin)};
  }
  bool is_diagonal(HalfEdgeId h) const {
    const Index q = quadrilateral_[TriangleMesh::triangle(h)];
    return q != kNone && (diagonals_[q] == h || delaunay_.twin(diagonals_[q]) == h);
  }
  /// Of the triangle at the side h of a quadrilateral, or of a triangle in none.
  VertexId apex(HalfEdgeId h, bool is_flipped) const {
    if (!is_flipped) return delaunay_.apex(h);
    const Index q = quadrilateral_[TriangleMesh::triangle(h)];
    const HalfEdgeId twin = delaunay_.twin(diagonals_[q]);
    const bool is_left = TriangleMesh::triangle(h) == TriangleMesh::triangle(diagonals_[q]);
    return delaunay_.apex(is_left ? twin : diagonals_[q]);
  }

  Choices choices_of(std::span<const Objective> objectives, std::span<const double> limits) const;
  template <class Values>
  void add_measure(const Objective& objective, std::size_t level, const double* limit,
                   Choices& choices) const;
  template <class F>
  void for_each_term(const TriangleValues& values, const F& f) const;
  template <class F>
  void for_each_term(const EdgeValues& values, const F& f) const;
  void add_extrema(const Objective& objective, std::size_t level, Choices& choices) const;
  void add_extrema(const Heights& heights, Extremum kind, std::size_t level,
                   Choices& choices) const;
  void keep_minima(Choices& choices) const;
  TriangleMesh mesh_of(const std::vector<bool>& flipped) const;
  std::vector<bool> flipped_in(const TriangleMesh& mesh) const;

  const OrderedProblem& problem_;
  const DelaunayGraph& graph_;
  const TriangleMesh& delaunay_;
  const std::vector<HalfEdgeId> diagonals_;
  Buffer<Index> quadrilateral_;  // that a triangle is in, or kNone
};

bool is_extreme(const Objective& objective) {
  return objective.kind == Objective::measured && objective.aggregate != Aggregate::sum;
}

/// Whether all can be put into costs and limits.
bool is_solvable(std::span<const Objective> objectives) {
  for (std::size_t i = 0; i < objectives.size(); ++i) {
    if (objectives[i] == Objective::min_max_degree) return false;
    const bool is_last = i + 1 == objectives.size();
    if (!is_last && is_extreme(objectives[i]) && !Aggregator(objectives[i]).worst_counts())
      return false;
  }
  return true;
}

/// Objective by objective, as a largest or smallest value has to be known before it can be a limit
/// for what comes after.
FirstOrderInOrder FirstOrder::solve(const TriangleMesh& at_hand) const {
  const std::vector<bool> before = flipped_in(at_hand);
  FirstOrderInOrder result{at_hand, true};
  std::vector<double> limits;
  for (std::size_t i = 0; i < problem_.objectives.size(); ++i) {
    limits.push_back(value_of(problem_.objectives[i], result.mesh, graph_.xy, problem_.z));
    if (i + 1 == problem_.objectives.size()) break;
    Choices::Result best =
        choices_of(problem_.objectives.first(i + 2), limits).best(problem_.deadline);
    for (std::size_t q = 0; q < before.size(); ++q) {
      if (best.is_solved[q]) continue;
      best.chosen[q] = before[q];
      result.is_best = false;
    }
    result.mesh = mesh_of(best.chosen);
  }
  return result;
}

/// With a cost for the last of the objectives, and one or a limit for each before.
OrderedChoices FirstOrder::choices_of(std::span<const Objective> objectives,
                                      std::span<const double> limits) const {
  const Objective& last = objectives.back();
  const auto is_limit = [&](const Objective& o) { return is_extreme(o) && o != last; };
  const auto costs = std::count_if(objectives.begin(), objectives.end(),
                                   [&](const Objective& o) { return !is_limit(o); });
  Choices choices(static_cast<Index>(diagonals_.size()), static_cast<std::size_t>(costs),
                  !is_extreme(last)                 ? Choices::Combine::sum
                  : Aggregator(last).worst_counts() ? Choices::Combine::max
                                                    : Choices::Combine::min);
  std::size_t level = 0;
  for (std::size_t i = 0; i < objectives.size(); ++i) {
    const Objective& objective = objectives[i];
    const double* limit = is_limit(objective) ? &limits[i] : nullptr;
    if (counts_extrema(objective))
      add_extrema(objective, level, choices);
    else if (is_of_edges(objective))
      add_measure<EdgeValues>(objective, level, limit, choices);
    else
      add_measure<TriangleValues>(objective, level, limit, choices);
    level += limit == nullptr;
  }
  if (counts_minima(objectives.front())) keep_minima(choices);
  return choices;
}

template <class Values>
void FirstOrder::add_measure(const Objective& objective, std::size_t level, const double* limit,
                             Choices& choices) const {
  const Values values(objective, graph_.xy, problem_.z);
  for_each_term(values, [&](std::span<const Index> on, std::span<double> costs) {
    if (limit != nullptr) {
      for (std::size_t setting = 0; setting < costs.size(); ++setting)
        if (values.better(*limit, costs[setting])) choices.forbid(on, setting);
      return;
    }
    for (double& cost : costs) cost *= values.sign();
    choices.add(level, on, costs);
  });
}

/// Calls f with a choice and what a triangle measures for both settings of it.
template <class F>
void FirstOrder::for_each_term(const TriangleValues& values, const F& f) const {
  for (Index q = 0; q < diagonals_.size(); ++q) {
    const auto [a, b, c, d] = corners(q);
    const Index on[] = {q};
    double first[] = {values.of(a, b, c), values.of(a, d, c)};
    double second[] = {values.of(b, a, d), values.of(b, c, d)};
    f(on, std::span<double>(first));
    f(on, std::span<double>(second));
  }
}

/// Calls f with the choices, one or two, that an edge depends on and what it measures for their
/// settings.
template <class F>
void FirstOrder::for_each_term(const EdgeValues& values, const F& f) const {
  for (Index q = 0; q < diagonals_.size(); ++q) {
    const auto [a, b, c, d] = corners(q);
    const Index on[] = {q};
    double costs[] = {values.of(a, b, c, d), values.of(d, c, a, b)};
    f(on, std::span<double>(costs));
  }
  for (Index i = 0; i < delaunay_.halfedge_count(); ++i) {
    HalfEdgeId h(i), twin = delaunay_.twin(h);
    if (!twin.valid() || twin < h || is_diagonal(h)) continue;
    Index left = quadrilateral_[TriangleMesh::triangle(h)];
    Index right = quadrilateral_[TriangleMesh::triangle(twin)];
    if (left == kNone) {
      std::swap(left, right);
      std::swap(h, twin);
    }
    if (left == kNone) continue;  // settled
    const auto value = [&](bool x, bool y) {
      return values.of(delaunay_.origin(h), delaunay_.target(h), apex(h, x), apex(twin, y));
    };
    if (right == kNone) {
      const Index on[] = {left};
      double costs[] = {value(false, false), value(true, false)};
      f(on, std::span<double>(costs));
    } else if (right == left) {  // both sides are of one quadrilateral, around a vertex
      const Index on[] = {left};
      double costs[] = {value(false, false), value(true, true)};
      f(on, std::span<double>(costs));
    } else {
      const Index on[] = {left, right};
      double costs[] = {value(false, false), value(true, false), value(false, true),
                        value(true, true)};
      f(on, std::span<double>(costs));
    }
  }
}

void FirstOrder::add_extrema(const Objective& objective, std::size_t level,
                             Choices& choices) const {
  const Heights heights{graph_.xy, problem_.z};
  if (counts_minima(objective)) add_extrema(heights, Extremum::minimum, level, choices);
  if (counts_maxima(objective)) add_extrema(heights, Extremum::maximum, level, choices);
}

/// A vertex costs 1 if none of the diagonals that could remove it is there; unless another edge
/// does, which is always there.
void FirstOrder::add_extrema(const Heights& heights, Extremum kind, std::size_t level,
                             Choices& choices) const {
  const auto removed_by = [&](VertexId u, VertexId v) {
    return heights.removes(u, v, kind) ? v : u;
  };
  std::vector<bool> is_settled(delaunay_.vertex_count(), false);
  for (Index i = 0; i < delaunay_.halfedge_count(); ++i)
    if (const HalfEdgeId h(i); !is_diagonal(h))
      is_settled[removed_by(delaunay_.origin(h), delaunay_.target(h))] = true;
  struct Remover {
    Index removed, quadrilateral;
    bool is_flipped;
    bool operator<(const Remover& other) const {
      return std::pair(removed, quadrilateral) < std::pair(other.removed, other.quadrilateral);
    }
  };
  std::vector<Remover> removers;
  for (Index q = 0; q < diagonals_.size(); ++q) {
    const auto [a, b, c, d] = corners(q);
    for (const bool is_flipped : kBoth) {
      const VertexId removed = is_flipped ? removed_by(c, d) : removed_by(a, b);
      if (!is_settled[removed]) removers.push_back({removed, q, is_flipped});
    }
  }
  std::sort(removers.begin(), removers.end());
  for (std::size_t i = 0, end = 0; i < removers.size(); i = end) {
    std::vector<Index> on;
    std::size_t none = 0;  // the setting in which none is there
    for (; end < removers.size() && removers[end].removed == removers[i].removed; ++end) {
      if (on.size() < Choices::kWidest) none |= std::size_t{!removers[end].is_flipped} << on.size();
      on.push_back(removers[end].quadrilateral);
    }
    std::vector<double> costs(std::size_t{1} << std::min(on.size(), Choices::kWidest), 0);
    costs[none] = 1;
    choices.add(level, on, costs);
  }
}

/// No diagonal may remove a minimum that has to stay.
void FirstOrder::keep_minima(Choices& choices) const {
  const Heights heights{graph_.xy, problem_.z};
  for (Index q = 0; q < diagonals_.size(); ++q) {
    const auto [a, b, c, d] = corners(q);
    const Index on[] = {q};
    if (problem_.kept[heights.lower(c, d) ? d : c]) choices.forbid(on, 1);
    if (problem_.kept[heights.lower(a, b) ? b : a]) choices.forbid(on, 0);
  }
}

TriangleMesh FirstOrder::mesh_of(const std::vector<bool>& flipped) const {
  std::vector<HalfEdgeId> flips;
  for (std::size_t q = 0; q < flipped.size(); ++q)
    if (flipped[q]) flips.push_back(diagonals_[q]);
  return MeshChange(std::move(flips)).applied_to(delaunay_);
}

std::vector<bool> FirstOrder::flipped_in(const TriangleMesh& mesh) const {
  std::vector<std::pair<Index, Index>> edges;
  for (Index i = 0; i < mesh.halfedge_count(); ++i)
    edges.emplace_back(mesh.origin(HalfEdgeId(i)), mesh.target(HalfEdgeId(i)));
  std::sort(edges.begin(), edges.end());
  std::vector<bool> flipped;
  for (Index q = 0; q < diagonals_.size(); ++q) {
    const Corners at = corners(q);
    flipped.push_back(
        !std::binary_search(edges.begin(), edges.end(), std::pair<Index, Index>(at.a, at.b)));
  }
  return flipped;
}

}  // namespace

FirstOrderInOrder first_order_in_order(const OrderedProblem& problem, const TriangleMesh& mesh) {
  if (!is_solvable(problem.objectives)) return {mesh, false};
  return FirstOrder(problem).solve(mesh);
}

}  // namespace hodt
