#include "hodt/optimize/face_program.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

#include <coin/Clp_C_Interface.h>

namespace hodt {

namespace {

constexpr int kMostIterations = 1'000'000;  // of one program

/// An edge of one of the triangles, or a side of the face (triangle kNone).
struct Use {
  Index low, high;
  bool forward;  // from low to high
  Index triangle;
  auto key() const { return std::tuple(low, high); }
};

/// The matrix, by columns: every triangle has three entries.
struct Program {
  std::vector<int> row_of;  // of entry 3t + i
  std::vector<double> sign_of;
  std::vector<double> right_hand_side;
};

Use use_of(VertexId u, VertexId v, Index triangle) {
  return {std::min<Index>(u, v), std::max<Index>(u, v), u < v, triangle};
}

/// A row for every inner edge (left minus right is 0), and one for every side (the sum is 1).
Program program_of(const FaceProblem& face) {
  std::vector<std::pair<Use, int>> uses;  // with the entry
  for (Index t = 0; t < face.triangles.size(); ++t)
    for (Index i = 0; i < 3; ++i) {
      const auto& corners = face.triangles[t].corners;
      uses.emplace_back(use_of(corners[i], corners[(i + 1) % 3], t), int(3 * t + i));
    }
  for (const auto& [u, v] : face.sides) uses.emplace_back(use_of(u, v, kNone), -1);
  std::sort(uses.begin(), uses.end(), [](const auto& a, const auto& b) {
    return std::tuple(a.first.key(), a.second) < std::tuple(b.first.key(), b.second);
  });
  Program program;
  program.row_of.resize(3 * face.triangles.size());
  program.sign_of.resize(3 * face.triangles.size());
  for (std::size_t first = 0, last = 0; first < uses.size(); first = last) {
    while (last < uses.size() && uses[last].first.key() == uses[first].first.key()) ++last;
    // Sides sort first. An edge with both sides on the face has two.
    const bool is_side = uses[first].second < 0;
    int rows[2];
    if (is_side) {
      for (int& row : rows) {
        row = int(program.right_hand_side.size());
        program.right_hand_side.push_back(0);
      }
    } else {
      rows[0] = rows[1] = int(program.right_hand_side.size());
      program.right_hand_side.push_back(0);
    }
    for (std::size_t i = first; i < last; ++i) {
      const auto& [use, entry] = uses[i];
      const int row = rows[use.forward ? 0 : 1];
      if (entry < 0) {
        program.right_hand_side[std::size_t(row)] = 1;
      } else {
        program.row_of[std::size_t(entry)] = row;
        program.sign_of[std::size_t(entry)] = is_side || use.forward ? 1 : -1;
      }
    }
  }
  return program;
}

/// Whether the chosen triangles fit together: every side once, every inner edge from both sides.
bool is_triangulation(const FaceProblem& face, const std::vector<Index>& chosen) {
  if (chosen.size() != face.size) return false;
  std::vector<std::pair<VertexId, VertexId>> edges, expected(face.sides.begin(), face.sides.end());
  for (const Index t : chosen)
    for (Index i = 0; i < 3; ++i)
      edges.emplace_back(face.triangles[t].corners[i], face.triangles[t].corners[(i + 1) % 3]);
  std::sort(edges.begin(), edges.end());
  std::sort(expected.begin(), expected.end());
  if (std::adjacent_find(edges.begin(), edges.end()) != edges.end()) return false;
  if (!std::includes(edges.begin(), edges.end(), expected.begin(), expected.end())) return false;
  for (const auto& edge : edges)
    if (!std::binary_search(expected.begin(), expected.end(), edge) &&
        !std::binary_search(edges.begin(), edges.end(), std::pair(edge.second, edge.first)))
      return false;
  return true;
}

double cost_of(const std::vector<Index>& chosen, const std::vector<double>& costs) {
  double sum = 0;
  for (const Index t : chosen) sum += costs[t];
  return sum;
}

/// The linear program of a face, for one vector of costs after another.
class FaceProgram {
 public:
  FaceProgram(const FaceProblem& face, const Deadline& deadline, std::size_t most_programs)
      : face_(face),
        program_(program_of(face)),
        deadline_(deadline),
        most_programs_(most_programs),
        model_(Clp_newModel(), Clp_deleteModel) {}

