// Choices that depend on pairs of them, against all there are.
#include "hodt/optimize/solve/choices.h"

#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "hodt/optimize/solve/choice_parts.h"

namespace hodt {
namespace {

struct Instance {
  Index count = 0;
  std::vector<std::array<double, 2>> singles;
  struct Pair {
    Index i, j;
    double costs[2][2];
  };
  std::vector<Pair> pairs;
};

const Objective kObjectives[] = {
    {Direction::minimize, Aggregate::sum, EdgeMeasure::jnd},
    {Direction::maximize, Aggregate::sum, EdgeMeasure::jnd},
    {Direction::minimize, Aggregate::max, EdgeMeasure::jnd},
    {Direction::maximize, Aggregate::max, EdgeMeasure::jnd},
    {Direction::minimize, Aggregate::min, EdgeMeasure::jnd},
    {Direction::maximize, Aggregate::min, EdgeMeasure::jnd},
};

/// With costs of few values there are many ties.
Instance random_instance(Index count, double density, bool few_values, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0, 10);
  const auto cost = [&] {
    const double c = uniform(random);
    return few_values ? std::floor(c / 3) : c;
  };
  Instance instance;
  instance.count = count;
  for (Index i = 0; i < count; ++i) instance.singles.push_back({cost(), cost()});
  for (Index i = 0; i < count; ++i)
    for (Index j = 0; j < count; ++j)
      if (i != j && uniform(random) < 10 * density / 2)  // sometimes both i j and j i
        instance.pairs.push_back({i, j, {{cost(), cost()}, {cost(), cost()}}});
  return instance;
}

Instance grid(Index side, std::mt19937& random) {
  Instance instance = random_instance(side * side, 0, false, random);
  std::uniform_real_distribution<double> uniform(0, 10);
  for (Index i = 0; i < side * side; ++i)
    for (const Index j : {i + 1, i + side})
      if (j < side * side && (j == i + side || j % side != 0))
        instance.pairs.push_back(
            {i, j, {{uniform(random), uniform(random)}, {uniform(random), uniform(random)}}});
  return instance;
}

double value_of(const Instance& instance, const Objective& objective,
                const std::vector<bool>& chosen) {
  std::vector<double> costs;
  for (Index i = 0; i < instance.count; ++i) costs.push_back(instance.singles[i][chosen[i]]);
  for (const auto& pair : instance.pairs)
    costs.push_back(pair.costs[chosen[pair.i]][chosen[pair.j]]);
  if (objective.aggregate == Aggregate::max) return *std::max_element(costs.begin(), costs.end());
  if (objective.aggregate == Aggregate::min) return *std::min_element(costs.begin(), costs.end());
  double sum = 0;
  for (const double c : costs) sum += c;
  return sum;
}

double optimum_of(const Instance& instance, const Objective& objective) {
  double best = 0;
  for (std::uint32_t bits = 0; bits < 1u << instance.count; ++bits) {
    std::vector<bool> chosen;
    for (Index i = 0; i < instance.count; ++i) chosen.push_back(bits >> i & 1);
    const double value = value_of(instance, objective, chosen);
    if (bits == 0 || (objective.direction == Direction::minimize ? value < best : value > best))
      best = value;
  }
  return best;
}

Choices choices_of(const Instance& instance, const Objective& objective) {
  Choices choices(Aggregator(objective), instance.count);
  for (Index i = 0; i < instance.count; ++i) choices.add(i, instance.singles[i]);
  for (const auto& [i, j, c] : instance.pairs)
    choices.add(std::array{ChoicePair{i, j, {{{c[0][0], c[0][1]}, {c[1][0], c[1][1]}}}}});
  return choices;
}

ChoiceGraph graph_of(const Instance& instance, const Objective& objective) {
  std::vector<ChoicePair> pairs;
  for (const auto& [i, j, c] : instance.pairs)
    pairs.push_back({i, j, {{{c[0][0], c[0][1]}, {c[1][0], c[1][1]}}}});
  return ChoiceGraph(Aggregator(objective), {instance.singles.begin(), instance.singles.end()},
                     pairs);
}

template <class F>
void for_each_instance(const F& f) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 60; ++trial)
    for (const double density : {0.1, 0.25, 0.6})
      f(random_instance(1 + trial % 10, density, trial % 2 == 0, random));
  for (int trial = 0; trial < 10; ++trial) f(grid(3, random));
}

TEST(Choices, are_the_best_of_all) {
  for_each_instance([&](const Instance& instance) {
    for (const Objective& objective : kObjectives) {
      const Choices choices = choices_of(instance, objective);
      const Choices::Result best = choices.best();
      const double expected = optimum_of(instance, objective);
      EXPECT_NEAR(value_of(instance, objective, best.chosen), expected, 1e-9);
      EXPECT_NEAR(best.bound.value(), expected, 1e-9 * (1 + expected));
      EXPECT_NEAR(choices.value(best.chosen), expected, 1e-9);
    }
  });
}

