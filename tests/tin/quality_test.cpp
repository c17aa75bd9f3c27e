#include "hodt/tin/quality.h"

#include <cmath>
#include <numeric>
#include <vector>

#include "../support/shapes.h"
#include <gtest/gtest.h>

#include "hodt/base/parallel.h"
#include "hodt/delaunay/delaunay.h"

namespace hodt {
namespace {

Quality of_one(Point a, Point b, Point c) {
  const std::vector<Point> points{a, b, c};
  return quality_of(points, std::vector<std::array<Index, 3>>{{0, 1, 2}});
}

TEST(Quality, knows_triangles_from_school) {
  for (const double size : {1.0, 1e-300, 1e300}) {
    const Quality right = of_one({0, 0}, {3 * size, 0}, {0, 4 * size});
    EXPECT_NEAR(right.smallest_angle.min, 36.869897645844, 1e-9);
    EXPECT_NEAR(right.largest_angle.max, 90, 1e-9);
    EXPECT_NEAR(right.radius_ratio.mean, 2 * 1 / 2.5, 1e-12);
    EXPECT_NEAR(right.aspect_ratio.median, 5 / 2.4 * std::sqrt(3) / 2, 1e-12);
    EXPECT_EQ(right.smallest_angles[3], 1u);
    const Quality equilateral = of_one({0, 0}, {2 * size, 0}, {size, std::sqrt(3) * size});
    EXPECT_NEAR(equilateral.smallest_angle.min, 60, 1e-9);
    EXPECT_NEAR(equilateral.largest_angle.max, 60, 1e-9);
    EXPECT_NEAR(equilateral.radius_ratio.min, 1, 1e-12);
    EXPECT_NEAR(equilateral.aspect_ratio.max, 1, 1e-12);
    EXPECT_EQ(equilateral.smallest_angles[5], 1u);
    EXPECT_EQ(equilateral.largest_angles[0], 1u);
  }
}

TEST(Quality, angles_at_corners_are_those_of_any_size) {
  for (const double size : {1.0, 1e-300, 1e300}) {
    const Point a{0, 0}, b{3 * size, 0}, c{0, 4 * size};
    EXPECT_NEAR(angle_at(a, b, c), 90, 1e-12);
    EXPECT_NEAR(angle_at(c, b, a), 36.869897645844, 1e-9);
    EXPECT_EQ(angle_at(b, a, c), angle_at(b, c, a));
  }
}

TEST(Quality, a_sliver_is_told_and_clockwise_is_the_same) {
  const Quality sliver = of_one({0, 0}, {1, 0}, {0.5, 1e-9});
  EXPECT_LT(sliver.smallest_angle.min, 1e-6);
  EXPECT_GT(sliver.largest_angle.max, 179.999);
  EXPECT_LT(sliver.radius_ratio.max, 1e-6);
  EXPECT_NEAR(sliver.aspect_ratio.max, 1e9 * std::sqrt(3) / 2, 1);
  EXPECT_EQ(sliver.smallest_angles[0], 1u);
  EXPECT_EQ(sliver.largest_angles[11], 1u);
  const Quality clockwise = of_one({1, 0}, {0, 0}, {0.5, 1e-9});
  EXPECT_EQ(clockwise.smallest_angle.min, sliver.smallest_angle.min);
  // Rounding leaves no area.
  const Quality flat = of_one({-1e300, 0}, {1e300, 0}, {0, 1e-300});
  EXPECT_EQ(flat.radius_ratio.min, 0);
  EXPECT_TRUE(std::isinf(flat.aspect_ratio.max));
}

TEST(Quality, median_and_mean_are_of_all_triangles) {
  // Smallest angles of 45, 45 and 30 degrees.
  const std::vector<Point> points{{0, 0}, {1, 0}, {0, 1}, {1, 1}, {1, -1 / std::sqrt(3)}};
  const std::vector<std::array<Index, 3>> two{{0, 1, 2}, {0, 4, 1}},
      three{{0, 1, 2}, {1, 3, 2}, {0, 4, 1}};
  EXPECT_NEAR(quality_of(points, two).smallest_angle.median, 37.5, 1e-9);
  EXPECT_NEAR(quality_of(points, three).smallest_angle.median, 45, 1e-9);
  EXPECT_NEAR(quality_of(points, three).smallest_angle.mean, 40, 1e-9);
  EXPECT_EQ(quality_of(points, {}).smallest_angle.max, 0);
}

TEST(Quality, the_same_on_any_thread_count) {
  const Delaunay d = delaunay({support::uniform(40000, 3), {}});
  std::vector<std::array<Index, 3>> triangles(d.mesh.triangle_count());
  for (Index t = 0; t < triangles.size(); ++t) {
    const auto [a, b, c] = d.mesh.corners(TriangleId(t));
    triangles[t] = {a, b, c};
  }
  const auto on = [&](std::size_t threads) {
    const ThreadLimit limit(threads);
    return quality_of(d.vertices.xy, triangles);
  };
  const Quality one = on(1), two = on(2);
  EXPECT_EQ(one.smallest_angle.mean, two.smallest_angle.mean);
  EXPECT_EQ(one.aspect_ratio.mean, two.aspect_ratio.mean);
  EXPECT_EQ(one.smallest_angles, two.smallest_angles);
  EXPECT_EQ(std::accumulate(one.largest_angles.begin(), one.largest_angles.end(), std::size_t{0}),
            triangles.size());
}

}  // namespace
}  // namespace hodt
