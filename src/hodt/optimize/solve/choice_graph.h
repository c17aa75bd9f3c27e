// Choices between two whose costs depend on pairs of them, as a graph, and what of it can be
// decided one choice at a time.
// Tested by tests/optimize/choices_test.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "hodt/base/ids.h"
#include "hodt/optimize/aggregator.h"

namespace hodt {

inline constexpr std::array<bool, 2> kBoth{false, true};

/// What a choice costs if it is 0 or 1.
using SingleCosts = std::array<double, 2>;

/// What two choices cost together, [i][j].
struct ChoicePair {
  Index i, j;
  std::array<SingleCosts, 2> costs;

  double cost(Index from, bool chosen, bool other_chosen) const {
    return from == i ? costs[chosen][other_chosen] : costs[other_chosen][chosen];
  }
  /// Combines these costs, [from][other], with its own; sums are rounded outward.
  void add(const Aggregator& aggregator, Index from, const std::array<SingleCosts, 2>& more);
};

class ChoiceGraph {
 public:
  struct Link {
    Index to, pair;
  };

  /// Several pairs of the same two choices become one.
  ChoiceGraph(const Aggregator& aggregator, std::vector<SingleCosts> singles,
              std::vector<ChoicePair> pairs);

  std::size_t size() const { return singles_.size(); }
  const Aggregator& aggregator() const { return aggregator_; }
  const SingleCosts& single(Index i) const { return singles_[i]; }
  const ChoicePair& pair(Index p) const { return pairs_[p]; }
  /// The pairs that the choice is in, with choices not yet eliminated.
  std::span<const Link> links(Index i) const { return {links_.data() + first_[i], degree_[i]}; }
  bool is_eliminated(Index i) const { return degree_[i] == kEliminated; }

  /// The choices not yet eliminated, in parts that do not depend on each other.
  std::vector<std::vector<Index>> parts() const;

  /// Eliminates choices that depend on at most two others, as long as there are any: the best that
  /// such a choice can be, for each setting of the others, is a cost of these. Returns what the
  /// choices cost that came to depend on nothing. Sums are rounded outward, so that what is best is
  /// a bound on the exact sums.
  Total eliminate_simple();
  /// Decides the eliminated choices, best for what is chosen of the others.
  void decide_eliminated(std::vector<bool>& chosen) const;

 private:
  static constexpr Index kEliminated = kNone;
  struct Decision {
    Index i, j, k;             // eliminated, and what it depends on, or kNone
    std::array<bool, 4> best;  // for j + 2 k
  };

  std::optional<double> eliminate(Index i);
  double cost(Index i, bool chosen, const Link& link, bool other) const {
    return pairs_[link.pair].cost(i, chosen, other);
  }
  std::size_t find_link(Index i, Index to) const;
  void unlink(Index i, Index from);
  void join(Index j, Index k, Index i, const std::array<SingleCosts, 2>& costs);

  Aggregator aggregator_;
  std::vector<SingleCosts> singles_;
  std::vector<ChoicePair> pairs_;
  std::vector<std::size_t> first_;  // of each choice's links
  std::vector<Index> degree_;       // how many are left
  std::vector<Link> links_;
  std::vector<Decision> decisions_;
};

}  // namespace hodt
