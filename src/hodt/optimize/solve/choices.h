// Many choices between two, whose costs depend on pairs of them.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "hodt/base/deadline.h"
#include "hodt/base/ids.h"
#include "hodt/optimize/aggregator.h"
#include "hodt/optimize/solve/choice_graph.h"

namespace hodt {

/// Costs of single choices and of pairs: what all of them combine to is to be best.
class Choices {
 public:
  Choices(const Aggregator& aggregator, Index count);

  /// Adds to what choice i costs if it is 0 or 1.
  void add(Index i, const SingleCosts& costs);
  /// Adds to what two choices cost together. REQUIRES that they are not the same.
  void add(std::span<const ChoicePair> pairs);

  /// What such choices cost.
  Total total(const std::vector<bool>& chosen) const;
  double value(const std::vector<bool>& chosen) const { return total(chosen).value(); }

  struct Result {
    std::vector<bool> chosen;
    /// No choices combine to a better total.
    Total bound;
  };
  /// Exact, but for sums in parts that are far from trees (lattices): there the bound tells.
  /// With the deadline the messages of such a part end; the bound stays valid.
  Result best(const Deadline& deadline = {}) const;

 private:
  std::vector<SingleCosts> outward_singles() const;

  Aggregator aggregator_;
  std::vector<SingleCosts> singles_;
  std::vector<ChoicePair> pairs_;
  // By sums: what rounding took from the single costs, and if that was rounded, the rest.
  std::vector<SingleCosts> lost_;
  struct Rest {
    Index choice;
    bool chosen;
    double cost;
  };
  std::vector<Rest> rests_;
};

}  // namespace hodt
