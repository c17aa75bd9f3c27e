// The best of many choices that all depend on each other: one part of a ChoiceGraph.
// Tested by tests/optimize/choices_test.cpp.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "hodt/base/deadline.h"
#include "hodt/optimize/solve/choice_graph.h"

namespace hodt {

/// Choices in a part, by their places in it, and what no choices can better.
struct PartChoices {
  std::vector<bool> chosen;
  double bound;
  bool is_best;  // the bound is met, but for rounding
  /// By messages, otherwise: which of them are so in all choices that are better. Or nothing.
  std::vector<bool> settled = {};
};

/// The place of a choice in a part, which is ascending.
inline Index place_in(std::span<const Index> part, Index choice) {
  return static_cast<Index>(std::lower_bound(part.begin(), part.end(), choice) - part.begin());
}

/// Exact for any objective, by eliminating the choices one after another (dynamic programming along
/// a tree decomposition). Nothing if that would take tables of more than 2^14 costs, or of
/// 2^20 together, or longer than there is time.
std::optional<PartChoices> choose_by_tables(const ChoiceGraph& graph, std::span<const Index> part,
                                            const Deadline& deadline = {});

/// For sums: choices that exchange messages until they agree (sequential reweighted message
/// passing, Kolmogorov 2015), and a bound, which is mostly met. The deadline ends the passes.
PartChoices choose_by_messages(const ChoiceGraph& graph, std::span<const Index> part,
                               const Deadline& deadline);

/// For largest and smallest values, exact: whether all costs can be within a limit is a question
/// for 2-satisfiability. With the deadline the bound is what was proven by then.
PartChoices choose_by_limits(const ChoiceGraph& graph, std::span<const Index> part,
                             const Deadline& deadline = {});

}  // namespace hodt
