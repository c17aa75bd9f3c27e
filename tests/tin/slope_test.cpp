#include "hodt/tin/slope.h"

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace hodt {
namespace {

/// Of a triangle on the plane z = east x + north y.
Slope on_plane(double east, double north, double size = 1) {
  const auto z = [&](const Point& p) { return east * p.x + north * p.y; };
  const Point a{0, 0}, b{3 * size, size}, c{size, 2 * size};
  return slope_of(a, b, c, z(a), z(b), z(c));
}

TEST(Slope, FacesDownhill) {
  for (const double size : {1.0, 1e-300, 1e300}) {
    EXPECT_NEAR(on_plane(0, 0, size).slope, 0, 1e-12);
    EXPECT_NEAR(on_plane(1, 0, size).slope, 45, 1e-9);
    EXPECT_NEAR(on_plane(0, std::sqrt(3), size).slope, 60, 1e-9);
    EXPECT_NEAR(on_plane(0, -1, size).aspect.value(), 0, 1e-9) << "falls to the north";
    EXPECT_NEAR(on_plane(-1, 0, size).aspect.value(), 90, 1e-9) << "to the east";
    EXPECT_NEAR(on_plane(0, 1, size).aspect.value(), 180, 1e-9) << "to the south";
    EXPECT_NEAR(on_plane(1, 0, size).aspect.value(), 270, 1e-9) << "to the west";
    EXPECT_NEAR(on_plane(1, -1, size).aspect.value(), 315, 1e-9) << "to the northwest";
  }
}

TEST(Slope, LevelPlanesFaceNoWay) {
  const Slope level = slope_of({0, 0}, {1, 0}, {0, 1}, 1e300, 1e300, 1e300);
  EXPECT_EQ(level.slope, 0);
  EXPECT_FALSE(level.aspect.has_value());
  EXPECT_TRUE(slope_of({0, 0}, {1, 0}, {0, 1}, 0, 0, 1e-300).aspect.has_value());
}

TEST(Slope, IsThatOfTheSteepestStep) {
  // By definition: of all directions on the map, the aspect is where the plane falls most, by the
  // tangent of the slope.
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> anywhere(-10, 10);
  for (int i = 0; i < 1000; ++i) {
    std::array<Point, 3> p;
    std::array<double, 3> z;
    for (int k = 0; k < 3; ++k)
      p[k] = {anywhere(random), anywhere(random)}, z[k] = anywhere(random);
    const double turn =
        (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
    if (std::fabs(turn) < 1) continue;
    if (turn < 0) std::swap(p[1], p[2]), std::swap(z[1], z[2]);
    // The plane, by Cramer's rule.
    const double area = std::fabs(turn);
    const double gx =
        ((z[1] - z[0]) * (p[2].y - p[0].y) - (z[2] - z[0]) * (p[1].y - p[0].y)) / area;
    const double gy =
        ((z[2] - z[0]) * (p[1].x - p[0].x) - (z[1] - z[0]) * (p[2].x - p[0].x)) / area;
    const Slope slope = slope_of(p[0], p[1], p[2], z[0], z[1], z[2]);
    const auto fall = [&](double degrees) {
      const double angle = degrees * std::numbers::pi / 180;
      return -(gx * std::sin(angle) + gy * std::cos(angle));
    };
    const double steepest = fall(slope.aspect.value());
    EXPECT_NEAR(steepest, std::tan(slope.slope * std::numbers::pi / 180), 1e-9 * steepest);
    EXPECT_TRUE(0 <= *slope.aspect && *slope.aspect < 360);
    for (double d = 0; d < 360; d += 7) EXPECT_LE(fall(d), steepest * (1 + 1e-9));
    EXPECT_EQ(slope_of(p[1], p[2], p[0], z[1], z[2], z[0]).aspect.has_value(), true);
  }
}

}  // namespace
}  // namespace hodt
