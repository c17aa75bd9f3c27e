#include "hodt/optimize/solve/choices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "hodt/optimize/rounded_sum.h"
#include "hodt/optimize/solve/choice_parts.h"

namespace hodt {

Choices::Choices(const Aggregator& aggregator, Index count)
    : aggregator_(aggregator),
      singles_(count, {aggregator.identity(), aggregator.identity()}),
      lost_(aggregator.is_sum() ? count : 0, {0, 0}) {}

void Choices::add(Index i, const SingleCosts& costs) {
  for (const bool x : kBoth) {
    const double before = singles_[i][x];
    const double sum = singles_[i][x] = aggregator_.combine(before, costs[x]);
    if (!aggregator_.is_sum()) continue;
    const double lost = lost_in_sum(before, costs[x], sum), lost_before = lost_[i][x];
    const double all = lost_[i][x] = lost_before + lost;
    const double rest = lost_in_sum(lost_before, lost, all);
    if (rest != 0) rests_.push_back({i, x, rest});
  }
}

void Choices::add(std::span<const ChoicePair> pairs) {
  pairs_.insert(pairs_.end(), pairs.begin(), pairs.end());
}

namespace {

/// Where messages leave a gap: the best of the choices that are not settled. What is settled is so
/// in all that could be better.
PartChoices best_of_open(const ChoiceGraph& graph, std::span<const Index> part,
                         const PartChoices& known, const Deadline& deadline) {
  const Aggregator& c = graph.aggregator();
  std::vector<Index> open, number(part.size(), kNone);
  std::vector<bool> chosen_before;  // of the open ones
  for (Index i = 0; i < part.size(); ++i) {
    if (known.settled[i]) continue;
    number[i] = static_cast<Index>(open.size());
    open.push_back(i);
    chosen_before.push_back(known.chosen[i]);
  }
  Choices rest(c, static_cast<Index>(open.size()));
  std::vector<ChoicePair> pairs;
  Total settled_cost(c);
  for (Index i = 0; i < part.size(); ++i) {
    const bool x = known.chosen[i];
    if (number[i] == kNone)
      settled_cost.add(graph.single(part[i])[x]);
    else
      rest.add(number[i], graph.single(part[i]));
    for (const ChoiceGraph::Link& link : graph.links(part[i])) {
      const ChoicePair& pair = graph.pair(link.pair);
      const Index j = place_in(part, link.to);
      const bool y = known.chosen[j];
      if (number[i] != kNone && number[j] == kNone)
        rest.add(number[i], {pair.cost(part[i], false, y), pair.cost(part[i], true, y)});
      else if (number[i] == kNone && number[j] == kNone && i < j)
        settled_cost.add(pair.cost(part[i], x, y));
      else if (number[i] != kNone && i < j)
        pairs.push_back({number[i],
                         number[j],
                         {{{pair.cost(part[i], false, false), pair.cost(part[i], false, true)},
                           {pair.cost(part[i], true, false), pair.cost(part[i], true, true)}}}});
    }
  }
  rest.add(pairs);
  const Choices::Result found = rest.best(deadline);
  PartChoices result = known;
  const bool is_better = c.better(rest.value(found.chosen), rest.value(chosen_before));
  for (std::size_t n = 0; n < open.size() && is_better; ++n)
    result.chosen[open[n]] = found.chosen[n];
  settled_cost.add(found.bound);
  const double bound = settled_cost.bound();
  if (c.better(known.bound, bound)) result.bound = bound;  // the tighter one
  return result;
}

PartChoices best_of(const ChoiceGraph& graph, std::span<const Index> part,
                    const Deadline& deadline) {
  if (graph.aggregator().objective().aggregate != Aggregate::sum)
    return choose_by_limits(graph, part, deadline);
  const PartChoices best = choose_by_messages(graph, part, deadline);
  if (best.is_best || deadline.passed()) return best;
  const auto settled = std::count(best.settled.begin(), best.settled.end(), true);
  if (static_cast<std::size_t>(settled) > part.size() / 16)
    return best_of_open(graph, part, best, deadline);
  if (std::optional<PartChoices> exact = choose_by_tables(graph, part, deadline))
    return *std::move(exact);
  return best;
}

}  // namespace

Total Choices::total(const std::vector<bool>& chosen) const {
  Total total(aggregator_);
  std::array<double, 256> costs;
  std::size_t size = 0;
  const auto add_up = [&] { total.add({costs.data(), std::exchange(size, 0)}); };
  const auto add = [&](double cost) {
    if (size == costs.size()) add_up();
    costs[size++] = cost;
  };
  for (std::size_t i = 0; i < singles_.size(); ++i) add(singles_[i][chosen[i]]);
  for (const auto& [i, j, pair] : pairs_) add(pair[chosen[i]][chosen[j]]);
  add_up();
  // Far smaller than the rest.
  for (std::size_t i = 0; i < lost_.size(); ++i) add(lost_[i][chosen[i]]);
  for (const auto& [i, x, cost] : rests_)
    if (chosen[i] == x) add(cost);
  add_up();
  return total;
}

/// No exact sum of single costs is better.
std::vector<SingleCosts> Choices::outward_singles() const {
  std::vector<SingleCosts> singles = singles_;
  const double sign = aggregator_.sign();
  for (std::size_t i = 0; i < lost_.size(); ++i)
    for (const bool x : kBoth)
      singles[i][x] = combine_outward(aggregator_, singles[i][x], lost_[i][x]);
  for (const Rest& rest : rests_)
    singles[rest.choice][rest.chosen] = outward(singles[rest.choice][rest.chosen], sign);
  return singles;
}

Choices::Result Choices::best(const Deadline& deadline) const {
  ChoiceGraph graph(aggregator_, outward_singles(), pairs_);
  Result result{std::vector<bool>(graph.size(), false), graph.eliminate_simple()};
  for (const std::vector<Index>& part : graph.parts()) {
    const PartChoices best = best_of(graph, part, deadline);
    for (std::size_t i = 0; i < part.size(); ++i) result.chosen[part[i]] = best.chosen[i];
    result.bound.add(best.bound);
  }
  graph.decide_eliminated(result.chosen);
  return result;
}

}  // namespace hodt
