// Programs in zeros and ones, by linear relaxation and branching.
#pragma once

#include <cstddef>
#include <vector>

#include "hodt/base/deadline.h"
#include "hodt/optimize/solve/linear_relaxation.h"

namespace hodt {

/// A set of rows, for one vector of costs after another. Mostly the optimum of the relaxation is in
/// zeros and ones already; if not, the search branches.
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
  static constexpr double kInfinite = BinaryRows::kInfinite;

  /// REQUIRES that all zeros are no solution. The cheapest solution, or one whose cost is less than
  /// `enough` above the bound; or, as soon as it is certain that all cost more than `too_much`, any
  /// or none. Costs are to be at most about 1 in size.
  Solution minimize(const std::vector<double>& costs, double enough, double too_much = kInfinite);

  bool is_out_of_time() const { return deadline_.passed(); }

 private:
  LinearRelaxation relaxation_;
  const Deadline& deadline_;
  const std::size_t most_programs_;
};

}  // namespace hodt
