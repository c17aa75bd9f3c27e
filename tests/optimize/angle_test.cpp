#include "hodt/optimize/measure/angle.h"

#include <cmath>
#include <limits>
#include <vector>

#include "families.h"
#include <gtest/gtest.h>

#include "hodt/base/lanes.h"

namespace hodt {
namespace {

struct Angle {
  double sine, cosine;
};

/// Of all sizes, and close to 0, 45, 90, 135 and 180 degrees.
std::vector<Angle> many_angles() {
  families::Random random(5);
  std::vector<Angle> angles = {{0, 1}, {0, -1}, {1, 0}, {1, 1}, {1, -1}, {1, 1e-300}, {1e-150, 1}};
  for (int i = 0; i < 60000; ++i) {
    long double degrees = random.real(0, 180);
    if (i % 3 == 1) degrees = 45 * (i / 3 % 5) + std::ldexp(random.real(-1, 1), -i / 3 % 60);
    if (degrees < 0 || degrees > 180) continue;
    const long double size = std::ldexp(random.real(1, 2), int(random.bits() % 100) - 50);
    angles.push_back({double(size * std::sin(degrees * M_PIl / 180)),
                      double(size * std::cos(degrees * M_PIl / 180))});
  }
  return angles;
}

TEST(Angle, is_that_of_the_arctangent) {
  for (const auto& [sine, cosine] : many_angles()) {
    if (sine < 0) continue;  // 180 degrees, rounded
    const auto expected = double(std::atan2((long double)sine, (long double)cosine) * 180 / M_PIl);
    const double unit = std::nextafter(expected, 1e9) - expected;
    ASSERT_NEAR(degrees(sine, cosine), expected, 4 * unit) << sine << ' ' << cosine;
  }
  EXPECT_TRUE(std::isnan(degrees(0, 0)));
  EXPECT_EQ(degrees(1e-300, 1), 0);
}

TEST(Angle, grows_as_its_rank_does) {
  double before = -1, rank_before = -std::numeric_limits<double>::infinity();
  for (int i = 1; i <= 18000; ++i) {
    const double radians = i * 0.01 / 180 * std::numbers::pi;
    const double sine = std::max(0.0, std::sin(radians)), cosine = std::cos(radians);
    EXPECT_GT(degrees(sine, cosine), before);
    EXPECT_GT(angle_rank(sine, cosine), rank_before);
    before = degrees(sine, cosine);
    rank_before = angle_rank(sine, cosine);
  }
  EXPECT_LT(angle_rank(0, 1), angle_rank(1e-300, 1));
  EXPECT_EQ(angle_rank(0, 0), angle_rank(0, 1));  // no angle at all
}

TEST(Angle, is_that_of_its_rank) {
  for (const auto& [sine, cosine] : many_angles()) {
    if (sine < 0) continue;  // 180 degrees, rounded
    ASSERT_EQ(degrees_of_rank(angle_rank(sine, cosine)), degrees(sine, cosine));
  }
}

TEST(Angle, same_bits_in_vector_code) {
  std::vector<double> sine, cosine;
  for (const Angle& angle : many_angles()) {
    sine.push_back(angle.sine);
    cosine.push_back(angle.cosine);
  }
  for (const Index lanes : {4u, 8u, 16u}) {
    const LaneLimit limit(lanes);
    std::vector<double> all(sine.size());
    run_in_lanes([&]<Index>() HODT_INLINE_LAMBDA {
      for (std::size_t i = 0; i < all.size(); ++i) all[i] = degrees(sine[i], cosine[i]);
    });
    for (std::size_t i = 0; i < all.size(); ++i) ASSERT_EQ(all[i], degrees(sine[i], cosine[i]));
  }
}

}  // namespace
}  // namespace hodt
