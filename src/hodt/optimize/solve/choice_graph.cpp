#include "hodt/optimize/solve/choice_graph.h"

#include <algorithm>
#include <utility>

#include "hodt/optimize/rounded_sum.h"

namespace hodt {

void ChoicePair::add(const Aggregator& aggregator, Index from,
                     const std::array<SingleCosts, 2>& more) {
  for (const bool x : kBoth)
    for (const bool y : kBoth) {
      double& cost = from == i ? costs[x][y] : costs[y][x];
      cost = combine_outward(aggregator, cost, more[x][y]);
    }
}

ChoiceGraph::ChoiceGraph(const Aggregator& aggregator, std::vector<SingleCosts> singles,
                         std::vector<ChoicePair> pairs)
    : aggregator_(aggregator),
      singles_(std::move(singles)),
      pairs_(std::move(pairs)),
      first_(singles_.size() + 1, 0),
      degree_(singles_.size(), 0) {
  for (const ChoicePair& pair : pairs_) ++first_[pair.i + 1], ++first_[pair.j + 1];
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  links_.resize(first_.back());
  for (Index p = 0; p < pairs_.size(); ++p) {
    const auto& [i, j, costs] = pairs_[p];
    const std::size_t known = find_link(i, j);
    if (known < first_[i] + degree_[i]) {
      pairs_[links_[known].pair].add(aggregator_, i, costs);
      continue;
    }
    links_[first_[i] + degree_[i]++] = {j, p};
    links_[first_[j] + degree_[j]++] = {i, p};
  }
}

/// Where i's link to another choice is, or the end of its links.
std::size_t ChoiceGraph::find_link(Index i, Index to) const {
  std::size_t at = first_[i];
  while (at < first_[i] + degree_[i] && links_[at].to != to) ++at;
  return at;
}

void ChoiceGraph::unlink(Index i, Index from) {
  links_[find_link(i, from)] = links_[first_[i] + --degree_[i]];
}

/// j and k, which were linked by i, get these costs [j][k] in its place.
void ChoiceGraph::join(Index j, Index k, Index i, const std::array<SingleCosts, 2>& costs) {
  const std::size_t known = find_link(j, k);
  if (known == first_[j] + degree_[j]) {
    links_[find_link(j, i)] = {k, static_cast<Index>(pairs_.size())};
    links_[find_link(k, i)] = {j, static_cast<Index>(pairs_.size())};
    pairs_.push_back({j, k, costs});
    return;
  }
  pairs_[links_[known].pair].add(aggregator_, j, costs);
  unlink(j, i);
  unlink(k, i);
}

/// What i costs if nothing depends on it, else nothing.
std::optional<double> ChoiceGraph::eliminate(Index i) {
  const Aggregator& c = aggregator_;
  const std::span<const Link> others = links(i);
  Decision decision{i, kNone, kNone, {}};
  const auto best = [&](std::size_t setting, double without, double with) {
    decision.best[setting] = c.better(with, without);
    return decision.best[setting] ? with : without;
  };
  const auto sum = [&](double x, double y) { return combine_outward(c, x, y); };
  const auto [without, with] = singles_[i];
  std::optional<double> decided;
  if (others.empty()) {
    decided = best(0, without, with);
  } else if (others.size() == 1) {
    const Index j = decision.j = others[0].to;
    for (const bool x : kBoth) {
      const double value = best(x, sum(without, cost(i, false, others[0], x)),
                                sum(with, cost(i, true, others[0], x)));
      singles_[j][x] = sum(singles_[j][x], value);
    }
    unlink(j, i);
  } else {
    const Index j = decision.j = others[0].to, k = decision.k = others[1].to;
    std::array<SingleCosts, 2> costs{};
    for (const bool x : kBoth)
      for (const bool y : kBoth) {
        const auto cost_if = [&](bool chosen, double single) {
          return sum(single, sum(cost(i, chosen, others[0], x), cost(i, chosen, others[1], y)));
        };
        costs[x][y] = best(x + 2 * y, cost_if(false, without), cost_if(true, with));
      }
    join(j, k, i, costs);
  }
  degree_[i] = kEliminated;
  decisions_.push_back(decision);
  return decided;
}

Total ChoiceGraph::eliminate_simple() {
  Total decided(aggregator_);
  std::vector<Index> simple;
  for (Index seed = 0; seed < size(); ++seed) {
    simple.assign(1, seed);
    while (!simple.empty()) {
      const Index i = simple.back();
      simple.pop_back();
      if (is_eliminated(i) || degree_[i] > 2) continue;
      for (const Link& link : links(i)) simple.push_back(link.to);
      if (const std::optional<double> cost = eliminate(i)) decided.add(*cost);
    }
  }
  return decided;
}

void ChoiceGraph::decide_eliminated(std::vector<bool>& chosen) const {
  for (auto d = decisions_.rbegin(); d != decisions_.rend(); ++d) {
    const bool x = d->j != kNone && chosen[d->j], y = d->k != kNone && chosen[d->k];
    chosen[d->i] = d->best[x + 2 * y];
  }
}

std::vector<std::vector<Index>> ChoiceGraph::parts() const {
  std::vector<std::vector<Index>> parts;
  std::vector<bool> seen(size(), false);
  for (Index seed = 0; seed < size(); ++seed) {
    if (seen[seed] || is_eliminated(seed)) continue;
    std::vector<Index> part{seed};
    seen[seed] = true;
    for (std::size_t next = 0; next < part.size(); ++next)
      for (const Link& link : links(part[next])) {
        if (seen[link.to]) continue;
        seen[link.to] = true;
        part.push_back(link.to);
      }
    std::sort(part.begin(), part.end());
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace hodt
