#include "hodt/optimize/solve/ordered_choices.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

#include "hodt/base/parallel.h"
#include "hodt/geometry/wide_integer.h"
#include "hodt/optimize/solve/choice_parts.h"

namespace hodt {

namespace {

constexpr std::size_t kLevels = OrderedChoices::kMostLevels + 1;  // with how much is forbidden
using exact::Int128;
using exact::UInt128;

constexpr std::size_t kMostChoices = 4096;  // of a part; those of scattered points are far smaller
constexpr Int128 kLargest = Int128(~UInt128(0) >> 1);

/// How much is forbidden, then the levels.
using Cost = std::array<Int128, kLevels>;

/// The position of the last bit of a double that is not 0, as a power of two.
int last_bit(double value) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  const auto bits = static_cast<std::int64_t>(std::ldexp(fraction, 53));
  return exponent - 53 + std::countr_zero(static_cast<std::uint64_t>(bits));
}

/// Doubles as whole multiples of a power of two, so that their sums are exact.
class Scale {
 public:
  void cover(double value) {
    if (value == 0) return;
    last_bit_ = std::min(last_bit_, last_bit(value));
    sum_ += std::fabs(value);
  }
  /// Whether all sums of what was covered fit.
  bool fits() const { return sum_ == 0 || std::ilogb(sum_) + 1 - last_bit_ < 124; }
  /// REQUIRES a value that was covered, and fits().
  Int128 scaled(double value) const {
    if (value == 0) return 0;
    int exponent = 0;
    const double fraction = std::frexp(value, &exponent);
    const Int128 bits = static_cast<std::int64_t>(std::ldexp(fraction, 53));
    const int shift = exponent - 53 - last_bit_;
    return shift >= 0 ? bits * (Int128(1) << shift) : bits / (Int128(1) << -shift);
  }

 private:
  int last_bit_ = std::numeric_limits<int>::max();
  double sum_ = 0;
};

/// A whole number that compares as the double does.
Int128 rank_of(double value) {
  const auto bits = std::bit_cast<std::int64_t>(std::fabs(value));
  return value < 0 ? -Int128(bits) : Int128(bits);
}

}  // namespace

OrderedChoices::OrderedChoices(Index count, std::size_t levels, Combine last)
    : count_(count), levels_(levels), last_(last) {}

void OrderedChoices::add(std::size_t level, std::span<const Index> choices,
                         std::span<const double> costs) {
  terms_.push_back({level, choices_.size(), choices.size(), costs_.size()});
  choices_.insert(choices_.end(), choices.begin(), choices.end());
  costs_.insert(costs_.end(), costs.begin(), costs.end());
}

void OrderedChoices::forbid(std::span<const Index> choices, std::size_t setting) {
  terms_.push_back({kForbidden, choices_.size(), choices.size(), setting});
  choices_.insert(choices_.end(), choices.begin(), choices.end());
}

/// Choices that hang together: solved by eliminating one after the other, each time the one on
/// which the fewest others depend.
class OrderedChoices::Part {
 public:
  Part(const OrderedChoices& all, std::span<const Index> terms) : all_(all) {
    for (const Index t : terms)
      for (const Index choice : all.choices_of(all.terms_[t])) choices_.push_back(choice);
    std::sort(choices_.begin(), choices_.end());
    choices_.erase(std::unique(choices_.begin(), choices_.end()), choices_.end());
    is_solvable_ = choices_.size() <= kMostChoices && set_scales(terms) && add_tables(terms);
  }

  std::span<const Index> choices() const { return choices_; }

  /// One for each of choices(), or none.
  std::vector<bool> solve(const Deadline& deadline) {
    if (!is_solvable_) return {};
    std::set<std::pair<std::size_t, Index>> queue;
    for (Index i = 0; i < choices_.size(); ++i) queue.insert({neighbours_[i].size(), i});
    while (!queue.empty()) {
      const auto [degree, i] = *queue.begin();
      if (degree > kWidest || deadline.passed()) return {};
      queue.erase(queue.begin());
      for (const Index j : neighbours_[i]) queue.erase({neighbours_[j].size(), j});
      const std::vector<Index> others = neighbours_[i];
      eliminate(i);
      for (const Index j : others) queue.insert({neighbours_[j].size(), j});
    }
    std::vector<bool> chosen(choices_.size(), false);
    for (auto d = decisions_.rbegin(); d != decisions_.rend(); ++d)
      chosen[d->choice] = d->best[setting_of(d->others, chosen)];
    return chosen;
  }

