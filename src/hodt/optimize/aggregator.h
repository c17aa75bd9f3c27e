// How values combine into an objective's value, and which of two is better.
// Tested by tests/optimize/optimize_measure_test.cpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <span>

#include "hodt/base/exact_sum.h"
#include "hodt/optimize/objective.h"

namespace hodt {

class Aggregator {
 public:
  explicit Aggregator(const Objective& objective) : objective_(objective) {}

  /// The sum, the larger or the smaller one.
  double combine(double x, double y) const {
    switch (objective_.aggregate) {
      case Aggregate::sum:
        return x + y;
      case Aggregate::max:
        return x > y ? x : y;
      case Aggregate::min:
        return x < y ? x : y;
    }
    return x;
  }
  /// Of many values.
  double combine(std::span<const double> values) const {
    // Four at a time, as each has to wait for the one before.
    double a = identity(), b = a, c = a, d = a;
    std::size_t i = 0;
    for (; i + 4 <= values.size(); i += 4) {
      a = combine(a, values[i]);
      b = combine(b, values[i + 1]);
      c = combine(c, values[i + 2]);
      d = combine(d, values[i + 3]);
    }
    for (; i < values.size(); ++i) a = combine(a, values[i]);
    return combine(combine(a, b), combine(c, d));
  }
  /// What combining with changes nothing.
  double identity() const {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return objective_.aggregate == Aggregate::sum   ? 0
           : objective_.aggregate == Aggregate::max ? -kInfinity
                                                    : kInfinity;
  }
  /// What nothing is worse than.
  double worst() const {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return objective_.direction == Direction::minimize ? kInfinity : -kInfinity;
  }
  bool is_sum() const { return objective_.aggregate == Aggregate::sum; }
  bool better(double x, double y) const {
    return objective_.direction == Direction::minimize ? x < y : x > y;
  }
  /// 1 to minimize and -1 to maximize: times it, less is better.
  double sign() const { return objective_.direction == Direction::minimize ? 1 : -1; }
  /// Whether the worst of all values counts (the largest to minimize, the smallest to maximize).
  bool worst_counts() const {
    return objective_.aggregate ==
           (objective_.direction == Direction::minimize ? Aggregate::max : Aggregate::min);
  }
  const Objective& objective() const { return objective_; }

  /// For largest and smallest values: what a single value adds to the cost of all those that do not
  /// decide. Close to the lexicographic order, as the worst weigh by far the most; between 0 and 1
  /// for a value that is no worse than `worst`, and never above 16.
  double secondary_cost(double value, double worst) const {
    const bool is_smaller_better = objective_.direction == Direction::minimize;
    const double ratio = is_smaller_better ? value / worst : worst / value;
    const double bounded = ratio < 2 ? ratio : ratio >= 2 ? 2.0 : 1.0;  // 1: 0 / 0
    return bounded * bounded * bounded * bounded;
  }

 private:
  Objective objective_;
};

/// What rounding can have made of equal sums of a few values, as a share of what was added up.
inline constexpr double kRoundingOfSums = 1e-13;

/// For largest and smallest values: whether as many others are lexicographically better once both
/// are sorted, the value that counts most first. Sorts them.
inline bool is_better_sorted(const Aggregator& aggregator, std::span<double> before,
                             std::span<double> after) {
  const bool is_largest = aggregator.objective().aggregate == Aggregate::max;
  for (const std::span<double> values : {before, after}) {
    if (is_largest)
      std::sort(values.begin(), values.end(), std::greater<>());
    else
      std::sort(values.begin(), values.end());
  }
  const auto [x, y] = std::mismatch(after.begin(), after.end(), before.begin());
  return x != after.end() && aggregator.better(*x, *y);
}

/// What many values combine to; of sums, without rounding.
class Total {
 public:
  explicit Total(const Aggregator& aggregator)
      : aggregator_(aggregator), extreme_(aggregator.identity()) {}

  void add(double value) {
    if (aggregator_.is_sum())
      sum_.add(value);
    else
      extreme_ = aggregator_.combine(extreme_, value);
  }
  void add(std::span<const double> values) {
    if (aggregator_.is_sum())
      sum_.add(values);
    else
      extreme_ = aggregator_.combine(extreme_, aggregator_.combine(values));
  }
  void add(const Total& other) {
    sum_.add(other.sum_);
    extreme_ = aggregator_.combine(extreme_, other.extreme_);
  }

  /// Rounded to the nearest double: better totals have better values, or equal ones.
  double value() const { return aggregator_.is_sum() ? sum_.nearest() : extreme_; }
  /// Rounded so that no total like this is better.
  double bound() const {
    if (!aggregator_.is_sum()) return extreme_;
    return aggregator_.sign() > 0 ? sum_.down() : sum_.up();
  }
  /// Only of sums.
  ExactSum& sum() { return sum_; }

 private:
  Aggregator aggregator_;
  ExactSum sum_;
  double extreme_;
};

}  // namespace hodt
