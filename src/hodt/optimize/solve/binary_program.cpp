#include "hodt/optimize/solve/binary_program.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>
#include <utility>

#include <coin/Clp_C_Interface.h>

namespace hodt {

namespace {

constexpr int kMostIterations = 1'000'000;  // of one program

double cost_of(const std::vector<Index>& ones, const std::vector<double>& costs) {
  double sum = 0;
  for (const Index i : ones) sum += costs[i];
  return sum;
}

}  // namespace

/// Variables that are in or out, on the way to this part of all solutions.
struct BinaryProgram::Node {
  double bound;
  std::size_t number;  // breaks ties
  std::vector<std::pair<Index, bool>> fixed;
  bool operator<(const Node& other) const {  // the lowest bound comes first
    return std::tuple(bound, number) > std::tuple(other.bound, other.number);
  }
};

BinaryProgram::BinaryProgram(BinaryRows rows, std::size_t most_ones, const Deadline& deadline,
                             std::size_t most_programs)
    : rows_(std::move(rows)),
      most_ones_(most_ones),
      deadline_(deadline),
      most_programs_(most_programs),
      model_(Clp_newModel(), Clp_deleteModel) {}

void BinaryProgram::load(const std::vector<double>& costs) {
  is_begun_ = !low_.empty();
  if (is_begun_) {
    std::copy(costs.begin(), costs.end(), Clp_objective(model_.get()));
    return;
  }
  const std::vector<CoinBigIndex> first(rows_.first.begin(), rows_.first.end());
  low_.assign(costs.size(), 0);
  high_.assign(costs.size(), 1);
  Clp_setLogLevel(model_.get(), 0);
  Clp_loadProblem(model_.get(), int(costs.size()), int(rows_.low.size()), first.data(),
                  rows_.row.data(), rows_.factor.data(), low_.data(), high_.data(), costs.data(),
                  rows_.low.data(), rows_.high.data());
  Clp_setMaximumIterations(model_.get(), kMostIterations);
  // What the duals lack, the bound lacks many times.
  Clp_setDualTolerance(model_.get(), 1e-11);
}

void BinaryProgram::relax(const Node& node) {
  std::fill(low_.begin(), low_.end(), 0);
  std::fill(high_.begin(), high_.end(), 1);
  for (const auto& [i, is_in] : node.fixed) (is_in ? low_ : high_)[i] = is_in;
  std::copy(low_.begin(), low_.end(), Clp_columnLower(model_.get()));
  std::copy(high_.begin(), high_.end(), Clp_columnUpper(model_.get()));
  if (deadline_.is_limited()) Clp_setMaximumSeconds(model_.get(), deadline_.seconds_left());
  if (node.fixed.empty() && is_begun_)
    Clp_primal(model_.get(), 0);  // from the last optimum
  else if (node.fixed.empty())
    Clp_initialSolve(model_.get());
  else
    Clp_dual(model_.get(), 0);
}

/// For any y, x costs y·(rows' sums) and what the costs exceed y's part by. The first is least
/// where every row is at its low limit if its y is positive, at its high limit if negative; an
/// infinite limit asks for y = 0 there. Of the second, x takes what its limits let it.
double BinaryProgram::bound(const std::vector<double>& costs) const {
  const double* given = Clp_dualRowSolution(model_.get());
  std::vector<double> duals(given, given + rows_.low.size());
  double sum = 0, size = 0;
  for (std::size_t row = 0; row < duals.size(); ++row) {
    const double limit = duals[row] > 0 ? rows_.low[row] : rows_.high[row];
    if (!std::isfinite(limit)) duals[row] = 0;
    if (duals[row] == 0) continue;
    sum += limit * duals[row];
    size += std::fabs(limit * duals[row]);
  }
  double least = 0, below = 0, above = 0;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    double reduced = costs[i], magnitude = std::fabs(costs[i]);
    for (std::size_t e = rows_.first[i]; e < rows_.first[i + 1]; ++e) {
      const double part = rows_.factor[e] * duals[std::size_t(rows_.row[e])];
      reduced -= part;
      magnitude += std::fabs(part);
    }
    const double roundings = 2 + 2 * double(rows_.first[i + 1] - rows_.first[i]);
    reduced -= roundings * 0x1p-53 * magnitude;
    if (reduced > 0) {
      above += reduced * low_[i];
    } else {
      below += reduced * high_[i];
      if (high_[i] > 0) least = std::min(least, reduced);
    }
  }
  below = std::max(below, double(most_ones_) * least);
  const double terms = double(rows_.low.size() + costs.size());
  return sum + below + above - terms * 0x1p-52 * (size - below + above);
}

Index BinaryProgram::largest_fraction() const {
  const double* x = Clp_getColSolution(model_.get());
  Index largest = kNone;
  for (Index i = 0; i < low_.size(); ++i)
    if (x[i] > 1e-6 && x[i] < 1 - 1e-6 && (largest == kNone || x[i] > x[largest])) largest = i;
  return largest;
}

bool BinaryProgram::is_solution(const std::vector<Index>& ones) const {
  std::vector<double> sums(rows_.low.size(), 0);
  for (const Index i : ones)
    for (std::size_t e = rows_.first[i]; e < rows_.first[i + 1]; ++e)
      sums[std::size_t(rows_.row[e])] += rows_.factor[e];
  for (std::size_t row = 0; row < sums.size(); ++row)
    if (sums[row] < rows_.low[row] || sums[row] > rows_.high[row]) return false;
  return ones.size() <= most_ones_;
}

std::vector<Index> BinaryProgram::rounded() const {
  const double* x = Clp_getColSolution(model_.get());
  std::vector<Index> ones;
  for (Index i = 0; i < low_.size(); ++i)
    if (x[i] > 0.5) ones.push_back(i);
  if (!is_solution(ones)) ones.clear();
  return ones;
}

/// Best first, but each time down to a solution: a variable that is mostly in is taken in, and the
/// case without it is left for later.
BinaryProgram::Solution BinaryProgram::minimize(const std::vector<double>& costs, double enough,
                                                double too_much) {
  load(costs);
  Solution best{{}, 0, {}, {}};
  double cost = kInfinite;
  double settled = cost;  // no solution in the parts that are left alone costs less
  std::priority_queue<Node> open;
  open.push({-cost, 0, {}});
  std::size_t nodes = 0;
  const auto is_over = [&] {
    return open.empty() || open.top().bound >= cost - enough ||
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
      std::vector<Index> ones = rounded();
      const double sum = ones.empty() ? cost : cost_of(ones, costs);
      if (sum < cost) {
        cost = sum;
        best.ones = std::move(ones);
      }
      const Index i = nodes < most_programs_ && !deadline_.passed() ? largest_fraction() : kNone;
      if (node.bound >= cost - enough || i == kNone) {
        settled = std::min(settled, node.bound);
        break;
      }
      Node without = node;
      without.number = nodes;
      without.fixed.emplace_back(i, false);
      open.push(std::move(without));
      node.fixed.emplace_back(i, true);
    }
  }
  best.bound = std::min(cost, settled);
  if (!open.empty()) best.bound = std::min(best.bound, open.top().bound);
  const double* x = Clp_getColSolution(model_.get());
  best.values.assign(x, x + costs.size());
  const double* reduced = Clp_getReducedCost(model_.get());
  best.reduced_costs.assign(reduced, reduced + costs.size());
  return best;
}

}  // namespace hodt