  struct Solution {
    std::vector<Index> chosen;  // none, or a triangulation
    double bound;               // no triangulation costs less
  };
  /// The cheapest triangulation; or, as soon as it is certain that all cost more than `too_much`,
  /// any or none. Costs are to be at most about 1 in size.
  Solution minimize(const std::vector<double>& costs,
                    double too_much = std::numeric_limits<double>::infinity());

 private:
  /// Triangles that are in or out, on the way to this part of all triangulations.
  struct Node {
    double bound;
    std::size_t number;  // breaks ties
    std::vector<std::pair<Index, bool>> fixed;
    bool operator<(const Node& other) const {  // the lowest bound comes first
      return std::tuple(bound, number) > std::tuple(other.bound, other.number);
    }
  };

  void load(const std::vector<double>& costs);
  void relax(const Node& node);
  double bound(const std::vector<double>& costs) const;
  Index largest_fraction() const;
  std::vector<Index> rounded() const;

  const FaceProblem& face_;
  const Program program_;
  const Deadline& deadline_;
  const std::size_t most_programs_;
  std::unique_ptr<Clp_Simplex, void (*)(Clp_Simplex*)> model_;
  std::vector<double> low_, high_;
};

void FaceProgram::load(const std::vector<double>& costs) {
  const std::size_t columns = costs.size();
  std::vector<CoinBigIndex> starts(columns + 1);
  for (std::size_t t = 0; t <= columns; ++t) starts[t] = CoinBigIndex(3 * t);
  low_.assign(columns, 0);
  high_.assign(columns, 1);
  Clp_setLogLevel(model_.get(), 0);
  Clp_loadProblem(model_.get(), int(columns), int(program_.right_hand_side.size()), starts.data(),
                  program_.row_of.data(), program_.sign_of.data(), low_.data(), high_.data(),
                  costs.data(), program_.right_hand_side.data(), program_.right_hand_side.data());
  Clp_setMaximumIterations(model_.get(), kMostIterations);
  // What the duals lack, the bound lacks many times.
  Clp_setDualTolerance(model_.get(), 1e-11);
}

void FaceProgram::relax(const Node& node) {
  std::fill(low_.begin(), low_.end(), 0);
  std::fill(high_.begin(), high_.end(), 1);
  for (const auto& [t, is_in] : node.fixed) (is_in ? low_ : high_)[t] = is_in;
  std::copy(low_.begin(), low_.end(), Clp_columnLower(model_.get()));
  std::copy(high_.begin(), high_.end(), Clp_columnUpper(model_.get()));
  if (deadline_.is_limited()) Clp_setMaximumSeconds(model_.get(), deadline_.seconds_left());
  if (node.fixed.empty())
    Clp_initialSolve(model_.get());
  else
    Clp_dual(model_.get(), 0);
}

/// For any y, x costs y·b and what the costs exceed y's part by. Of that, x takes what its limits
/// let it.
double FaceProgram::bound(const std::vector<double>& costs) const {
  const double* duals = Clp_dualRowSolution(model_.get());
  double sum = 0, size = 0;
  for (std::size_t row = 0; row < program_.right_hand_side.size(); ++row) {
    sum += program_.right_hand_side[row] * duals[row];
    size += program_.right_hand_side[row] * std::fabs(duals[row]);
  }
  double least = 0, below = 0, above = 0;
  for (std::size_t t = 0; t < costs.size(); ++t) {
    double reduced = costs[t], magnitude = std::fabs(costs[t]);
    for (std::size_t e = 3 * t; e < 3 * t + 3; ++e) {
      const double part = program_.sign_of[e] * duals[program_.row_of[e]];
      reduced -= part;
      magnitude += std::fabs(part);
    }
    reduced -= 8 * 0x1p-53 * magnitude;  // six roundings
    if (reduced > 0) {
      above += reduced * low_[t];
    } else {
      below += reduced * high_[t];
      if (high_[t] > 0) least = std::min(least, reduced);
    }
  }
  // Few of the triangles are in, face.size of them.
  below = std::max(below, double(face_.size) * least);
  const double terms = double(program_.right_hand_side.size() + costs.size());
  return sum + below + above - terms * 0x1p-52 * (size - below + above);
}

Index FaceProgram::largest_fraction() const {
  const double* x = Clp_getColSolution(model_.get());
  Index largest = kNone;
  for (Index t = 0; t < low_.size(); ++t)
    if (x[t] > 1e-6 && x[t] < 1 - 1e-6 && (largest == kNone || x[t] > x[largest])) largest = t;
  return largest;
}

std::vector<Index> FaceProgram::rounded() const {
  const double* x = Clp_getColSolution(model_.get());
  std::vector<Index> chosen;
  for (Index t = 0; t < low_.size(); ++t)
    if (x[t] > 0.5) chosen.push_back(t);
  if (!is_triangulation(face_, chosen)) chosen.clear();
  return chosen;
}

/// Best first, but each time down to a triangulation: a triangle that is mostly in is taken in, and
/// the case without it is left for later.
FaceProgram::Solution FaceProgram::minimize(const std::vector<double>& costs, double too_much) {
  constexpr double kEnough = 1e-10;  // of a face's value, for each of its triangles
  load(costs);
  Solution best{{}, 0};
  double cost = std::numeric_limits<double>::infinity();
  const double tolerance = kEnough * double(face_.size);
  double settled = cost;  // no triangulation in the parts that are left alone costs less
  std::priority_queue<Node> open;
  open.push({-cost, 0, {}});
  std::size_t nodes = 0;
  const auto is_over = [&] {
    return open.empty() || open.top().bound >= cost - tolerance ||
           std::min(open.top().bound, settled) > too_much ||
           (nodes > 0 && (nodes >= most_programs_ || deadline_.passed()));
  };
  while (!is_over()) {
    Node node = open.top();
    open.pop();
    for (;;) {
      relax(node);
      node.bound = std::max(node.bound, bound(costs));
      ++nodes;
      std::vector<Index> chosen = rounded();
      const double sum = chosen.empty() ? cost : cost_of(chosen, costs);
      if (sum < cost) {
        cost = sum;
        best.chosen = std::move(chosen);
      }
      const Index t = nodes < most_programs_ && !deadline_.passed() ? largest_fraction() : kNone;
      if (node.bound >= cost - tolerance || t == kNone) {
        settled = std::min(settled, node.bound);
        break;
      }
      Node without = node;
      without.number = nodes;
      without.fixed.emplace_back(t, false);
      open.push(std::move(without));
      node.fixed.emplace_back(t, true);
    }
  }
  best.bound = std::min(cost, settled);
  if (!open.empty()) best.bound = std::min(best.bound, open.top().bound);
  return best;
}

FaceSolution best_sum(FaceProgram& program, const FaceProblem& face, const TriangleValues& values) {
  const double sign = values.objective().direction == Direction::minimize ? 1 : -1;
  // A triangle that costs more than all of a triangulation at hand is never worth it, however much
  // more, and a sliver's circumradius would spoil the scale.
  const double most = sign > 0 ? face.value : std::numeric_limits<double>::infinity();
  double largest = 0;
  for (const FaceTriangle& t : face.triangles) largest = std::max(largest, std::min(t.value, most));
  if (largest == 0) largest = 1;
  std::vector<double> costs;
  for (const FaceTriangle& t : face.triangles)
    costs.push_back(sign * std::min(t.value, most) / largest);
  const FaceProgram::Solution solution = program.minimize(costs);
  // No measure is negative.
  return {solution.chosen, std::max(sign * largest * solution.bound, 0.0)};
}

/// Values from best to worst, each once.
std::vector<double> values_best_first(const FaceProblem& face, const TriangleValues& values) {
  std::vector<double> all;
  for (const FaceTriangle& t : face.triangles) all.push_back(t.value);
  std::sort(all.begin(), all.end(), [&](double a, double b) { return values.better(a, b); });
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

/// The worst value counts: bisects for the least bad one that a triangulation can do with. That
/// there is none without a worse triangle is proven by a bound above zero on their number.
FaceSolution best_worst(FaceProgram& program, const FaceProblem& face,
                        const TriangleValues& values) {
  constexpr double kSomeAreWorse = 1e-6;
  const std::vector<double> candidates = values_best_first(face, values);
  std::size_t first = 0, last = candidates.size() - 1;  // all below `first` are proven too good
  std::size_t proven = 0;
  FaceSolution best;
  while (first < last || (first == last && best.chosen.empty())) {
    const std::size_t middle = first + (last - first) / 2;
    std::vector<double> costs;
    for (const FaceTriangle& t : face.triangles)
      costs.push_back(values.better(candidates[middle], t.value) ? 1 : 0);
    FaceProgram::Solution solution = program.minimize(costs, kSomeAreWorse);
    const bool is_free =
        !solution.chosen.empty() && std::all_of(solution.chosen.begin(), solution.chosen.end(),
                                                [&](Index t) { return costs[t] == 0; });
    if (is_free) {
      best.chosen = std::move(solution.chosen);
      last = middle;
    } else {
      if (solution.bound > kSomeAreWorse && proven == first) proven = middle + 1;
      first = middle + 1;
    }
  }
  best.bound = candidates[std::min(proven, candidates.size() - 1)];
  if (best.chosen.empty()) return best;
  // With the worst value as it is, the others as good as can be.
  double worst = face.triangles[best.chosen.front()].value;
  for (const Index t : best.chosen) worst = values.combine(worst, face.triangles[t].value);
  const double too_much = double(face.size) + 1;
  std::vector<double> costs;
  for (const FaceTriangle& t : face.triangles)
    costs.push_back(values.better(worst, t.value) ? too_much
                                                  : values.secondary_cost(t.value, worst));
  FaceProgram::Solution rest = program.minimize(costs);
  if (!rest.chosen.empty() && std::none_of(rest.chosen.begin(), rest.chosen.end(),
                                           [&](Index t) { return costs[t] == too_much; }))
    best.chosen = std::move(rest.chosen);
  return best;
}

/// The best value counts: any triangle that some triangulation has.
FaceSolution best_best(FaceProgram& program, const FaceProblem& face,
                       const TriangleValues& values) {
  Index best = 0;
  for (Index t = 1; t < face.triangles.size(); ++t)
    if (values.better(face.triangles[t].value, face.triangles[best].value)) best = t;
  std::vector<double> costs(face.triangles.size(), 0);
  costs[best] = -1;
  return {program.minimize(costs).chosen, face.triangles[best].value};
}

}  // namespace

FaceSolution solve_face_program(const FaceProblem& face, const TriangleValues& values,
                                const Deadline& deadline, std::size_t most_programs) {
  FaceProgram program(face, deadline, most_programs);
  const Objective& objective = values.objective();
  if (objective.aggregate == Aggregate::sum) return best_sum(program, face, values);
  const bool worst_counts =
      (objective.aggregate == Aggregate::max) == (objective.direction == Direction::minimize);
  return worst_counts ? best_worst(program, face, values) : best_best(program, face, values);
}

}  // namespace hodt
