// Tested by tests/optimize/choices_test.cpp.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "hodt/optimize/solve/choice_parts.h"

namespace hodt {

namespace {

/// Every pair lends each of its two choices an amount for 0 and one for 1, its message. Whatever
/// these are, the costs as they are now (with what was borrowed, less what was lent) add up to the
/// same for all choices together, so the least that each can be bounds the sum. A pass goes through
/// the choices in order, and back: each takes back what its pairs can do without, and shares what
/// it has among the pairs that lead on. The bound never falls.
class Messages {
 public:
  Messages(const ChoiceGraph& graph, std::span<const Index> part, const Deadline& deadline);

  /// Passes until no more is gained or the deadline, and the best choices on the way.
  PartChoices run();

 private:
  struct Pair {
    Index i, j;  // places, i < j
    std::array<SingleCosts, 2> costs;
    std::array<SingleCosts, 2> lent;  // to i, to j

    SingleCosts& lent_to(Index place) { return lent[place == i ? 0 : 1]; }
    const SingleCosts& lent_to(Index place) const { return lent[place == i ? 0 : 1]; }
    double left(bool x, bool y) const { return costs[x][y] - lent[0][x] - lent[1][y]; }
    /// The least that is left for each x of one of the two.
    SingleCosts least(Index place) const {
      SingleCosts least;
      for (const bool x : kBoth)
        least[x] = place == i ? std::min(left(x, false), left(x, true))
                              : std::min(left(false, x), left(true, x));
      return least;
    }
  };
  struct Node {
    SingleCosts cost;
    std::size_t first, middle, last;  // its pairs in pairs_of_; from the middle on with later ones
  };

  void pass(bool forward);
  void take_back(Pair& pair, Index place, SingleCosts& own) const;
  SingleCosts now(Index place) const;
  double bound() const;
  double value(const std::vector<bool>& chosen) const;
  std::vector<bool> rounded() const;
  bool is_settled(Index place, bool chosen, double gap) const;
  void improve(std::vector<bool>& chosen) const;
  double change(Index place, const std::vector<bool>& chosen) const;