/// Where no choice is simple enough to be eliminated first.
TEST(Choices, by_tables_are_the_best_of_all) {
  for_each_instance([&](const Instance& instance) {
    for (const Objective& objective : kObjectives) {
      const ChoiceGraph graph = graph_of(instance, objective);
      std::vector<bool> chosen(instance.count);
      double bound = Aggregator(objective).identity();
      for (const auto& part : graph.parts()) {
        const auto best = choose_by_tables(graph, part);
        ASSERT_TRUE(best);
        for (std::size_t i = 0; i < part.size(); ++i) chosen[part[i]] = best->chosen[i];
        bound = graph.aggregator().combine(bound, best->bound);
      }
      const double expected = optimum_of(instance, objective);
      EXPECT_NEAR(value_of(instance, objective, chosen), expected, 1e-9);
      EXPECT_NEAR(bound, expected, 1e-9);
    }
  });
}

TEST(Choices, by_limits_are_the_best_of_all) {
  for_each_instance([&](const Instance& instance) {
    for (const Objective& objective : kObjectives) {
      if (objective.aggregate == Aggregate::sum) continue;
      const ChoiceGraph graph = graph_of(instance, objective);
      std::vector<bool> chosen(instance.count);
      double bound = Aggregator(objective).identity();
      for (const auto& part : graph.parts()) {
        const PartChoices best = choose_by_limits(graph, part);
        for (std::size_t i = 0; i < part.size(); ++i) chosen[part[i]] = best.chosen[i];
        bound = graph.aggregator().combine(bound, best.bound);
      }
      const double expected = optimum_of(instance, objective);
      EXPECT_EQ(value_of(instance, objective, chosen), expected);
      EXPECT_EQ(bound, expected);
    }
  });
}

TEST(Choices, by_messages_are_bounded) {
  std::size_t instances = 0, met = 0, best = 0;
  for_each_instance([&](const Instance& instance) {
    for (const Objective& objective : kObjectives) {
      if (objective.aggregate != Aggregate::sum) continue;
      const ChoiceGraph graph = graph_of(instance, objective);
      std::vector<bool> chosen(instance.count);
      double bound = 0;
      for (const auto& part : graph.parts()) {
        const PartChoices found = choose_by_messages(graph, part, {});
        for (std::size_t i = 0; i < part.size(); ++i) chosen[part[i]] = found.chosen[i];
        bound += found.bound;
      }
      const double expected = optimum_of(instance, objective);
      const double sign = objective.direction == Direction::minimize ? 1 : -1;
      const double value = value_of(instance, objective, chosen);
      EXPECT_LE(sign * bound, sign * expected + 1e-9);
      EXPECT_GE(sign * value, sign * expected - 1e-9);
      ++instances;
      met += std::fabs(bound - value) < 1e-6;
      best += std::fabs(value - expected) < 1e-6;
    }
  });
  // Dense ones of random costs are as hard as can be.
  EXPECT_GT(best, instances * 8 / 10) << instances;
  EXPECT_GT(met, instances / 2) << instances;
}

/// Costs of few values leave gaps between messages and choices, which what is settled closes.
TEST(Choices, of_grids_with_ties_are_the_best_of_all) {
  std::mt19937 random(11);
  std::size_t best = 0, met = 0, asked = 0;
  for (int trial = 0; trial < 20; ++trial) {
    Instance instance = grid(10, random);
    for (auto& single : instance.singles) single = {0, 0};
    for (auto& pair : instance.pairs)
      for (auto& row : pair.costs)
        for (double& cost : row) cost = std::floor(cost / 2);
    for (const Objective& objective : {kObjectives[0], kObjectives[1]}) {
      const ChoiceGraph graph = graph_of(instance, objective);
      const auto exact = choose_by_tables(graph, graph.parts().at(0));
      ASSERT_TRUE(exact);
      const Choices::Result found = choices_of(instance, objective).best();
      const double value = value_of(instance, objective, found.chosen);
      const double sign = objective.direction == Direction::minimize ? 1 : -1;
      EXPECT_GE(sign * value, sign * exact->bound - 1e-9);
      EXPECT_LE(sign * found.bound.bound(), sign * exact->bound + 1e-6);
      best += std::fabs(value - exact->bound) < 1e-6;
      met += std::fabs(value - found.bound.value()) < 1e-6;
      ++asked;
    }
  }
  EXPECT_EQ(best, asked);
  EXPECT_EQ(met, asked);
}

/// Too wide for tables: what is chosen costs what is said, and the bound is close.
TEST(Choices, of_a_large_grid_are_bounded) {
  std::mt19937 random(3);
  const Instance instance = grid(40, random);
  for (const Objective& objective : kObjectives) {
    const Choices choices = choices_of(instance, objective);
    const Choices::Result found = choices.best();
    const double value = value_of(instance, objective, found.chosen);
    EXPECT_NEAR(choices.value(found.chosen), value, 1e-9 * value);
    const double bound = found.bound.value();
    const double gap = objective.direction == Direction::minimize ? value - bound : bound - value;
    EXPECT_GE(gap, -1e-9 * value) << name_of(objective);
    EXPECT_LE(gap, 0.001 * value) << name_of(objective);
  }
}

}  // namespace
}  // namespace hodt
