#include "hodt/base/exact_sum.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gmpxx.h>
#include <gtest/gtest.h>

#include "hodt/base/lanes.h"

namespace hodt {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

mpq_class exact_sum(const std::vector<double>& values) {
  mpq_class sum = 0;
  for (const double value : values) sum += mpq_class(value);
  return sum;
}

/// Against rational numbers: neighbours of the sum, and the nearer one.
void expect_rounded(const ExactSum& sum, const mpq_class& exact) {
  const double down = sum.down(), up = sum.up(), nearest = sum.nearest();
  ASSERT_TRUE(std::isfinite(down) && std::isfinite(up));
  EXPECT_LE(mpq_class(down), exact);
  EXPECT_GE(mpq_class(up), exact);
  if (mpq_class(down) == exact) {
    EXPECT_EQ(down, up);
  } else {
    EXPECT_EQ(std::nextafter(down, kInfinity), up);
  }
  EXPECT_TRUE(nearest == down || nearest == up);
  const mpq_class below = exact - mpq_class(down), above = mpq_class(up) - exact;
  if (below != above) {
    EXPECT_EQ(nearest, below < above ? down : up);
  }
}

/// Values of magnitudes within so many powers of two.
std::vector<double> values_within(int spread, int top, std::size_t count, std::mt19937_64& random) {
  std::uniform_real_distribution<double> mantissa(-1, 1);
  std::uniform_int_distribution<int> exponent(top - spread, top);
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(std::ldexp(mantissa(random), exponent(random)));
  return values;
}

TEST(ExactSum, is_that_of_rational_numbers) {
  std::mt19937_64 random(1);
  for (const int top : {1000, 0, -890, -1020})
    for (const int spread : {0, 3, 30, 40, 60, 120, 900})
      for (const std::size_t count : {1u, 2u, 15u, 16u, 17u, 256u, 700u}) {
        std::vector<double> values = values_within(spread, top, count, random);
        const mpq_class exact = exact_sum(values);
        ExactSum one_by_one;
        for (const double value : values) one_by_one.add(value);
        expect_rounded(one_by_one, exact);
        std::shuffle(values.begin(), values.end(), random);
        for (const Index lanes : {4u, 8u, 16u}) {
          const LaneLimit limit(lanes);
          ExactSum together;
          together.add(values);
          expect_rounded(together, exact);
          EXPECT_EQ(together.nearest(), one_by_one.nearest());
          together.subtract(one_by_one);
          EXPECT_EQ(together.nearest(), 0);
        }
      }
}

TEST(ExactSum, forgets_nothing_that_is_small) {
  ExactSum sum;
  sum.add(DBL_MAX);
  sum.add(DBL_TRUE_MIN);
  EXPECT_EQ(sum.nearest(), DBL_MAX);
  EXPECT_EQ(sum.up(), kInfinity);
  EXPECT_EQ(sum.down(), DBL_MAX);
  sum.subtract(DBL_MAX);
  EXPECT_EQ(sum.nearest(), DBL_TRUE_MIN);
  sum.subtract(DBL_TRUE_MIN);
  EXPECT_EQ(sum.nearest(), 0);
  EXPECT_FALSE(std::signbit(sum.nearest()));
}

TEST(ExactSum, is_infinite_out_of_range) {
  ExactSum sum;
  const std::vector<double> values(1000, DBL_MAX);
  sum.add(values);
  EXPECT_EQ(sum.nearest(), kInfinity);
  EXPECT_EQ(sum.down(), DBL_MAX);
  for (int i = 1; i < 1000; ++i) sum.subtract(DBL_MAX);
  EXPECT_EQ(sum.nearest(), DBL_MAX);
  for (int i = 0; i < 3; ++i) sum.subtract(DBL_MAX);
  EXPECT_EQ(sum.nearest(), -kInfinity);
  EXPECT_EQ(sum.up(), -DBL_MAX);
}

TEST(ExactSum, is_as_infinite_as_its_terms) {
  const std::vector<double> values(40, 1);
  for (const double term : {kInfinity, -kInfinity, std::nan("")}) {
    std::vector<double> with = values;
    with[3] = term;
    ExactSum sum;
    sum.add(values);
    sum.add(with);
    for (const double rounded : {sum.nearest(), sum.down(), sum.up()}) {
      EXPECT_EQ(std::isnan(rounded), std::isnan(term));
      if (!std::isnan(term)) {
        EXPECT_EQ(rounded, term);
      }
    }
  }
}

TEST(ExactSum, halves_go_to_even) {
  for (const double odd : {0.0, 1.0}) {
    ExactSum sum;
    sum.add(0x1p53 + 2 * odd);
    sum.add(1);
    EXPECT_EQ(sum.nearest(), 0x1p53 + (odd == 0 ? 0 : 4));
  }
}

}  // namespace
}  // namespace hodt
