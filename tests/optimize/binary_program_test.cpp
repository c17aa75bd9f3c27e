#include "hodt/optimize/solve/binary_program.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "families.h"
#include <gtest/gtest.h>

namespace hodt {
namespace {

/// Rows with small factors, mostly met by some zeros and ones.
struct Program {
  BinaryRows rows;
  std::vector<double> costs;

  bool is_solution(std::uint32_t ones) const {
    std::vector<double> sums(rows.low.size(), 0);
    for (std::size_t i = 0; i < rows.columns(); ++i)
      if (ones >> i & 1)
        for (std::size_t e = rows.first[i]; e < rows.first[i + 1]; ++e)
          sums[std::size_t(rows.row[e])] += rows.factor[e];
    for (std::size_t r = 0; r < sums.size(); ++r)
      if (sums[r] < rows.low[r] || sums[r] > rows.high[r]) return false;
    return true;
  }
  /// Infinite if there is no solution with at most so many ones.
  double optimum(std::size_t most_ones) const {
    double best = BinaryProgram::kInfinite;
    for (std::uint32_t ones = 0; ones < 1u << rows.columns(); ++ones) {
      if (std::size_t(std::popcount(ones)) > most_ones || !is_solution(ones)) continue;
      double sum = 0;
      for (std::size_t i = 0; i < costs.size(); ++i)
        if (ones >> i & 1) sum += costs[i];
      best = std::min(best, sum);
    }
    return best;
  }
};

Program random_program(families::Random& random) {
  Program program;
  const int columns = random.integer(2, 9), rows = random.integer(1, 6);
  for (int i = 0; i < columns; ++i) {
    for (int r = 0; r < rows; ++r) {
      if (random.integer(0, 2) == 0) continue;
      program.rows.row.push_back(r);
      program.rows.factor.push_back(random.integer(0, 3) ? 1 : -1);
    }
    program.rows.first.push_back(program.rows.row.size());
    program.costs.push_back(random.real(-1, 1));
  }
  for (int r = 0; r < rows; ++r) {
    const int low = random.integer(-2, 1);
    program.rows.low.push_back(random.integer(0, 3) ? low : -BinaryProgram::kInfinite);
    program.rows.high.push_back(random.integer(0, 3) ? low + random.integer(0, 2)
                                                     : BinaryProgram::kInfinite);
  }
  return program;
}

TEST(BinaryProgram, finds_the_best_of_all) {
  families::Random random(1);
  int solved = 0;
  for (int round = 0; round < 2000; ++round) {
    const Program program = random_program(random);
    const std::size_t columns = program.costs.size();
    const Deadline never;
    BinaryProgram solver(program.rows, columns, never, 1000);
    const BinaryProgram::Solution best = solver.minimize(program.costs, 0);
    const double optimum = program.optimum(columns);
    ASSERT_LE(best.bound, optimum) << round;
    if (program.is_solution(0)) continue;
    ASSERT_EQ(best.ones.empty(), optimum == BinaryProgram::kInfinite) << round;
    if (best.ones.empty()) continue;
    ++solved;
    std::uint32_t ones = 0;
    double sum = 0;
    for (const Index i : best.ones) {
      ones |= 1u << i;
      sum += program.costs[i];
    }
    ASSERT_TRUE(program.is_solution(ones)) << round;
    ASSERT_NEAR(sum, optimum, 1e-9) << round;
  }
  EXPECT_GT(solved, 500);
}

TEST(BinaryProgram, costs_one_after_another) {
  families::Random random(2);
  for (int round = 0; round < 300; ++round) {
    Program program = random_program(random);
    const Deadline never;
    BinaryProgram solver(program.rows, program.costs.size(), never, 1000);
    for (int again = 0; again < 3; ++again) {
      for (double& cost : program.costs) cost = random.real(-1, 1);
      ASSERT_LE(solver.minimize(program.costs, 0).bound, program.optimum(program.costs.size()));
    }
  }
}

TEST(BinaryProgram, a_search_that_ends_early_has_a_valid_bound) {
  families::Random random(3);
  for (int round = 0; round < 500; ++round) {
    const Program program = random_program(random);
    const Deadline never, passed(1e-9);
    for (const Deadline* deadline : {&never, &passed}) {
      BinaryProgram solver(program.rows, program.costs.size(), *deadline, 1);
      ASSERT_LE(solver.minimize(program.costs, 0).bound, program.optimum(program.costs.size()));
    }
  }
}

}  // namespace
}  // namespace hodt
