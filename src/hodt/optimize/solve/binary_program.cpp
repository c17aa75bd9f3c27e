#include "hodt/optimize/solve/binary_program.h"

#include <algorithm>
#include <queue>
#include <tuple>
#include <utility>

namespace hodt {

namespace {

double cost_of(const std::vector<Index>& ones, const std::vector<double>& costs) {
  double sum = 0;
  for (const Index i : ones) sum += costs[i];
  return sum;
}

/// Variables that are in or out, on the way to this part of all solutions.
struct Node {
  double bound;
  std::size_t number;  // breaks ties
  std::vector<std::pair<Index, bool>> fixed;
  bool operator<(const Node& other) const {  // the lowest bound comes first
    return std::tuple(bound, number) > std::tuple(other.bound, other.number);
  }
};

}  // namespace

BinaryProgram::BinaryProgram(BinaryRows rows, std::size_t most_ones, const Deadline& deadline,
                             std::size_t most_programs)
    : relaxation_(std::move(rows), most_ones, deadline),
      deadline_(deadline),
      most_programs_(most_programs) {}

/// Best first, but each time down to a solution: a variable that is mostly in is taken in, and the
/// case without it is left for later.
BinaryProgram::Solution BinaryProgram::minimize(const std::vector<double>& costs, double enough,
                                                double too_much) {
  relaxation_.set_costs(costs);
  std::vector<Index> best;
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
      relaxation_.solve(node.fixed);
      node.bound = std::max(node.bound, relaxation_.bound());
      ++nodes;
      std::vector<Index> ones = relaxation_.rounded();
      const double sum = ones.empty() ? cost : cost_of(ones, costs);
      if (sum < cost) {
        cost = sum;
        best = std::move(ones);
      }
      const bool may_go_on = nodes < most_programs_ && !deadline_.passed();
      const Index i = may_go_on ? relaxation_.largest_fraction() : kNone;
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
  double bound = std::min(cost, settled);
  if (!open.empty()) bound = std::min(bound, open.top().bound);
  return {std::move(best), bound, relaxation_.values(), relaxation_.reduced_costs()};
}

}  // namespace hodt
