#include "hodt/optimize/edge_measure/edge_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "hodt/base/parallel.h"
#include "hodt/mesh/find_outgoing.h"
#include "hodt/mesh/replace_triangles.h"
#include "hodt/optimize/triangle_measure/edge_side.h"
#include "hodt/optimize/triangle_measure/faces.h"

namespace hodt {

namespace {

using Corners = std::array<VertexId, 3>;

/// Of a triangle with no edge that costs.
constexpr double kNever = -std::numeric_limits<double>::infinity();

/// A valid triangle at an edge.
struct ChargedSide : EdgeSide {
  double charge = 0;
};

/// An edge that can be between two triangles.
struct Edge {
  std::span<ChargedSide> left, right;
};

/// Whether doubles hold all that was charged to the triangles.
bool are_in_range(std::span<const FaceTriangle> triangles) {
  return std::all_of(triangles.begin(), triangles.end(),
                     [](const FaceTriangle& t) { return std::isfinite(t.value); });
}

/// Whether no triangle has an edge that costs: each is alone in its part of a domain.
bool cost_nothing(std::span<const FaceTriangle> triangles) {
  return std::all_of(triangles.begin(), triangles.end(),
                     [](const FaceTriangle& t) { return t.value == kNever; });
}

/// As much less for all triangles of a face, so that none costs less than nothing, and back. (Any
/// triangulation of it has as many.)
class Shift {
 public:
  Shift(std::span<FaceTriangle> triangles, bool is_sum) : is_sum_(is_sum) {
    if (!is_sum) lowest_ = std::numeric_limits<double>::infinity();
    for (const FaceTriangle& t : triangles) {
      if (t.value == kNever) continue;
      lowest_ = std::min(lowest_, t.value);
      most_ = std::max(most_, std::fabs(t.value));
    }
    if (!std::isfinite(lowest_)) lowest_ = 0;
    for (FaceTriangle& t : triangles) {
      const double value = std::max(t.value, lowest_);
      t.value = value - lowest_;
      if (!is_sum) shifted_.emplace_back(t.value, value);
    }
  }

  /// What a bound on the shifted values is on the former ones.
  double undone(double bound, std::size_t size) const {
    if (!is_sum_) {
      // That of a triangle no better than the bound: rounding leaves their order as it is.
      double least = std::numeric_limits<double>::infinity();
      for (const auto& [shifted, value] : shifted_)
        if (shifted >= bound) least = std::min(least, value);
      return least;
    }
    if (lowest_ == 0) return bound;
    // Each value was rounded once.
    const double difference = double(size) * lowest_;
    return bound + difference - double(size + 2) * 0x1p-51 * (most_ + std::fabs(bound));
  }

 private:
  const bool is_sum_;
  double lowest_ = 0, most_ = 0;
  std::vector<std::pair<double, double>> shifted_;
};

class Bound {
 public:
  Bound(const DelaunayGraph& graph, const EdgeValues& values, Index order, double at_hand,
        const Deadline& deadline)
      : graph_(graph),
        values_(values),
        deadline_(deadline),
        faces_(graph, order, deadline),
        objective_(values.objective()),
        sign_(values.sign()),
        most_(sign_ > 0 ? at_hand : std::numeric_limits<double>::infinity()) {
    find_edges();
    programs_.resize(faces_.size());
  }

  EdgeBound run(bool is_thorough) && {
    if (objective_.aggregate == Aggregate::sum) return charge_sums(is_thorough);
    EdgeBound result{0, graph_.mesh};
    result.bound = values_.worst_counts() ? least_largest(result.mesh) : best_pair();
    return result;
  }

 private:
  void find_edges();
  void sort_sides();
  double cost(const Edge& edge, const ChargedSide& left, const ChargedSide& right) const {
    return std::min(most_,
                    sign_ * values_.across(VertexId(edge.left[0].low), VertexId(edge.left[0].high),
                                           gradients_[left.triangle], gradients_[right.triangle]));
  }
  EdgeBound charge_sums(bool is_thorough);
  bool charge_all();
  void share(const Edge& edge, std::vector<double>& room) const;
  void take_back(const std::vector<FaceSolution>& solutions);
  double least_largest(TriangleMesh& mesh);
  void charge_least(const Edge& edge);
  double best_pair() const;
  double solve(Aggregate aggregate, std::vector<FaceSolution>& solutions);
  bool is_delaunay(const Corners& t) const;
  void take(const std::vector<FaceSolution>& solutions, TriangleMesh& mesh);

