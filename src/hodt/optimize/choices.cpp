#include "hodt/optimize/choices.h"

#include <optional>
#include <utility>

#include "hodt/optimize/choice_parts.h"

namespace hodt {

Choices::Choices(const Combination& combination, Index count)
    : combination_(combination), singles_(count, {combination.neutral(), combination.neutral()}) {}

void Choices::add(Index i, const SingleCosts& costs) {
  for (Index x = 0; x < 2; ++x) singles_[i][x] = combination_.combine(singles_[i][x], costs[x]);
}

void Choices::add(Index i, Index j, const std::array<SingleCosts, 2>& costs) {
  pairs_.push_back({i, j, costs});
}

namespace {

PartChoices best_of(const ChoiceGraph& graph, std::span<const Index> part) {
  if (graph.combination().objective().aggregate != Aggregate::sum)
    return choose_by_limits(graph, part);
  PartChoices best = choose_by_messages(graph, part);
  if (best.is_best) return best;
  if (std::optional<PartChoices> exact = choose_by_tables(graph, part)) return *std::move(exact);
  return best;
}

}  // namespace

double Choices::value(const std::vector<bool>& chosen) const {
  double value = combination_.neutral();
  for (std::size_t i = 0; i < singles_.size(); ++i)
    value = combination_.combine(value, singles_[i][chosen[i]]);
  for (const auto& [i, j, costs] : pairs_)
    value = combination_.combine(value, costs[chosen[i]][chosen[j]]);
  return value;
}

Choices::Result Choices::best() const {
  ChoiceGraph graph(combination_, singles_, pairs_);
  Result result{std::vector<bool>(graph.size(), false), graph.eliminate_simple()};
  for (const std::vector<Index>& part : graph.parts()) {
    const PartChoices best = best_of(graph, part);
    for (std::size_t i = 0; i < part.size(); ++i) result.chosen[part[i]] = best.chosen[i];
    result.bound = combination_.combine(result.bound, best.bound);
  }
  graph.decide_eliminated(result.chosen);
  return result;
}

}  // namespace hodt
