// Many choices between two, whose costs depend on pairs of them.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "hodt/base/ids.h"
#include "hodt/optimize/combination.h"

namespace hodt {

/// Values of single choices and of pairs: what all of them combine to is to be best. Exact by
/// eliminating one choice after another (dynamic programming along a tree decomposition) in every
/// part that is nearly a tree.
class Choices {
 public:
  Choices(const Combination& combination, Index count);

  /// Adds to what choice i costs if it is 0 or 1.
  void add(Index i, const std::array<double, 2>& values);
  /// Adds to what choices i and j cost together, [i][j]. REQUIRES i != j.
  void add(Index i, Index j, const std::array<std::array<double, 2>, 2>& values);

  struct Result {
    std::vector<bool> chosen;
    /// No choices combine to a better value.
    double bound;
  };
  /// Parts that would take tables of more than 2^kMostWidth values are improved from all 0, one by
  /// one, and bounded by the best that every single value can be.
  static constexpr Index kMostWidth = 14;
  Result best() const;

 private:
  struct Pair {
    Index i, j;
    std::array<std::array<double, 2>, 2> values;
  };
  class Elimination;
  void improve(const std::vector<Index>& part, std::vector<bool>& chosen) const;
  double loose_bound(const std::vector<Index>& part) const;
  double value_at(Index i, const std::vector<bool>& chosen) const;

  Combination combination_;
  std::vector<std::array<double, 2>> singles_;
  std::vector<Pair> pairs_;
  std::vector<std::vector<Index>> pairs_of_;
};

}  // namespace hodt
