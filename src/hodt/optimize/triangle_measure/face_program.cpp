#include "hodt/optimize/triangle_measure/face_program.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "hodt/optimize/rounded_sum.h"
#include "hodt/optimize/triangle_measure/edge_side.h"

namespace hodt {

namespace {

/// A row for every inner edge (left minus right is 0), and one for every side (the sum is 1).
BinaryRows rows_of(const FaceProblem& face) {
  // Of the triangles, each with its entry, and of the face (triangle kNone).
  std::vector<std::pair<EdgeSide, int>> sides;
  for (Index t = 0; t < face.triangles.size(); ++t)
    for (Index i = 0; i < 3; ++i) {
      const auto& corners = face.triangles[t].corners;
      sides.emplace_back(EdgeSide(corners[i], corners[(i + 1) % 3], t), int(3 * t + i));
    }
  for (const auto& [u, v] : face.sides) sides.emplace_back(EdgeSide(u, v, kNone), -1);
  std::sort(sides.begin(), sides.end(), [](const auto& a, const auto& b) {
    return std::tuple(a.first.edge(), a.second) < std::tuple(b.first.edge(), b.second);
  });
  BinaryRows program;
  for (std::size_t t = 0; t < face.triangles.size(); ++t) program.first.push_back(3 * t + 3);
  program.row.resize(3 * face.triangles.size());
  program.factor.resize(3 * face.triangles.size());
  const auto new_row = [&] {
    program.low.push_back(0);
    return int(program.low.size()) - 1;
  };
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    while (last < sides.size() && sides[last].first.edge() == sides[first].first.edge()) ++last;
    // Sides sort first. An edge with both sides on the face has two.
    const bool is_side = sides[first].second < 0;
    const int left = new_row(), right = is_side ? new_row() : left;
    for (std::size_t i = first; i < last; ++i) {
      const auto& [side, entry] = sides[i];
      const int row = side.is_left ? left : right;
      if (entry < 0) {
        program.low[std::size_t(row)] = 1;
      } else {
        program.row[std::size_t(entry)] = row;
        program.factor[std::size_t(entry)] = is_side || side.is_left ? 1 : -1;
      }
    }
  }
  program.high = program.low;
  return program;
}

/// For sums: of a face's value, for each of its triangles.
double enough(const FaceProblem& face) {
  return 1e-10 * double(face.size);
}

FaceSolution best_sum(BinaryProgram& program, const FaceProblem& face, const Aggregator& values) {
  const double sign = values.sign();
  // A triangle that costs more than all of a triangulation at hand is never worth it, however much
  // more, and a sliver's circumradius would spoil the scale.
  const double most = sign > 0 ? face.value : std::numeric_limits<double>::infinity();
  double largest = 0;
  for (const FaceTriangle& t : face.triangles) largest = std::max(largest, std::min(t.value, most));
  if (largest == 0) largest = 1;
  std::vector<double> costs;
  for (const FaceTriangle& t : face.triangles)
    costs.push_back(sign * std::min(t.value, most) / largest);
  const BinaryProgram::Solution solution = program.minimize(costs, enough(face));
  std::vector<double> spare;
  for (const double reduced : solution.reduced_costs)
    spare.push_back(std::max(largest * reduced, 0.0));
  // Each cost was rounded, and what a found solution costs.
  const double rounding = double(face.size) * 0x1p-51 * (1 + std::fabs(solution.bound));
  const double bound = bound_within(values, sign * largest * solution.bound, largest * rounding);
  return {solution.ones, std::max(bound, 0.0), std::move(spare)};  // no measure is negative
}

/// Values from best to worst, each once.
std::vector<double> values_best_first(const FaceProblem& face, const Aggregator& values) {
  std::vector<double> all;
  for (const FaceTriangle& t : face.triangles) all.push_back(t.value);
  std::sort(all.begin(), all.end(), [&](double a, double b) { return values.better(a, b); });
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

/// No triangulation of the face does without a value as bad as this: each side has a triangle.
double unavoidable(const FaceProblem& face, const Aggregator& values) {
  std::map<std::pair<VertexId, VertexId>, double> best_at;
  for (const auto& side : face.sides) best_at.emplace(side, values.worst());
  for (const FaceTriangle& t : face.triangles)
    for (Index i = 0; i < 3; ++i) {
      const auto at = best_at.find({t.corners[i], t.corners[(i + 1) % 3]});
      if (at != best_at.end() && values.better(t.value, at->second)) at->second = t.value;
    }
  double worst = values.identity();
  for (const auto& [side, best] : best_at) worst = values.combine(worst, best);
  return worst;
}

/// The worst value counts: bisects for the least bad one that a triangulation can do with. That
/// there is none without a worse triangle is proven by a bound above zero on their number.
FaceSolution best_worst(BinaryProgram& program, const FaceProblem& face, const Aggregator& values) {
  constexpr double kSomeAreWorse = 1e-6;
  const std::vector<double> candidates = values_best_first(face, values);
  const auto place_of = [&](double value) {
    const auto at = std::lower_bound(candidates.begin(), candidates.end(), value,
                                     [&](double a, double b) { return values.better(a, b); });
    return std::min(static_cast<std::size_t>(at - candidates.begin()), candidates.size() - 1);
  };
  std::size_t proven = place_of(unavoidable(face, values));  // all below are proven too good
  // The value at hand needs no program.
  std::size_t first = proven, last = std::max(place_of(face.value), proven);
  FaceSolution best;
  while (first < last && !program.is_out_of_time()) {
    const std::size_t middle = first + (last - first) / 2;
    std::vector<double> costs;
    for (const FaceTriangle& t : face.triangles)
      costs.push_back(values.better(candidates[middle], t.value) ? 1 : 0);
    BinaryProgram::Solution solution = program.minimize(costs, enough(face), kSomeAreWorse);
    const bool is_free =
        !solution.ones.empty() && std::all_of(solution.ones.begin(), solution.ones.end(),
                                              [&](Index t) { return costs[t] == 0; });
    if (is_free) {
      best.chosen = std::move(solution.ones);
      last = middle;
    } else {
      if (solution.bound > kSomeAreWorse && proven == first) proven = middle + 1;
      first = middle + 1;
    }
  }
  best.bound = candidates[proven];
  if (program.is_out_of_time()) return best;
  // With the worst value as it is, the others as good as can be.
  double worst = best.chosen.empty() ? face.value : values.identity();
  for (const Index t : best.chosen) worst = values.combine(worst, face.triangles[t].value);
  const double too_much = double(face.size) + 1;
  std::vector<double> costs;
  for (const FaceTriangle& t : face.triangles)
    costs.push_back(values.better(worst, t.value) ? too_much
                                                  : values.secondary_cost(t.value, worst));
  BinaryProgram::Solution rest = program.minimize(costs, enough(face));
  if (!rest.ones.empty() && std::none_of(rest.ones.begin(), rest.ones.end(),
                                         [&](Index t) { return costs[t] == too_much; }))
    best.chosen = std::move(rest.ones);
  return best;
}

/// The best value counts: any triangle that some triangulation has.
FaceSolution best_best(BinaryProgram& program, const FaceProblem& face, const Aggregator& values) {
  Index best = 0;
  for (Index t = 1; t < face.triangles.size(); ++t)
    if (values.better(face.triangles[t].value, face.triangles[best].value)) best = t;
  std::vector<double> costs(face.triangles.size(), 0);
  costs[best] = -1;
  return {program.minimize(costs, enough(face)).ones, face.triangles[best].value};
}

}  // namespace

bool FaceProgram::fits(const FaceProblem& face, const Deadline& deadline) {
  constexpr double kSecondsATriangle = 2e-5;
  return !deadline.is_limited() ||
         deadline.seconds_left() > kSecondsATriangle * double(face.triangles.size());
}

FaceProgram::FaceProgram(const FaceProblem& face, const Deadline& deadline,
                         std::size_t most_programs)
    : program_(rows_of(face), face.size, deadline, most_programs) {}

FaceSolution FaceProgram::solve(const FaceProblem& face, const Aggregator& values) {
  if (values.objective().aggregate == Aggregate::sum) return best_sum(program_, face, values);
  return values.worst_counts() ? best_worst(program_, face, values)
                               : best_best(program_, face, values);
}

}  // namespace hodt
