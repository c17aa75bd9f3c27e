#include "hodt/optimize/choices.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace hodt {

Choices::Choices(const Combination& combination, Index count)
    : combination_(combination),
      singles_(count, {combination.neutral(), combination.neutral()}),
      pairs_of_(count) {}

void Choices::add(Index i, const std::array<double, 2>& values) {
  for (Index x = 0; x < 2; ++x) singles_[i][x] = combination_.combine(singles_[i][x], values[x]);
}

void Choices::add(Index i, Index j, const std::array<std::array<double, 2>, 2>& values) {
  pairs_of_[i].push_back(static_cast<Index>(pairs_.size()));
  pairs_of_[j].push_back(static_cast<Index>(pairs_.size()));
  pairs_.push_back({i, j, values});
}

/// Eliminates the choice with the fewest neighbours, again and again, of one part after another.
/// Its best value for every setting of its neighbours is a table over them, which joins them.
class Choices::Elimination {
 public:
  explicit Elimination(const Choices& choices)
      : choices_(choices),
        place_(choices.singles_.size(), kNone),
        tables_of_(choices.singles_.size()),
        done_(choices.singles_.size(), false) {}

  /// The best value of the part; false if a table would be too large.
  bool run(const std::vector<Index>& part, double& value);
  /// The choices that lead to it.
  void read_off(std::vector<bool>& chosen) const;

 private:
  struct Table {
    Index choice;                // eliminated
    std::vector<Index> scope;    // its neighbours then, ascending: bit b of a setting is scope[b]
    std::vector<double> values;  // by setting
    std::vector<bool> best;      // what the choice is best, by setting
  };
  bool eliminate(Index i);
  double value(Index i, bool chosen, const std::vector<Index>& scope, std::size_t setting) const;

  const Choices& choices_;
  std::vector<std::set<Index>> neighbours_;
  std::vector<Index> place_;  // of a choice among neighbours_
  std::vector<Table> tables_;
  std::vector<std::vector<Index>> tables_of_;  // that have a choice in their scope
  std::vector<bool> done_;
  double result_ = 0;
};

bool Choices::Elimination::run(const std::vector<Index>& part, double& value) {
  const Combination& c = choices_.combination_;
  neighbours_.assign(part.size(), {});
  tables_.clear();
  for (Index p = 0; p < part.size(); ++p) place_[part[p]] = p;
  for (const Index i : part)
    for (const Index pair : choices_.pairs_of_[i]) {
      const Pair& both = choices_.pairs_[pair];
      neighbours_[place_[i]].insert(both.i == i ? both.j : both.i);
    }
  result_ = c.neutral();
  std::set<std::pair<std::size_t, Index>> queue;
  for (const Index i : part) queue.emplace(neighbours_[place_[i]].size(), i);
  while (!queue.empty()) {
    const Index i = queue.begin()->second;
    queue.erase(queue.begin());
    const std::set<Index> around = neighbours_[place_[i]];
    for (const Index j : around) queue.erase({neighbours_[place_[j]].size(), j});
    if (!eliminate(i)) return false;
    for (const Index j : around) queue.emplace(neighbours_[place_[j]].size(), j);
  }
  value = result_;
  return true;
}

double Choices::Elimination::value(Index i, bool chosen, const std::vector<Index>& scope,
                                   std::size_t setting) const {
  const Combination& c = choices_.combination_;
  const auto is_set = [&](Index j) {
    if (j == i) return chosen;
    const auto at = std::lower_bound(scope.begin(), scope.end(), j) - scope.begin();
    return (setting >> at & 1) != 0;
  };
  double value = choices_.singles_[i][chosen];
  for (const Index p : choices_.pairs_of_[i]) {
    const Pair& pair = choices_.pairs_[p];
    if (done_[pair.i == i ? pair.j : pair.i]) continue;  // in a table
    value = c.combine(value, pair.values[is_set(pair.i)][is_set(pair.j)]);
  }
  for (const Index t : tables_of_[i]) {
    const Table& table = tables_[t];
    std::size_t own = 0;
    for (std::size_t b = 0; b < table.scope.size(); ++b)
      own |= std::size_t(is_set(table.scope[b])) << b;
    value = c.combine(value, table.values[own]);
  }
  return value;
}

