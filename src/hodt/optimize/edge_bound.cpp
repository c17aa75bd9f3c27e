#include "hodt/optimize/edge_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <tuple>
#include <vector>

#include "hodt/base/parallel.h"
#include "hodt/mesh/replace_triangles.h"
#include "hodt/optimize/faces.h"

namespace hodt {

namespace {

using Corners = std::array<VertexId, 3>;

/// A valid triangle at an edge.
struct Use {
  Index low, high;
  bool is_left;  // of low -> high
  Index triangle;
  EdgeValues::Gradient gradient;

  auto edge() const { return std::tuple(low, high); }
};

class Bound {
 public:
  Bound(const DelaunayGraph& graph, const EdgeValues& values, Index order, const Deadline& deadline)
      : graph_(graph), values_(values), deadline_(deadline), faces_(graph, order) {
    const Objective& objective = values.objective();
    sign_ = objective.direction == Direction::minimize ? 1 : -1;
    is_sum_ = objective.aggregate == Aggregate::sum;
    is_worst_ =
        (objective.aggregate == Aggregate::max) == (objective.direction == Direction::minimize);
  }

  EdgeBound run() && {
    charge();
    EdgeBound result{0, graph_.mesh};
    if (!is_sum_ && !is_worst_) {  // any pair could be there
      result.bound = sign_ * best_pair_;
      return result;
    }
    solve(result);
    return result;
  }

 private:
  /// Charged with nothing yet, of largest values.
  static constexpr double kNever = -std::numeric_limits<double>::infinity();

  std::vector<Use> uses();
  void charge();
  void charge_pairs(std::span<const Use> left, std::span<const Use> right);
  void solve(EdgeBound& result);
  double make_positive(std::span<FaceTriangle> triangles) const;
  bool is_delaunay(const Corners& t) const;

  const DelaunayGraph& graph_;
  const EdgeValues& values_;
  const Deadline& deadline_;
  Faces faces_;
  double sign_;  // of costs: the less, the better
  bool is_sum_, is_worst_;
  double best_pair_ = std::numeric_limits<double>::infinity();
  std::vector<double> costs_, left_, right_;  // of one edge
};

/// By edges, those on the left of one first.
std::vector<Use> Bound::uses() {
  const std::span<const FaceTriangle> triangles = faces_.triangles();
  std::vector<Use> uses(3 * triangles.size());
  parallel_for(0, triangles.size(), 1 << 12, [&](std::size_t first, std::size_t last) {
    for (std::size_t t = first; t < last; ++t) {
      const auto [a, b, c] = triangles[t].corners;
      const EdgeValues::Gradient gradient = values_.gradient(a, b, c);
      std::size_t at = 3 * t;
      for (const auto& [u, v] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
        uses[at++] = {std::min<Index>(u, v), std::max<Index>(u, v), u < v, Index(t), gradient};
    }
  });
  std::sort(uses.begin(), uses.end(), [](const Use& x, const Use& y) {
    return std::tuple(x.edge(), !x.is_left, x.triangle) <
           std::tuple(y.edge(), !y.is_left, y.triangle);
  });
  return uses;
}

void Bound::charge() {
  for (FaceTriangle& t : faces_.triangles()) t.value = is_sum_ ? 0 : kNever;
  const std::vector<Use> all = uses();
  for (auto first = all.begin(), last = first; first != all.end(); first = last) {
    while (last != all.end() && last->edge() == first->edge()) ++last;
    const auto middle =
        std::partition_point(first, last, [](const Use& use) { return use.is_left; });
    if (middle != first && middle != last) charge_pairs({first, middle}, {middle, last});
  }
}

/// Half of the least that it can cost to each; then as much more as all pairs leave, to those on
/// the left and to those on the right. Of largest values, to each the least that it can be in.
void Bound::charge_pairs(std::span<const Use> left, std::span<const Use> right) {
  const VertexId a(left[0].low), b(left[0].high);
  costs_.clear();
  for (const Use& l : left)
    for (const Use& r : right)
      costs_.push_back(sign_ * values_.across(a, b, l.gradient, r.gradient));
  best_pair_ = std::min(best_pair_, *std::min_element(costs_.begin(), costs_.end()));
  const auto least_left = [&](std::size_t l, const auto& charged_right) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t r = 0; r < right.size(); ++r)
      least = std::min(least, costs_[l * right.size() + r] - charged_right(r));
    return least;
  };
  const auto least_right = [&](std::size_t r, const auto& charged_left) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t l = 0; l < left.size(); ++l)
      least = std::min(least, costs_[l * right.size() + r] - charged_left(l));
    return least;
  };
  const auto nothing = [](std::size_t) { return 0.0; };
  left_.resize(left.size());
  right_.resize(right.size());
  for (std::size_t r = 0; r < right.size(); ++r) right_[r] = least_right(r, nothing);
  if (is_sum_) {
    for (double& charged : right_) charged /= 2;
    const auto of_right = [&](std::size_t r) { return right_[r]; };
    for (std::size_t l = 0; l < left.size(); ++l) left_[l] = least_left(l, of_right);
    const auto of_left = [&](std::size_t l) { return left_[l]; };
    for (std::size_t r = 0; r < right.size(); ++r) right_[r] = least_right(r, of_left);
  } else {
    for (std::size_t l = 0; l < left.size(); ++l) left_[l] = least_left(l, nothing);
  }
  const auto add = [&](std::span<const Use> uses, const std::vector<double>& charged) {
    for (std::size_t i = 0; i < uses.size(); ++i) {
      double& value = faces_.triangles()[uses[i].triangle].value;
      value = is_sum_ ? value + charged[i] : std::max(value, charged[i]);
    }
  };
  add(left, left_);
  add(right, right_);
}

