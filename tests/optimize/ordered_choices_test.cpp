#include "hodt/optimize/solve/ordered_choices.h"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace hodt {
namespace {

using Combine = OrderedChoices::Combine;

struct Term {
  std::size_t level;
  std::vector<Index> choices;
  std::vector<double> costs;
};

/// Costs of a setting of all choices, added up level by level. Small whole numbers: exact.
std::array<double, 3> costs_of(const std::vector<Term>& terms, std::size_t levels, Combine last,
                               const std::vector<bool>& chosen) {
  std::array<double, 3> costs{};
  if (last != Combine::sum) costs[levels - 1] = last == Combine::max ? -1e9 : 1e9;
  for (const Term& term : terms) {
    std::size_t setting = 0;
    for (std::size_t j = 0; j < term.choices.size(); ++j)
      setting |= std::size_t{chosen[term.choices[j]]} << j;
    double& cost = costs[term.level];
    const double more = term.costs[setting];
    if (term.level + 1 < levels || last == Combine::sum)
      cost += more;
    else
      cost = last == Combine::max ? std::max(cost, more) : std::min(cost, more);
  }
  return costs;
}

TEST(OrderedChoices, equal_all_choices) {
  std::mt19937 random(3);
  const auto below = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); };
  for (int round = 0; round < 600; ++round) {
    const auto count = static_cast<Index>(1 + below(9));
    const auto levels = static_cast<std::size_t>(1 + below(3));
    const auto last = static_cast<Combine>(below(3));
    OrderedChoices choices(count, levels, last);
    std::vector<Term> terms;
    for (int t = below(14); t >= 0; --t) {
      Term term{static_cast<std::size_t>(below(static_cast<int>(levels))), {}, {}};
      for (Index i = 0; i < count; ++i)
        if (below(4) == 0 && term.choices.size() < 4) term.choices.push_back(i);
      if (term.choices.empty()) continue;
      std::shuffle(term.choices.begin(), term.choices.end(), random);
      for (std::size_t s = 0; s < std::size_t{1} << term.choices.size(); ++s)
        term.costs.push_back(0.25 * (below(7) - 3));
      choices.add(term.level, term.choices, term.costs);
      terms.push_back(std::move(term));
    }
    const std::vector<Index> forbidden{static_cast<Index>(below(static_cast<int>(count)))};
    const bool is_forbidden_set = below(2) == 1;
    choices.forbid(forbidden, is_forbidden_set ? 1 : 0);
    std::optional<std::array<double, 3>> best;
    for (unsigned all = 0; all < 1u << count; ++all) {
      std::vector<bool> chosen;
      for (Index i = 0; i < count; ++i) chosen.push_back((all >> i) & 1);
      if (chosen[forbidden[0]] == is_forbidden_set) continue;
      const auto costs = costs_of(terms, levels, last, chosen);
      if (!best || costs < *best) best = costs;
    }
    const OrderedChoices::Result found = choices.best();
    EXPECT_TRUE(std::find(found.is_solved.begin(), found.is_solved.end(), false) ==
                found.is_solved.end());
    EXPECT_NE(found.chosen[forbidden[0]], is_forbidden_set);
    EXPECT_EQ(costs_of(terms, levels, last, found.chosen), *best) << round;
  }
}

/// A sum in doubles would take these for equal.
TEST(OrderedChoices, does_not_round) {
  OrderedChoices choices(2, 2, Combine::sum);
  const Index both[] = {0, 1};
  choices.add(0, both, std::array<double, 4>{1e6, 1e6, 1e6, 1e6});
  for (const Index i : both) {
    const Index one[] = {i};
    choices.add(0, one, std::array<double, 2>{1e-12, 0});
    choices.add(1, one, std::array<double, 2>{0, 1});
  }
  const OrderedChoices::Result found = choices.best();
  EXPECT_EQ(found.chosen, std::vector<bool>(2, true));
  EXPECT_EQ(found.is_solved, std::vector<bool>(2, true));
}

TEST(OrderedChoices, says_what_is_not_solved) {
  // All pairs of many, whose tables are too wide; and two that span too much.
  constexpr Index kMany = 20;
  OrderedChoices choices(kMany + 2, 1, Combine::sum);
  for (Index i = 0; i < kMany; ++i)
    for (Index j = 0; j < i; ++j) {
      const Index pair[] = {i, j};
      choices.add(0, pair, std::array<double, 4>{0, 1, 1, 0});
    }
  for (const double cost : {1e200, 1e-200}) {
    const Index one[] = {kMany};
    choices.add(0, one, std::array<double, 2>{cost, 0});
  }
  const OrderedChoices::Result found = choices.best();
  for (Index i = 0; i <= kMany; ++i) EXPECT_FALSE(found.is_solved[i]);
  EXPECT_TRUE(found.is_solved[kMany + 1]);
}

}  // namespace
}  // namespace hodt