 private:
  struct Table {
    std::vector<Index> choices;  // by their places in the part
    std::vector<Cost> costs;
  };
  struct Decision {
    Index choice;
    std::vector<Index> others;
    std::vector<bool> best;  // for each setting of the others
  };

  bool is_sum(std::size_t level) const {
    return level + 1 < all_.levels_ || all_.last_ == Combine::sum;
  }
  std::size_t settings(const Term& term) const { return std::size_t{1} << term.size; }
  bool set_scales(std::span<const Index> terms);
  bool add_tables(std::span<const Index> terms);
  void add_table(Table table);
  Cost zero() const;
  void combine(Cost& cost, const Cost& more) const;
  void eliminate(Index i);
  void join(const std::vector<Index>& choices);
  static std::size_t setting_of(const std::vector<Index>& choices,
                                const std::vector<bool>& chosen) {
    std::size_t setting = 0;
    for (std::size_t j = 0; j < choices.size(); ++j)
      setting |= std::size_t{chosen[choices[j]]} << j;
    return setting;
  }

  const OrderedChoices& all_;
  std::vector<Index> choices_;
  std::array<Scale, kMostLevels> scales_;
  std::vector<Table> tables_;
  std::vector<std::vector<Index>> tables_of_;   // of each choice, those that are left
  std::vector<std::vector<Index>> neighbours_;  // sorted
  std::vector<Decision> decisions_;
  bool is_solvable_;
};

bool OrderedChoices::Part::set_scales(std::span<const Index> terms) {
  for (const Index t : terms) {
    const Term& term = all_.terms_[t];
    if (term.level == kForbidden || !is_sum(term.level) || term.size > kWidest) continue;
    for (std::size_t s = 0; s < settings(term); ++s)
      scales_[term.level].cover(all_.costs_[term.first_cost + s]);
  }
  return std::all_of(scales_.begin(), scales_.end(), [](const Scale& s) { return s.fits(); });
}

bool OrderedChoices::Part::add_tables(std::span<const Index> terms) {
  tables_of_.resize(choices_.size());
  neighbours_.resize(choices_.size());
  for (const Index t : terms) {
    const Term& term = all_.terms_[t];
    if (term.size > kWidest) return false;
    Table table{{}, std::vector<Cost>(settings(term), zero())};
    for (const Index choice : all_.choices_of(term))
      table.choices.push_back(place_in(choices_, choice));
    if (term.level == kForbidden) {
      table.costs[term.first_cost][0] = 1;
    } else {
      for (std::size_t s = 0; s < table.costs.size(); ++s) {
        const double cost = all_.costs_[term.first_cost + s];
        table.costs[s][1 + term.level] =
            is_sum(term.level) ? scales_[term.level].scaled(cost) : rank_of(cost);
      }
    }
    add_table(std::move(table));
  }
  return true;
}

void OrderedChoices::Part::add_table(Table table) {
  for (const Index i : table.choices) tables_of_[i].push_back(static_cast<Index>(tables_.size()));
  join(table.choices);
  tables_.push_back(std::move(table));
}

/// Makes them neighbours.
void OrderedChoices::Part::join(const std::vector<Index>& choices) {
  for (const Index i : choices)
    for (const Index j : choices) {
      if (i == j) continue;
      std::vector<Index>& list = neighbours_[i];
      const auto place = std::lower_bound(list.begin(), list.end(), j);
      if (place == list.end() || *place != j) list.insert(place, j);
    }
}

/// What combining with changes nothing.
Cost OrderedChoices::Part::zero() const {
  Cost cost{};
  if (all_.last_ != Combine::sum)
    cost[all_.levels_] = all_.last_ == Combine::max ? -kLargest : kLargest;
  return cost;
}

