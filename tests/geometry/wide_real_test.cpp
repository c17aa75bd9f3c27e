#include "hodt/geometry/wide_real.h"

#include <cfloat>
#include <cmath>
#include <random>

#include <gmpxx.h>
#include <gtest/gtest.h>

namespace hodt {
namespace {

double random_double(std::mt19937_64& random, int exponents) {
  std::uniform_real_distribution<double> mantissa(-1, 1);
  std::uniform_int_distribution<int> exponent(-exponents, exponents);
  return std::ldexp(mantissa(random), exponent(random));
}

TEST(WideReal, rounds_as_doubles_do) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 10000; ++i) {
    const double a = random_double(random, 60), b = random_double(random, 60);
    EXPECT_EQ((WideReal(a) + b).to_double(), a + b);
    EXPECT_EQ((WideReal(a) - b).to_double(), a - b);
    EXPECT_EQ((WideReal(a) * b).to_double(), a * b);
    EXPECT_EQ((WideReal(a) / b).to_double(), a / b);
    EXPECT_EQ(sqrt(WideReal(std::fabs(a))).to_double(), std::sqrt(std::fabs(a)));
    EXPECT_EQ(fabs(WideReal(a)).to_double(), std::fabs(a));
    EXPECT_EQ(WideReal(a) < WideReal(b), a < b);
    EXPECT_TRUE(WideReal(a) == WideReal(a));
  }
}

TEST(WideReal, has_exponents_of_any_size) {
  const WideReal large(DBL_MAX), small(DBL_TRUE_MIN);
  EXPECT_EQ((large * large / large).to_double(), DBL_MAX);
  EXPECT_EQ(sqrt(large * large).to_double(), DBL_MAX);
  EXPECT_EQ((small * small / small).to_double(), DBL_TRUE_MIN);
  EXPECT_EQ(sqrt(small * small).to_double(), DBL_TRUE_MIN);
  EXPECT_EQ((large + large - large).to_double(), DBL_MAX);
  EXPECT_EQ((large - large).to_double(), 0);
  EXPECT_TRUE(small * small > 0);
  EXPECT_FALSE((large + large).is_in_range());
  EXPECT_TRUE((large + large).is_large());
  EXPECT_FALSE(small.is_in_range());
  EXPECT_FALSE(small.is_large());
  for (const double value : {0.0, 1.0, DBL_MAX, -DBL_MAX, DBL_MIN})
    EXPECT_TRUE(WideReal(value).is_in_range()) << value;
  EXPECT_TRUE(WideReal(0) * large == WideReal(0));
  EXPECT_TRUE(WideReal(0) / small < small * small);
}

TEST(ExactCross, is_that_of_rational_numbers) {
  std::mt19937_64 random(2);
  for (const int exponents : {0, 3, 200, 1000})
    for (int i = 0; i < 1000; ++i) {
      const auto point = [&] {
        return Point{random_double(random, exponents), random_double(random, exponents)};
      };
      const Point a = point(), b = point();
      Point c = point();
      if (i % 2 == 0) c = {a.x + (b.x - a.x) / 3, a.y + (b.y - a.y) / 3};  // nearly on the line
      using Q = mpq_class;
      const Q expected = (Q(b.x) - a.x) * (Q(c.y) - a.y) - (Q(b.y) - a.y) * (Q(c.x) - a.x);
      // Out of a double's range, too: by comparison with a product of doubles.
      const WideReal cross = exact_cross(a, b, c);
      EXPECT_EQ(cross > 0, expected > 0);
      EXPECT_EQ(cross < 0, expected < 0);
      const WideReal root = sqrt(fabs(cross));
      const Q r(root.to_double());
      EXPECT_LE(abs(r * r - abs(expected)), abs(expected) * Q(1e-14)) << a.x << ' ' << a.y;
    }
}

}  // namespace
}  // namespace hodt