  const Deadline deadline_;
  double sign_;
  std::vector<Node> nodes_;
  std::vector<Pair> pairs_;
  std::vector<Index> pairs_of_;
};

Messages::Messages(const ChoiceGraph& graph, std::span<const Index> part, const Deadline& deadline)
    : deadline_(deadline), sign_(graph.aggregator().sign()) {
  std::vector<std::vector<Index>> earlier(part.size()), later(part.size());
  for (Index i = 0; i < part.size(); ++i)
    for (const ChoiceGraph::Link& link : graph.links(part[i])) {
      const Index j = place_in(part, link.to);
      if (j < i) continue;
      Pair pair{i, j, {}, {}};
      for (const bool x : kBoth)
        for (const bool y : kBoth)
          pair.costs[x][y] = sign_ * graph.pair(link.pair).cost(part[i], x, y);
      later[i].push_back(static_cast<Index>(pairs_.size()));
      earlier[j].push_back(static_cast<Index>(pairs_.size()));
      pairs_.push_back(pair);
    }
  for (Index i = 0; i < part.size(); ++i) {
    const auto [without, with] = graph.single(part[i]);
    Node node{{sign_ * without, sign_ * with}, pairs_of_.size(), 0, 0};
    pairs_of_.insert(pairs_of_.end(), earlier[i].begin(), earlier[i].end());
    node.middle = pairs_of_.size();
    pairs_of_.insert(pairs_of_.end(), later[i].begin(), later[i].end());
    node.last = pairs_of_.size();
    nodes_.push_back(node);
  }
}

SingleCosts Messages::now(Index place) const {
  const Node& node = nodes_[place];
  SingleCosts cost = node.cost;
  for (std::size_t p = node.first; p < node.last; ++p) {
    const Pair& pair = pairs_[pairs_of_[p]];
    for (const bool x : kBoth) cost[x] += pair.lent_to(place)[x];
  }
  return cost;
}

/// The least that the pair costs for each x is lent to the choice.
void Messages::take_back(Pair& pair, Index place, SingleCosts& own) const {
  const SingleCosts least = pair.least(place);
  for (const bool x : kBoth) {
    pair.lent_to(place)[x] += least[x];
    own[x] += least[x];
  }
}

void Messages::pass(bool forward) {
  const auto count = static_cast<Index>(nodes_.size());
  for (Index n = 0; n < count; ++n) {
    const Index i = forward ? n : count - 1 - n;
    if (n % 1024 == 0 && deadline_.passed()) return;  // the bound holds between any two choices
    const Node& node = nodes_[i];
    SingleCosts own = now(i);
    for (std::size_t p = node.first; p < node.last; ++p) take_back(pairs_[pairs_of_[p]], i, own);
    const std::size_t back = node.middle - node.first, ahead = node.last - node.middle;
    const double share = 1 / static_cast<double>(std::max(back, ahead));
    const std::size_t begin = forward ? node.middle : node.first;
    const std::size_t end = forward ? node.last : node.middle;
    for (std::size_t p = begin; p < end; ++p)
      for (const bool x : kBoth) pairs_[pairs_of_[p]].lent_to(i)[x] -= share * own[x];
  }
}

double Messages::bound() const {
  ExactSum bound;
  double size = 0;  // of what is added up to the terms of the bound
  std::size_t most_pairs = 0;
  const auto add = [&](double least) {
    bound.add(least);
    size += std::fabs(least);
  };
  for (Index i = 0; i < nodes_.size(); ++i) {
    const SingleCosts cost = now(i);
    most_pairs = std::max(most_pairs, nodes_[i].last - nodes_[i].first);
    add(std::min(cost[0], cost[1]));
    for (const bool x : kBoth) size += std::fabs(nodes_[i].cost[x]);
  }
  for (const Pair& pair : pairs_) {
    add(std::min(std::min(pair.left(false, false), pair.left(false, true)),
                 std::min(pair.left(true, false), pair.left(true, true))));
    for (const SingleCosts& lent : pair.lent) size += 2 * (std::fabs(lent[0]) + std::fabs(lent[1]));
    for (const SingleCosts& costs : pair.costs) size += std::fabs(costs[0]) + std::fabs(costs[1]);
  }
  // Each term is a sum of so few, each rounding of which is 2^-53 of what is added up at most.
  bound.subtract(double(most_pairs + 4) * 0x1p-52 * size);
  return bound.down();
}

double Messages::value(const std::vector<bool>& chosen) const {
  ExactSum value;
  for (Index i = 0; i < nodes_.size(); ++i) value.add(nodes_[i].cost[chosen[i]]);
  for (const Pair& pair : pairs_) value.add(pair.costs[chosen[pair.i]][chosen[pair.j]]);
  return value.nearest();
}

/// In order, what is best with the choices made and the messages of the pairs that lead on.
std::vector<bool> Messages::rounded() const {
  std::vector<bool> chosen(nodes_.size(), false);
  for (Index i = 0; i < nodes_.size(); ++i) {
    const Node& node = nodes_[i];
    SingleCosts cost = node.cost;
    for (std::size_t p = node.first; p < node.last; ++p) {
      const Pair& pair = pairs_[pairs_of_[p]];
      for (const bool x : kBoth)
        cost[x] += p < node.middle ? pair.costs[chosen[pair.i]][x] : pair.lent[0][x];
    }
    chosen[i] = cost[1] < cost[0];
  }
  return chosen;
}

/// Whether with the other choice, what it and its pairs cost as they are now is more than the least
/// they can by more than the gap: then nothing with it is better than what there is.
bool Messages::is_settled(Index place, bool chosen, double gap) const {
  const Node& node = nodes_[place];
  const SingleCosts own = now(place);
  double least = std::min(own[0], own[1]), other = own[!chosen];
  double size = std::fabs(own[0]) + std::fabs(own[1]);
  for (std::size_t p = node.first; p < node.last; ++p) {
    const Pair& pair = pairs_[pairs_of_[p]];
    const SingleCosts costs = pair.least(place);
    least += std::min(costs[0], costs[1]);
    other += costs[!chosen];
    size += std::fabs(costs[0]) + std::fabs(costs[1]);
  }
  return other - least > gap + 1e-12 * size;
}

/// What the other choice would add.
double Messages::change(Index place, const std::vector<bool>& chosen) const {
  const Node& node = nodes_[place];
  const bool x = chosen[place];
  double change = node.cost[!x] - node.cost[x];
  for (std::size_t p = node.first; p < node.last; ++p) {
    const Pair& pair = pairs_[pairs_of_[p]];
    change += place == pair.i ? pair.costs[!x][chosen[pair.j]] - pair.costs[x][chosen[pair.j]]
                              : pair.costs[chosen[pair.i]][!x] - pair.costs[chosen[pair.i]][x];
  }
  return change;
}

void Messages::improve(std::vector<bool>& chosen) const {
  for (bool changed = true; changed && !deadline_.passed();) {
    changed = false;
    for (Index i = 0; i < nodes_.size(); ++i) {
      // What rounding can have made of nothing is no gain.
      const double size = std::fabs(nodes_[i].cost[0]) + std::fabs(nodes_[i].cost[1]);
      if (change(i, chosen) >= -1e-12 * size) continue;
      chosen[i] = !chosen[i];
      changed = true;
    }
  }
}

PartChoices Messages::run() {
  constexpr int kMostPasses = 2000;
  std::vector<bool> best(nodes_.size(), false);
  improve(best);
  double best_value = value(best), best_bound = -std::numeric_limits<double>::infinity();
  bool is_met = false;
  for (int n = 1; n <= kMostPasses && !is_met; ++n) {
    pass(true);
    pass(false);
    const bool is_over = deadline_.passed();
    if (n % 10 != 0 && !is_over) continue;
    std::vector<bool> chosen = rounded();
    improve(chosen);
    if (const double v = value(chosen); v < best_value) {
      best_value = v;
      best = std::move(chosen);
    }
    const double before = std::exchange(best_bound, std::max(best_bound, bound()));
    const double size = std::fabs(best_value) + std::fabs(best_bound);
    is_met = best_value - best_bound <= 1e-10 * size;
    if (is_over || best_bound - before <= 1e-3 * (best_value - best_bound)) break;
  }
  PartChoices result{std::move(best), sign_ * std::min(best_bound, best_value), is_met};
  if (is_met || deadline_.passed()) return result;
  const double gap = best_value - bound();
  for (Index i = 0; i < nodes_.size(); ++i)
    result.settled.push_back(is_settled(i, result.chosen[i], gap));
  return result;
}

}  // namespace

PartChoices choose_by_messages(const ChoiceGraph& graph, std::span<const Index> part,
                               const Deadline& deadline) {
  return Messages(graph, part, deadline).run();
}

}  // namespace hodt