  const DelaunayGraph& graph_;
  const EdgeValues& values_;
  const Deadline& deadline_;
  Faces faces_;
  const Objective objective_;
  const double sign_;  // of costs: the less, the better
  // Whatever costs more than all edges of a triangulation at hand is not in the best one, however
  // much more: slivers would spoil the scale.
  const double most_;
  std::vector<EdgeValues::Gradient> gradients_;  // of the triangles
  std::vector<ChargedSide> sides_;
  std::vector<Edge> edges_;
  // Of faces that are not small, from one round to the next.
  static constexpr std::size_t kSmall = 50;
  std::vector<std::unique_ptr<FaceProgram>> programs_;
};

void Bound::find_edges() {
  const std::span<const FaceTriangle> triangles = faces_.triangles();
  gradients_.resize(triangles.size());
  sides_.resize(3 * triangles.size());
  parallel_for(0, triangles.size(), 1 << 12, [&](std::size_t first, std::size_t last) {
    for (std::size_t t = first; t < last; ++t) {
      const auto [a, b, c] = triangles[t].corners;
      gradients_[t] = values_.gradient(a, b, c);
      std::size_t at = 3 * t;
      for (const auto& [u, v] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
        sides_[at++] = {EdgeSide(u, v, Index(t))};
    }
  });
  sort_sides();
  for (auto first = sides_.begin(), last = first; first != sides_.end(); first = last) {
    while (last != sides_.end() && last->edge() == first->edge()) ++last;
    const auto middle =
        std::partition_point(first, last, [](const ChargedSide& side) { return side.is_left; });
    if (middle != first && middle != last) edges_.push_back({{first, middle}, {middle, last}});
  }
}

/// By their edges, what is on the left first: by the lower ends, and then of each of these.
void Bound::sort_sides() {
  const std::size_t n = graph_.xy.size();
  std::vector<std::size_t> first(n + 1, 0);
  for (const ChargedSide& side : sides_) ++first[side.low + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<ChargedSide> sorted(sides_.size());
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for (const ChargedSide& side : sides_) sorted[next[side.low]++] = side;
  sides_ = std::move(sorted);
  parallel_for(0, n, 1 << 10, [&](std::size_t v, std::size_t last) {
    deadline_.check();
    for (; v < last; ++v)
      std::sort(sides_.begin() + std::ptrdiff_t(first[v]),
                sides_.begin() + std::ptrdiff_t(first[v + 1]),
                [](const ChargedSide& x, const ChargedSide& y) {
                  return std::tuple(x.high, !x.is_left, x.triangle) <
                         std::tuple(y.high, !y.is_left, y.triangle);
                });
  });
}

/// Charges as much more as no pair exceeds its cost by: half of it to those on the left, then all
/// that is left, but for what rounding can make of it.
void Bound::share(const Edge& edge, std::vector<double>& room) const {
  const std::size_t width = edge.right.size();
  room.clear();
  double most = 0;
  for (const ChargedSide& left : edge.left)
    for (const ChargedSide& right : edge.right) {
      const double c = cost(edge, left, right);
      most = std::max({most, std::fabs(c), std::fabs(left.charge), std::fabs(right.charge)});
      room.push_back(c - left.charge - right.charge);
    }
  const auto charge_left = [&](double part) {
    for (std::size_t l = 0; l < edge.left.size(); ++l) {
      double* const row = &room[l * width];
      const double more = part * *std::min_element(row, row + width);
      edge.left[l].charge += more;
      for (std::size_t r = 0; r < width; ++r) row[r] -= more;
    }
  };
  const auto charge_right = [&] {
    for (std::size_t r = 0; r < width; ++r) {
      double more = room[r];
      for (std::size_t at = r; at < room.size(); at += width) more = std::min(more, room[at]);
      edge.right[r].charge += more;
      for (std::size_t at = r; at < room.size(); at += width) room[at] -= more;
    }
  };
  charge_left(0.5);
  charge_right();
  charge_left(1);
  // No number on the way was larger than the largest before and after together, a few times over,
  // and each rounding is 2^-53 of such a number at most.
  for (const std::span<const ChargedSide> sides : {edge.left, edge.right})
    for (const ChargedSide& side : sides) most = std::max(most, std::fabs(side.charge));
  for (ChargedSide& side : edge.left) side.charge -= 0x1p-46 * most;
}

/// What the triangles can spare, from all their edges alike.
void Bound::take_back(const std::vector<FaceSolution>& solutions) {
  std::vector<double> spare(faces_.triangles().size(), 0);
  for (Index face = 0; face < faces_.size(); ++face) {
    const auto begin = faces_.triangles(face).data() - faces_.triangles().data();
    std::copy(solutions[face].spare.begin(), solutions[face].spare.end(), spare.begin() + begin);
  }
  for (const Edge& edge : edges_)
    for (const std::span<ChargedSide> sides : {edge.left, edge.right})
      for (ChargedSide& side : sides) side.charge -= spare[side.triangle] / 3;
}

EdgeBound Bound::charge_sums(bool is_thorough) {
  // Later rounds gain little; how little is worth going on for.
  const double worth_it = is_thorough ? 1e-4 : 0.01;
  const int most_rounds = is_thorough ? 500 : 50;
  EdgeBound result{-std::numeric_limits<double>::infinity(), graph_.mesh};
  std::vector<FaceSolution> solutions(faces_.size());
  double best = std::numeric_limits<double>::infinity();
  bool is_bounded = false;
  for (int round = 0; round < most_rounds && (round == 0 || !deadline_.passed()); ++round) {
    if (!charge_all()) break;
    is_bounded = true;
    const double bound = solve(Aggregate::sum, solutions);
    if (!std::isfinite(bound)) break;  // nor would another round be in range
    TriangleMesh mesh = graph_.mesh;
    take(solutions, mesh);
    if (const double value = sign_ * values_.of(mesh); value < best) {
      best = value;
      result.mesh = std::move(mesh);
    }
    const double gain = bound - std::exchange(result.bound, std::max(result.bound, bound));
    if (gain <= worth_it * (best - result.bound)) break;
    take_back(solutions);
  }
  // One that no double holds is for whoever looks at the values to refuse.
  if (!is_bounded) throw TimeIsUp();
  result.bound = std::max(sign_ * result.bound, 0.0) + 0.0;
  return result;
}

/// False, and some edges left as they were, if time is up.
bool Bound::charge_all() {
  PerThread<std::vector<double>> scratch([] { return std::vector<double>(); });
  parallel_for(0, edges_.size(), 1 << 8, [&](std::size_t first, std::size_t last) {
    std::vector<double>& room = scratch.mine();
    if (deadline_.passed()) return;
    for (std::size_t e = first; e < last; ++e) share(edges_[e], room);
  });
  if (deadline_.passed()) return false;
  for (FaceTriangle& t : faces_.triangles()) t.value = 0;
  // A little less, so that the sum of three is less than that of the charges.
  for (const Edge& edge : edges_)
    for (const std::span<ChargedSide> sides : {edge.left, edge.right})
      for (const ChargedSide& side : sides)
        faces_.triangles()[side.triangle].value += side.charge - 0x1p-50 * std::fabs(side.charge);
  return true;
}

/// With a triangle there is, at each of its edges, a pair at least as bad as the best one it can be
/// in, or what the other triangle brings with it; and so on, as far as it goes.
double Bound::least_largest(TriangleMesh& mesh) {
  constexpr int kMostRounds = 100;
  const std::span<FaceTriangle> triangles = faces_.triangles();
  for (FaceTriangle& t : triangles) t.value = kNever;
  bool is_changing = true;
  for (int round = 0; is_changing && round < kMostRounds && !deadline_.passed(); ++round) {
    for (const Edge& edge : edges_) charge_least(edge);
    is_changing = false;
    for (const Edge& edge : edges_)
      for (const std::span<ChargedSide> sides : {edge.left, edge.right})
        for (const ChargedSide& side : sides) {
          double& value = triangles[side.triangle].value;
          is_changing |= value < side.charge;
          value = std::max(value, side.charge);
        }
  }
  std::vector<FaceSolution> solutions(faces_.size());
  const double bound = solve(Aggregate::max, solutions);
  take(solutions, mesh);
  return std::max(sign_ * bound, 0.0) + 0.0;  // never -0
}

void Bound::charge_least(const Edge& edge) {
  const std::span<const FaceTriangle> triangles = faces_.triangles();
  for (const std::span<ChargedSide> sides : {edge.left, edge.right})
    for (ChargedSide& side : sides) side.charge = std::numeric_limits<double>::infinity();
  for (ChargedSide& left : edge.left)
    for (ChargedSide& right : edge.right) {
      const double c = cost(edge, left, right);
      left.charge = std::min(left.charge, std::max(c, triangles[right.triangle].value));
      right.charge = std::min(right.charge, std::max(c, triangles[left.triangle].value));
    }
}

/// Any two triangles could be in some triangulation.
double Bound::best_pair() const {
  double best = std::numeric_limits<double>::infinity();
  for (const Edge& edge : edges_)
    for (const ChargedSide& left : edge.left)
      for (const ChargedSide& right : edge.right) best = std::min(best, cost(edge, left, right));
  return std::isfinite(best) ? sign_ * best : 0;
}

/// Asks the corner that is no hub.
bool Bound::is_delaunay(const Corners& t) const {
  const auto find_at = [&](Index i, Index most) {
    const VertexId b = t[(i + 1) % 3], c = t[(i + 2) % 3];
    return find_outgoing(graph_.mesh, graph_.outgoing[t[i]], most, [&](HalfEdgeId h) {
      return graph_.mesh.target(h) == b && graph_.mesh.apex(h) == c;
    });
  };
  for (Index i = 0; i < 3; ++i)
    if (const FoundOutgoing found = find_at(i, kFewTriangles); found.is_known)
      return found.halfedge.valid();
  return find_at(0, kNone).halfedge.valid();
}

/// The least that the triangles' values can sum up to, or their largest can be.
double Bound::solve(Aggregate aggregate, std::vector<FaceSolution>& solutions) {
  Objective objective = objective_;
  objective.direction = Direction::minimize;
  objective.aggregate = aggregate;
  const Aggregator least(objective);
  std::vector<double> bounds(faces_.size());
  PerThread<PolygonOptimum> polygons([] { return PolygonOptimum(); });
  parallel_for(0, faces_.size(), 1, [&](std::size_t first, std::size_t last) {
    for (auto face = static_cast<Index>(first); face < last; ++face) {
      // What is out of range is not bounded; what has no edge that costs decides nothing.
      const std::span<const FaceTriangle> all = faces_.triangles(face);
      if (aggregate == Aggregate::sum ? !are_in_range(all) : cost_nothing(all)) {
        solutions[face] = {};
        bounds[face] = kNever;
        continue;
      }
      const Shift shift(faces_.triangles(face), aggregate == Aggregate::sum);
      Total at_hand(least);
      for (const FaceTriangle& t : faces_.triangles(face))
        if (is_delaunay(t.corners)) at_hand.add(t.value);
      const std::size_t size = faces_.places(face).size();
      if (size == 1)
        solutions[face].bound = at_hand.value();
      else
        solutions[face] = faces_.solve(face, least, at_hand.value(), deadline_, 1, polygons.mine(),
                                       size > kSmall ? &programs_[face] : nullptr);
      bounds[face] = shift.undone(solutions[face].bound, size);
    }
  });
  Total bound(least);
  bound.add(bounds);
  return bound.bound();
}

void Bound::take(const std::vector<FaceSolution>& solutions, TriangleMesh& mesh) {
  for (Index face = 0; face < faces_.size(); ++face) {
    std::vector<Corners> chosen;
    for (const Index t : solutions[face].chosen)
      chosen.push_back(faces_.triangles(face)[t].corners);
    if (!chosen.empty()) replace_triangles(mesh, faces_.places(face), chosen);
  }
}

}  // namespace

EdgeBound bound_across_edges(const DelaunayGraph& graph, const EdgeValues& values, Index order,
                             double at_hand, const Deadline& deadline, bool is_thorough) {
  return Bound(graph, values, order, at_hand, deadline).run(is_thorough);
}

}  // namespace hodt
