#include "hodt/optimize/triangle_measure/polygon_optimum.h"

#include <algorithm>

#include "hodt/optimize/rounded_sum.h"

namespace hodt {

/// Numbers the vertices along the boundary; false if it is not one simple polygon.
bool PolygonOptimum::walk_around(const FaceProblem& face) {
  by_origin_.assign(face.sides.begin(), face.sides.end());
  std::sort(by_origin_.begin(), by_origin_.end());
  positions_.clear();
  VertexId at = by_origin_.front().first;
  const VertexId start = at;
  do {
    const auto side =
        std::lower_bound(by_origin_.begin(), by_origin_.end(), std::pair(at, VertexId(0)));
    if (side == by_origin_.end() || side->first != at) return false;
    if (side + 1 != by_origin_.end() && side[1].first == at) return false;  // met twice
    if (positions_.size() == by_origin_.size()) return false;
    positions_.emplace_back(at, static_cast<Index>(positions_.size()));
    at = side->second;
  } while (at != start);
  std::sort(positions_.begin(), positions_.end());
  // A polygon of m vertices has m - 2 triangles; vertices inside would make it more.
  return positions_.size() == by_origin_.size() && face.size + 2 == positions_.size();
}

Index PolygonOptimum::position(VertexId v) const {
  return std::lower_bound(positions_.begin(), positions_.end(), std::pair(v, Index(0)))->second;
}

std::optional<FaceSolution> PolygonOptimum::solve(const FaceProblem& face,
                                                  const Aggregator& values) {
  if (face.sides.size() > kMostVertices || !walk_around(face)) return std::nullopt;
  const auto m = static_cast<Index>(positions_.size());
  placed_.clear();
  for (Index t = 0; t < face.triangles.size(); ++t) {
    std::array<Index, 3> at;
    for (Index i = 0; i < 3; ++i) at[i] = position(face.triangles[t].corners[i]);
    std::sort(at.begin(), at.end());
    placed_.push_back({at[0], at[1], at[2], t});
  }
  // Shorter chains first.
  std::sort(placed_.begin(), placed_.end(), [](const Placed& a, const Placed& b) {
    const Index span_a = a.last - a.first, span_b = b.last - b.first;
    return span_a != span_b ? span_a < span_b : a.triangle < b.triangle;
  });
  best_.assign(std::size_t(m) * m, {0, 0, 0, kNone, kNone});
  const auto best = [&](Index i, Index j) -> Best& { return best_[std::size_t(i) * m + j]; };
  for (Index i = 0; i + 1 < m; ++i)
    best(i, i + 1) = {values.identity(), 0, values.identity(), kNone, i};
  for (const Placed& p : placed_) {
    const Best &left = best(p.first, p.apex), &right = best(p.apex, p.last);
    if (left.apex == kNone || right.apex == kNone) continue;
    const double own = face.triangles[p.triangle].value;
    const double value = values.combine(own, values.combine(left.value, right.value));
    const double bound =
        combine_outward(values, own, combine_outward(values, left.bound, right.bound));
    const double rest = values.secondary_cost(own, face.value) + left.secondary + right.secondary;
    Best& target = best(p.first, p.last);
    const double best_bound =
        target.apex == kNone || values.better(bound, target.bound) ? bound : target.bound;
    if (target.apex == kNone || values.better(value, target.value) ||
        (value == target.value && rest < target.secondary))
      target = {value, rest, 0, p.triangle, p.apex};
    target.bound = best_bound;
  }
  if (best(0, m - 1).apex == kNone) return std::nullopt;
  FaceSolution solution;
  solution.bound = best(0, m - 1).bound;
  std::vector<std::pair<Index, Index>> chains{{0, m - 1}};
  while (!chains.empty()) {
    const auto [i, j] = chains.back();
    chains.pop_back();
    if (j == i + 1) continue;
    const Best& chain = best(i, j);
    solution.chosen.push_back(chain.triangle);
    chains.emplace_back(i, chain.apex);
    chains.emplace_back(chain.apex, j);
  }
  std::sort(solution.chosen.begin(), solution.chosen.end());
  if (values.objective().aggregate == Aggregate::sum) {
    solution.spare.resize(face.triangles.size());
    for (const Placed& p : placed_) {
      const Best &left = best(p.first, p.apex), &right = best(p.apex, p.last);
      const double own = face.triangles[p.triangle].value;
      const bool is_possible = left.apex != kNone && right.apex != kNone;
      solution.spare[p.triangle] =
          is_possible ? own + left.value + right.value - best(p.first, p.last).value : own;
    }
  }
  return solution;
}

}  // namespace hodt
