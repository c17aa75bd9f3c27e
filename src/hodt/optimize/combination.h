// How values combine into an objective's value, and which of two is better.
#pragma once

#include <limits>

#include "hodt/optimize/objective.h"

namespace hodt {

class Combination {
 public:
  explicit Combination(const Objective& objective) : objective_(objective) {}

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
  /// What combining with changes nothing.
  double neutral() const {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return objective_.aggregate == Aggregate::sum   ? 0
           : objective_.aggregate == Aggregate::max ? -kInfinity
                                                    : kInfinity;
  }
  bool better(double x, double y) const {
    return objective_.direction == Direction::minimize ? x < y : x > y;
  }
  const Objective& objective() const { return objective_; }

 private:
  Objective objective_;
};

}  // namespace hodt
