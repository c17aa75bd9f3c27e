// Programs in zeros and ones, by linear relaxation and branching.
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

#include "hodt/base/deadline.h"
#include "hodt/base/ids.h"

namespace hodt {

/// What is asked of the variables: every row is a sum of some of them, with factors, between two
/// limits. By columns, one a variable.
struct BinaryRows {
  std::vector<std::size_t> first = {0};  ///< entry of each column, and their number at the end
  std::vector<int> row;                  ///< of each entry
  std::vector<double> factor;            ///< of each entry: a small integer
  std::vector<double> low, high;         ///< of each row: integers, or infinite

  std::size_t columns() const { return first.size() - 1; }
};

/// A set of rows, for one vector of costs after another. Mostly the optimum of the relaxation is in
/// zeros and ones already; if not, the search branches. Bounds are evaluated anew from dual values,
/// with a bound on rounding, so they do not depend on what the solver believes.
class BinaryProgram {
 public:
  /// `most_ones`: no solution has more. The search for each vector of costs ends after
  /// `most_programs`, or with the deadline.
  BinaryProgram(BinaryRows rows, std::size_t most_ones, const Deadline& deadline,
                std::size_t most_programs);

  struct Solution {
    std::vector<Index> ones;     ///< of the best solution found; none if none was
    double bound;                ///< no solution costs less
    std::vector<double> values;  ///< of the variables, in the last relaxation
    /// What the variables cost more there than the rows are worth, about.
    std::vector<double> reduced_costs;
  };
  static constexpr double kInfinite = std::numeric_limits<double>::infinity();

  /// The cheapest solution, or one whose cost is less than `enough` above the bound; or, as soon as
  /// it is certain that all cost more than `too_much`, any or none. Costs are to be at most about 1
  /// in size.
  Solution minimize(const std::vector<double>& costs, double enough, double too_much = kInfinite);

 private:
  struct Node;

  void load(const std::vector<double>& costs);
  void relax(const Node& node);
  double bound(const std::vector<double>& costs) const;
  Index largest_fraction() const;
  std::vector<Index> rounded() const;
  bool is_solution(const std::vector<Index>& ones) const;

  const BinaryRows rows_;
  const std::size_t most_ones_;
  const Deadline& deadline_;
  const std::size_t most_programs_;
  std::unique_ptr<void, void (*)(void*)> model_;  // of Clp
  std::vector<double> low_, high_;                // of the variables, where the search is
  bool is_begun_ = false;
};

}  // namespace hodt