bool Bound::is_delaunay(const Corners& t) const {
  bool found = false;
  for_each_outgoing(graph_.mesh, graph_.outgoing[t[0]], [&](HalfEdgeId h) {
    found |= graph_.mesh.target(h) == t[1] && graph_.mesh.apex(h) == t[2];
  });
  return found;
}

void Bound::solve(EdgeBound& result) {
  const Combination least(Objective(Direction::minimize, is_sum_ ? Aggregate::sum : Aggregate::max,
                                    values_.objective().measure));
  std::vector<FaceSolution> solutions(faces_.size());
  PerThread<PolygonOptimum> polygons([] { return PolygonOptimum(); });
  parallel_for(0, faces_.size(), 1, [&](std::size_t first, std::size_t last) {
    for (auto face = static_cast<Index>(first); face < last; ++face) {
      const double shift = make_positive(faces_.triangles(face));
      double at_hand = least.neutral();
      for (const FaceTriangle& t : faces_.triangles(face))
        if (is_delaunay(t.corners)) at_hand = least.combine(at_hand, t.value);
      const std::size_t size = faces_.places(face).size();
      if (size == 1)
        solutions[face].bound = at_hand;
      else
        solutions[face] = faces_.solve(face, least, at_hand, deadline_, 1, polygons.mine());
      solutions[face].bound += is_sum_ ? double(size) * shift : shift;
    }
  });
  double bound = least.neutral(), size = 0;
  for (Index face = 0; face < faces_.size(); ++face) {
    const FaceSolution& solution = solutions[face];
    bound = least.combine(bound, solution.bound);
    size += std::fabs(solution.bound);
    std::vector<Corners> chosen;
    for (const Index t : solution.chosen) chosen.push_back(faces_.triangles(face)[t].corners);
    if (!chosen.empty()) replace_triangles(result.mesh, faces_.places(face), chosen);
  }
  if (is_sum_) bound -= 1e-12 * size;  // far more than what rounding does
  result.bound = std::max(sign_ * bound, 0.0);
}

/// The same less for all triangles of a face, so that none costs less than nothing; returns how
/// much. (Any triangulation of it has as many.)
double Bound::make_positive(std::span<FaceTriangle> triangles) const {
  double lowest = is_sum_ ? 0 : std::numeric_limits<double>::infinity();
  for (const FaceTriangle& t : triangles)
    if (t.value != kNever) lowest = std::min(lowest, t.value);
  if (!std::isfinite(lowest)) lowest = 0;
  for (FaceTriangle& t : triangles) t.value = std::max(t.value, lowest) - lowest;
  return lowest;
}

}  // namespace

EdgeBound bound_across_edges(const DelaunayGraph& graph, const EdgeValues& values, Index order,
                             const Deadline& deadline) {
  return Bound(graph, values, order, deadline).run();
}

}  // namespace hodt
