// Linear programs whose variables lie between 0 and 1, solved by Clp, with proven bounds.
// Tested by tests/optimize/binary_program_test.cpp.
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
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

  static constexpr double kInfinite = std::numeric_limits<double>::infinity();

  std::size_t columns() const { return first.size() - 1; }
};

/// A set of rows, for one vector of costs after another. The bound is evaluated anew from dual
/// values, with a bound on rounding, so it does not depend on what the solver believes.
class LinearRelaxation {
 public:
  /// `most_ones`: no solution in zeros and ones that counts has more ones.
  LinearRelaxation(BinaryRows rows, std::size_t most_ones, const Deadline& deadline);

  /// Costs are to be at most about 1 in size.
  void set_costs(const std::vector<double>& costs);
  /// Solves with some variables fixed at 0 or 1. What it leaves is near the optimum, or wherever
  /// the deadline found the solver.
  void solve(const std::vector<std::pair<Index, bool>>& fixed);

  // Of the last program solved:

  /// No solution in zeros and ones costs less; infinite if it is proven that there is none.
  double bound() const;
  std::vector<double> values() const;
  /// What the variables cost more than the rows are worth, about.
  std::vector<double> reduced_costs() const;
  /// The largest variable that is neither fixed nor 0 nor 1, or kNone.
  Index largest_fraction() const;
  /// The variables rounded, if that meets all rows: those that are 1. Otherwise none.
  std::vector<Index> rounded() const;

 private:
  double bound(const std::vector<double>& costs, const double* duals) const;
  bool is_proven_infeasible() const;
  bool is_solution(const std::vector<Index>& ones) const;

  const BinaryRows rows_;
  const std::size_t most_ones_;
  const Deadline& deadline_;
  std::unique_ptr<void, void (*)(void*)> model_;  // of Clp
  std::vector<double> costs_;
  std::vector<double> low_, high_;  // of the variables
  bool is_begun_ = false;
};

}  // namespace hodt
