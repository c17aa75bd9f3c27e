// Tested by tests/optimize/choices_test.cpp.

#include <algorithm>
#include <set>
#include <utility>

#include "hodt/optimize/rounded_sum.h"
#include "hodt/optimize/solve/choice_parts.h"

namespace hodt {

namespace {

constexpr std::size_t kMostWidth = 14;
constexpr std::size_t kMostSettings = 1 << 20;  // of all tables together

/// Eliminates the choice with the fewest neighbours, again and again. Its best value for every
/// setting of its neighbours is a table over them, which joins them. Choices by their places.
class Tables {
 public:
  Tables(const ChoiceGraph& graph, std::span<const Index> part);
  bool eliminate_all(const Deadline& deadline);
  PartChoices result() const;

 private:
  struct Table {
    Index choice;                // eliminated
    std::vector<Index> scope;    // its neighbours then, ascending: bit b of a setting is scope[b]
    std::vector<double> values;  // by setting
    std::vector<bool> best;      // what the choice is best, by setting
  };
  struct Place {
    std::set<Index> neighbours;
    std::vector<Index> tables;  // that have it in their scope
    bool is_done = false;
  };
  bool eliminate(Index i);
  double value(Index i, bool chosen, const std::vector<Index>& scope, std::size_t setting) const;

  const ChoiceGraph& graph_;
  const std::span<const Index> part_;
  std::vector<Place> places_;
  std::vector<Table> tables_;
  double value_;
  std::size_t settings_ = 0;
};

Tables::Tables(const ChoiceGraph& graph, std::span<const Index> part)
    : graph_(graph), part_(part), places_(part.size()), value_(graph.aggregator().identity()) {
  for (Index i = 0; i < part.size(); ++i)
    for (const ChoiceGraph::Link& link : graph.links(part[i]))
      places_[i].neighbours.insert(place_in(part_, link.to));
}

bool Tables::eliminate_all(const Deadline& deadline) {
  std::set<std::pair<std::size_t, Index>> queue;
  for (Index i = 0; i < places_.size(); ++i) queue.emplace(places_[i].neighbours.size(), i);
  while (!queue.empty()) {
    const Index i = queue.begin()->second;
    queue.erase(queue.begin());
    const std::set<Index> around = places_[i].neighbours;
    for (const Index j : around) queue.erase({places_[j].neighbours.size(), j});
    if (deadline.passed() || !eliminate(i)) return false;
    for (const Index j : around) queue.emplace(places_[j].neighbours.size(), j);
  }
  return true;
}

double Tables::value(Index i, bool chosen, const std::vector<Index>& scope,
                     std::size_t setting) const {
  const auto is_set = [&](Index j) {
    if (j == i) return chosen;
    const auto at = std::lower_bound(scope.begin(), scope.end(), j) - scope.begin();
    return (setting >> at & 1) != 0;
  };
  double value = graph_.single(part_[i])[chosen];
  for (const ChoiceGraph::Link& link : graph_.links(part_[i])) {
    const Index j = place_in(part_, link.to);
    if (places_[j].is_done) continue;  // in a table
    value = combine_outward(graph_.aggregator(), value,
                            graph_.pair(link.pair).cost(part_[i], chosen, is_set(j)));
  }
  for (const Index t : places_[i].tables) {
    const Table& table = tables_[t];
    std::size_t own = 0;
    for (std::size_t b = 0; b < table.scope.size(); ++b)
      own |= std::size_t(is_set(table.scope[b])) << b;
    value = combine_outward(graph_.aggregator(), value, table.values[own]);
  }
  return value;
}

bool Tables::eliminate(Index i) {
  const Aggregator& c = graph_.aggregator();
  const std::set<Index>& around = places_[i].neighbours;
  settings_ += std::size_t(1) << around.size();
  if (around.size() > kMostWidth || settings_ > kMostSettings) return false;
  Table table{i, {around.begin(), around.end()}, {}, {}};
  const std::size_t settings = std::size_t(1) << table.scope.size();
  for (std::size_t setting = 0; setting < settings; ++setting) {
    const double without = value(i, false, table.scope, setting);
    const double with = value(i, true, table.scope, setting);
    const bool is_with_better = c.better(with, without);
    table.values.push_back(is_with_better ? with : without);
    table.best.push_back(is_with_better);
  }
  places_[i].is_done = true;
  // Its tables are in the new one now.
  for (const Index t : places_[i].tables)
    for (const Index j : tables_[t].scope)
      if (j != i) std::erase(places_[j].tables, t);
  const auto at = static_cast<Index>(tables_.size());
  for (const Index j : table.scope) {
    places_[j].neighbours.erase(i);
    for (const Index k : table.scope)
      if (k != j) places_[j].neighbours.insert(k);
    places_[j].tables.push_back(at);
  }
  if (table.scope.empty()) value_ = combine_outward(graph_.aggregator(), value_, table.values[0]);
  tables_.push_back(std::move(table));
  return true;
}

PartChoices Tables::result() const {
  std::vector<bool> chosen(places_.size(), false);
  for (auto table = tables_.rbegin(); table != tables_.rend(); ++table) {
    std::size_t setting = 0;
    for (std::size_t b = 0; b < table->scope.size(); ++b)
      setting |= std::size_t(chosen[table->scope[b]]) << b;
    chosen[table->choice] = table->best[setting];
  }
  return {std::move(chosen), value_, true};
}

}  // namespace

std::optional<PartChoices> choose_by_tables(const ChoiceGraph& graph, std::span<const Index> part,
                                            const Deadline& deadline) {
  // The time that it takes to note who is whose neighbour.
  constexpr double kSecondsAChoice = 5e-6;
  if (deadline.is_limited() && deadline.seconds_left() < kSecondsAChoice * double(part.size()))
    return std::nullopt;
  Tables tables(graph, part);
  if (!tables.eliminate_all(deadline)) return std::nullopt;
  return tables.result();
}

}  // namespace hodt
