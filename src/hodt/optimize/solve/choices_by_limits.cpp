// Tested by tests/optimize/choices_test.cpp.

#include <algorithm>
#include <array>

#include "hodt/optimize/solve/choice_parts.h"

namespace hodt {

namespace {

/// Whether all costs can be no worse than a limit. Each cost that is worse excludes a choice or a
/// pair of choices, so that one implies another: what follows from a choice made is decided, and if
/// that leads to a contradiction, so it is from the opposite; if both do, there is no way. (What
/// follows without contradiction never has to be taken back.)
class WithinLimit {
 public:
  WithinLimit(const ChoiceGraph& graph, std::span<const Index> part, double limit)
      : graph_(graph), part_(part), limit_(limit), state_(part.size(), kOpen) {}

  bool is_possible() {
    for (Index i = 0; i < part_.size(); ++i)
      for (const bool x : kBoth)
        if (is_worse(graph_.single(part_[i])[x]) && !follows(i, !x)) return false;
    for (Index i = 0; i < part_.size(); ++i)
      if (state_[i] == kOpen && !follows(i, false) && !follows(i, true)) return false;
    return true;
  }
  std::vector<bool> chosen() const {
    std::vector<bool> chosen;
    for (const State state : state_) chosen.push_back(state == kTrue);
    return chosen;
  }

 private:
  enum State : std::uint8_t { kFalse, kTrue, kOpen };

  bool is_worse(double cost) const { return graph_.aggregator().better(limit_, cost); }

  /// Decides i and all that follows; nothing if that is a contradiction.
  bool follows(Index i, bool x) {
    if (state_[i] != kOpen) return state_[i] == State(x);
    decided_.assign(1, i);
    state_[i] = State(x);
    for (std::size_t next = 0; next < decided_.size(); ++next)
      if (!decide_neighbours(decided_[next])) {
        for (const Index d : decided_) state_[d] = kOpen;
        return false;
      }
    return true;
  }
  bool decide_neighbours(Index i) {
    const bool x = state_[i] == kTrue;
    if (is_worse(graph_.single(part_[i])[x])) return false;
    for (const ChoiceGraph::Link& link : graph_.links(part_[i])) {
      const Index j = place_in(part_, link.to);
      for (const bool y : kBoth) {
        if (!is_worse(graph_.pair(link.pair).cost(part_[i], x, y))) continue;
        if (state_[j] == State(y)) return false;
        if (state_[j] != kOpen) continue;
        state_[j] = State(!y);
        decided_.push_back(j);
      }
    }
    return true;
  }

  const ChoiceGraph& graph_;
  const std::span<const Index> part_;
  const double limit_;
  std::vector<State> state_;
  std::vector<Index> decided_;
};

/// All costs there are, from best to worst, each once.
std::vector<double> costs_best_first(const ChoiceGraph& graph, std::span<const Index> part) {
  std::vector<double> costs;
  for (const Index i : part) {
    for (const bool x : kBoth) costs.push_back(graph.single(i)[x]);
    for (const ChoiceGraph::Link& link : graph.links(i))
      for (const SingleCosts& pair : graph.pair(link.pair).costs)
        costs.insert(costs.end(), pair.begin(), pair.end());
  }
  std::sort(costs.begin(), costs.end(),
            [&](double x, double y) { return graph.aggregator().better(x, y); });
  costs.erase(std::unique(costs.begin(), costs.end()), costs.end());
  return costs;
}

/// The worst cost counts: the least limit that is possible.
PartChoices best_worst(const ChoiceGraph& graph, std::span<const Index> part,
                       const Deadline& deadline) {
  const std::vector<double> limits = costs_best_first(graph, part);
  // Limits before `first` are too low. The worst cost of all is one that anything keeps.
  std::size_t first = 0, last = limits.size() - 1;
  std::vector<bool> chosen(part.size(), false);
  bool is_known = false;  // that `chosen` keeps the last
  const auto try_limit = [&](std::size_t at) {
    WithinLimit within(graph, part, limits[at]);
    if (!within.is_possible()) return false;
    chosen = within.chosen();
    return true;
  };
  while (first < last && !deadline.passed()) {
    const std::size_t middle = first + (last - first) / 2;
    if (try_limit(middle)) {
      last = middle;
      is_known = true;
    } else {
      first = middle + 1;
    }
  }
  if (first == last && !is_known) try_limit(last);
  return {std::move(chosen), limits[first], first == last};
}

/// The best cost counts: anything that has it.
PartChoices best_best(const ChoiceGraph& graph, std::span<const Index> part) {
  const double best = costs_best_first(graph, part).front();
  PartChoices result{std::vector<bool>(part.size(), false), best, true};
  for (Index i = 0; i < part.size(); ++i)
    for (const bool x : kBoth) {
      const auto choose = [&] { result.chosen[i] = x; };
      if (graph.single(part[i])[x] == best) return choose(), result;
      for (const ChoiceGraph::Link& link : graph.links(part[i]))
        for (const bool y : kBoth)
          if (graph.pair(link.pair).cost(part[i], x, y) == best) {
            choose();
            result.chosen[place_in(part, link.to)] = y;
            return result;
          }
    }
  return result;
}

}  // namespace

PartChoices choose_by_limits(const ChoiceGraph& graph, std::span<const Index> part,
                             const Deadline& deadline) {
  return graph.aggregator().worst_counts() ? best_worst(graph, part, deadline)
                                           : best_best(graph, part);
}

}  // namespace hodt