bool Choices::Elimination::eliminate(Index i) {
  const Combination& c = choices_.combination_;
  const std::set<Index>& around = neighbours_[place_[i]];
  if (around.size() > kMostWidth) return false;
  Table table{i, {around.begin(), around.end()}, {}, {}};
  const std::size_t settings = std::size_t(1) << table.scope.size();
  for (std::size_t setting = 0; setting < settings; ++setting) {
    const double without = value(i, false, table.scope, setting);
    const double with = value(i, true, table.scope, setting);
    const bool is_with_better = c.better(with, without);
    table.values.push_back(is_with_better ? with : without);
    table.best.push_back(is_with_better);
  }
  done_[i] = true;
  // Its tables are in the new one now.
  for (const Index t : tables_of_[i])
    for (const Index j : tables_[t].scope)
      if (j != i) std::erase(tables_of_[j], t);
  const auto at = static_cast<Index>(tables_.size());
  for (const Index j : table.scope) {
    neighbours_[place_[j]].erase(i);
    for (const Index k : table.scope)
      if (k != j) neighbours_[place_[j]].insert(k);
    tables_of_[j].push_back(at);
  }
  if (table.scope.empty()) result_ = c.combine(result_, table.values[0]);
  tables_.push_back(std::move(table));
  return true;
}

void Choices::Elimination::read_off(std::vector<bool>& chosen) const {
  for (auto table = tables_.rbegin(); table != tables_.rend(); ++table) {
    std::size_t setting = 0;
    for (std::size_t b = 0; b < table->scope.size(); ++b)
      setting |= std::size_t(chosen[table->scope[b]]) << b;
    chosen[table->choice] = table->best[setting];
  }
}

/// All that depends on choice i.
double Choices::value_at(Index i, const std::vector<bool>& chosen) const {
  double value = singles_[i][chosen[i]];
  for (const Index p : pairs_of_[i]) {
    const Pair& pair = pairs_[p];
    value = combination_.combine(value, pair.values[chosen[pair.i]][chosen[pair.j]]);
  }
  return value;
}

void Choices::improve(const std::vector<Index>& part, std::vector<bool>& chosen) const {
  for (bool changed = true; changed;) {
    changed = false;
    for (const Index i : part) {
      const double before = value_at(i, chosen);
      chosen[i] = !chosen[i];
      const double after = value_at(i, chosen);
      // What rounding can have made of equal values is no gain.
      if (combination_.better(after, before) &&
          std::fabs(after - before) > 1e-12 * std::fabs(before))
        changed = true;
      else
        chosen[i] = !chosen[i];
    }
  }
}

double Choices::loose_bound(const std::vector<Index>& part) const {
  const auto best = [&](double x, double y) { return combination_.better(x, y) ? x : y; };
  double bound = combination_.neutral();
  for (const Index i : part) {
    bound = combination_.combine(bound, best(singles_[i][0], singles_[i][1]));
    for (const Index p : pairs_of_[i]) {
      const auto& [first, second, values] = pairs_[p];
      if (first != i) continue;
      bound = combination_.combine(
          bound, best(best(values[0][0], values[0][1]), best(values[1][0], values[1][1])));
    }
  }
  return bound;
}

Choices::Result Choices::best() const {
  Result result{std::vector<bool>(singles_.size(), false), combination_.neutral()};
  std::vector<bool> seen(singles_.size(), false);
  Elimination elimination(*this);
  for (Index seed = 0; seed < singles_.size(); ++seed) {
    if (seen[seed]) continue;
    std::vector<Index> part{seed};
    seen[seed] = true;
    for (std::size_t next = 0; next < part.size(); ++next)
      for (const Index p : pairs_of_[part[next]])
        for (const Index j : {pairs_[p].i, pairs_[p].j})
          if (!seen[j]) {
            seen[j] = true;
            part.push_back(j);
          }
    double value = 0;
    if (elimination.run(part, value)) {
      elimination.read_off(result.chosen);
    } else {
      improve(part, result.chosen);
      value = loose_bound(part);
    }
    result.bound = combination_.combine(result.bound, value);
  }
  return result;
}

}  // namespace hodt