void OrderedChoices::Part::combine(Cost& cost, const Cost& more) const {
  const std::size_t last = all_.levels_;
  for (std::size_t level = 0; level < last; ++level) cost[level] += more[level];
  switch (all_.last_) {
    case Combine::sum:
      cost[last] += more[last];
      break;
    case Combine::max:
      cost[last] = std::max(cost[last], more[last]);
      break;
    case Combine::min:
      cost[last] = std::min(cost[last], more[last]);
      break;
  }
}

/// The best that a choice can be, for each setting of those that it depends on, is a table of
/// these.
void OrderedChoices::Part::eliminate(Index i) {
  const std::vector<Index> others = std::exchange(neighbours_[i], {});
  const std::vector<Index> tables = std::exchange(tables_of_[i], {});
  // For each table where its choices are: among the others, or i behind them.
  std::vector<std::vector<std::size_t>> places;
  for (const Index t : tables) {
    auto& of_table = places.emplace_back();
    for (const Index j : tables_[t].choices)
      of_table.push_back(j == i ? others.size() : std::size_t{place_in(others, j)});
  }
  const auto cost_of = [&](std::size_t setting) {
    Cost cost = zero();
    for (std::size_t k = 0; k < tables.size(); ++k) {
      std::size_t in_table = 0;
      for (std::size_t j = 0; j < places[k].size(); ++j)
        in_table |= ((setting >> places[k][j]) & 1) << j;
      combine(cost, tables_[tables[k]].costs[in_table]);
    }
    return cost;
  };
  const std::size_t settings = std::size_t{1} << others.size();
  Table result{others, std::vector<Cost>(settings)};
  Decision decision{i, others, std::vector<bool>(settings)};
  for (std::size_t setting = 0; setting < settings; ++setting) {
    const Cost without = cost_of(setting), with = cost_of(setting | settings);
    decision.best[setting] = with < without;
    result.costs[setting] = std::min(with, without);
  }
  decisions_.push_back(std::move(decision));
  for (const Index t : tables) {
    for (const Index j : tables_[t].choices)
      if (j != i) std::erase(tables_of_[j], t);
    tables_[t] = {};
  }
  for (const Index j : others) std::erase(neighbours_[j], i);
  if (!others.empty()) add_table(std::move(result));
}

std::vector<std::vector<Index>> OrderedChoices::terms_by_parts() const {
  std::vector<Index> parent(count_);
  std::iota(parent.begin(), parent.end(), Index{0});
  const auto root = [&](Index v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const Term& term : terms_)
    for (const Index choice : choices_of(term)) {
      const Index a = root(choice), b = root(choices_[term.first_choice]);
      parent[std::max(a, b)] = std::min(a, b);
    }
  std::vector<Index> part(count_, kNone);
  std::vector<std::vector<Index>> terms;
  for (Index t = 0; t < terms_.size(); ++t) {
    Index& number = part[root(choices_[terms_[t].first_choice])];
    if (number == kNone) {
      number = static_cast<Index>(terms.size());
      terms.emplace_back();
    }
    terms[number].push_back(t);
  }
  return terms;
}

OrderedChoices::Result OrderedChoices::best(const Deadline& deadline) const {
  const std::vector<std::vector<Index>> parts = terms_by_parts();
  // Of every choice: whether it is chosen, and whether solved. (Bits of a vector are no places for
  // several threads.)
  std::vector<std::uint8_t> chosen(count_, 0), solved(count_, 1);
  parallel_for(0, parts.size(), 16, [&](std::size_t first, std::size_t last) {
    for (std::size_t p = first; p < last; ++p) {
      Part part(*this, parts[p]);
      const std::vector<bool> found = part.solve(deadline);
      for (std::size_t i = 0; i < part.choices().size(); ++i) {
        chosen[part.choices()[i]] = !found.empty() && found[i];
        solved[part.choices()[i]] = !found.empty();
      }
    }
  });
  return {{chosen.begin(), chosen.end()}, {solved.begin(), solved.end()}};
}

}  // namespace hodt
