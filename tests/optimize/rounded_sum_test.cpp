#include "hodt/optimize/rounded_sum.h"

#include <cfloat>
#include <cmath>
#include <random>

#include <gmpxx.h>
#include <gtest/gtest.h>

namespace hodt {
namespace {

/// The nearest double that is no better than the exact sum.
TEST(RoundedSum, is_rounded_outward) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> mantissa(0, 1);
  std::uniform_int_distribution<int> exponent(-60, 3);
  const Aggregator least(Objective(Direction::minimize, Aggregate::sum, TriangleMeasure::area));
  const Aggregator most(Objective(Direction::maximize, Aggregate::sum, TriangleMeasure::area));
  std::size_t rounded = 0;
  for (int i = 0; i < 10000; ++i) {
    const double sign = i % 4 == 0 ? -1 : 1, scale = i % 5 == 0 ? 0x1p-1060 : 1;
    const double x = std::ldexp(mantissa(random), exponent(random)) * scale;
    const double y = sign * std::ldexp(mantissa(random), exponent(random)) * scale;
    const mpq_class exact = mpq_class(x) + mpq_class(y);
    const double down = combine_outward(least, x, y), up = combine_outward(most, x, y);
    EXPECT_LE(mpq_class(down), exact);
    EXPECT_GE(mpq_class(up), exact);
    if (mpq_class(x + y) == exact) {
      EXPECT_EQ(down, x + y);
      EXPECT_EQ(up, x + y);
    } else {
      EXPECT_EQ(std::nextafter(down, up), up);
      ++rounded;
    }
    EXPECT_EQ(mpq_class(x + y) + mpq_class(lost_in_sum(x, y, x + y)), exact);
  }
  EXPECT_GT(rounded, 5000u);
}

TEST(RoundedSum, largest_and_smallest_values_are_no_sums) {
  const Aggregator least(Objective(Direction::minimize, Aggregate::max, TriangleMeasure::area));
  EXPECT_EQ(combine_outward(least, 1, 0.1), 1);
  EXPECT_EQ(bound_within(least, 1, 0), 1);
  EXPECT_LT(bound_within(least, 1, 0.25), 0.75);
  EXPECT_GT(bound_within(least, 1, 0.25), 0.74);
}

}  // namespace
}  // namespace hodt
