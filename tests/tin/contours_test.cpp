#include "hodt/tin/contours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "families.h"
#include <gtest/gtest.h>

#include "hodt/base/error.h"
#include "hodt/base/parallel.h"

namespace hodt {
namespace {

using Lines = std::vector<ContourLine>;

/// A square lattice, each cell cut along a random diagonal, some triangles clockwise.
Tin lattice(int width, int height, const std::vector<double>& z, std::uint64_t seed) {
  families::Random random(seed);
  Tin tin;
  tin.points.z = z;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) tin.points.xy.push_back({double(x), double(y)});
  for (int y = 0; y + 1 < height; ++y)
    for (int x = 0; x + 1 < width; ++x) {
      const Index a = Index(y * width + x), b = a + 1, d = a + Index(width), c = d + 1;
      if (random.integer(0, 1) == 0) {
        tin.triangles.push_back({a, b, c});
        tin.triangles.push_back({a, c, d});
      } else {
        tin.triangles.push_back({a, b, d});
        tin.triangles.push_back({d, b, c});
      }
      if (random.integer(0, 3) == 0) std::swap(tin.triangles.back()[1], tin.triangles.back()[2]);
    }
  return tin;
}

/// Whole heights, so that many vertices are at a level, and triangles are flat.
std::vector<double> whole_heights(std::size_t count, int most, std::uint64_t seed) {
  families::Random random(seed);
  std::vector<double> z(count);
  for (double& height : z) height = random.integer(0, most);
  return z;
}

double doubled_area(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double signed_area(const ContourLine& line) {
  double area = 0;
  for (std::size_t i = 1; i < line.xy.size(); ++i)
    area += 0.5 * (line.xy[i - 1].x * line.xy[i].y - line.xy[i].x * line.xy[i - 1].y);
  return area;
}

/// The part of a triangle that is at the level or above, by clipping it.
double area_above(const Tin& tin, double level) {
  double area = 0;
  for (const std::array<Index, 3>& t : tin.triangles) {
    std::vector<Point> part;
    for (int i = 0; i < 3; ++i) {
      const Index a = t[i], b = t[(i + 1) % 3];
      const double from = tin.points.z[a] - level, to = tin.points.z[b] - level;
      const Point &p = tin.points.xy[a], &q = tin.points.xy[b];
      if (from >= 0) part.push_back(p);
      if ((from >= 0) != (to >= 0)) {
        const double s = from / (from - to);
        part.push_back({p.x + s * (q.x - p.x), p.y + s * (q.y - p.y)});
      }
    }
    double clipped = 0;
    for (std::size_t i = 2; i < part.size(); ++i)
      clipped += doubled_area(part[0], part[i - 1], part[i]) / 2;
    area += std::fabs(clipped);
  }
  return area;
}

Tin pyramid() {
  Tin tin;
  tin.points = {{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}}, {0, 0, 0, 0, 4}};
  tin.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  return tin;
}

TEST(Contours, run_counter_clockwise_around_a_summit) {
  const Lines lines = contours(pyramid(), std::vector<double>{1, 3});
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].level, 1);
  EXPECT_TRUE(lines[0].is_closed());
  EXPECT_EQ(lines[0].xy.size(), 5u);
  EXPECT_DOUBLE_EQ(signed_area(lines[0]), 9);
  EXPECT_DOUBLE_EQ(signed_area(lines[1]), 1);
  for (const Point& p : {Point{0.5, 0.5}, Point{3.5, 0.5}, Point{3.5, 3.5}, Point{0.5, 3.5}})
    EXPECT_EQ(std::count(lines[0].xy.begin(), lines[0].xy.end(), p), p == lines[0].xy[0] ? 2 : 1);
}

TEST(Contours, run_clockwise_around_a_pit) {
  Tin tin = pyramid();
  for (double& z : tin.points.z) z = -z;
  const Lines lines = contours(tin, std::vector<double>{-1});
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_DOUBLE_EQ(signed_area(lines[0]), -9);
}

TEST(Contours, bound_what_is_at_the_level_or_above) {
  // The whole border is at the level: it bounds nothing within the mesh. The summit is a point.
  EXPECT_TRUE(contours(pyramid(), std::vector<double>{0}).empty());
  EXPECT_TRUE(contours(pyramid(), std::vector<double>{4}).empty());
  EXPECT_TRUE(contours(pyramid(), std::vector<double>{4.5, 7}).empty());
  Tin pit = pyramid();
  for (double& z : pit.points.z) z = -z;
  const Lines lines = contours(pit, std::vector<double>{0});
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_DOUBLE_EQ(signed_area(lines[0]), -16);
}

/// A flat top has a line around it, a flat bottom has none.
TEST(Contours, go_around_flat_triangles) {
  std::vector<double> z(36, 1);
  for (const int i : {14, 15, 20, 21}) z[i] = 5;
  const Lines top = contours(lattice(6, 6, z, 1), std::vector<double>{5});
  ASSERT_EQ(top.size(), 1u);
  EXPECT_DOUBLE_EQ(signed_area(top[0]), 1);
  EXPECT_TRUE(contours(lattice(6, 6, z, 1), std::vector<double>{1}).empty());
  for (double& height : z) height = -height;
  EXPECT_TRUE(contours(lattice(6, 6, z, 1), std::vector<double>{-5}).empty());
  EXPECT_EQ(contours(lattice(6, 6, z, 1), std::vector<double>{-4.5}).size(), 1u);
}

TEST(Contours, end_on_the_border) {
  Tin tin;
  tin.points = {{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {0, 2, 2, 0}};
  tin.triangles = {{0, 1, 2}, {0, 2, 3}};
  const Lines lines = contours(tin, std::vector<double>{1});
  ASSERT_EQ(lines.size(), 1u);
  // Higher ground, in the east, is on the left.
  EXPECT_EQ(lines[0].xy, (std::vector<Point>{{1, 2}, {1, 1}, {1, 0}}));
  EXPECT_FALSE(lines[0].is_closed());
}

/// Whether the place is on an edge of the mesh, and at this height there.
bool is_on_surface(const Tin& tin, const Point& p, double level) {
  return std::any_of(tin.triangles.begin(), tin.triangles.end(), [&](const auto& t) {
    for (int i = 0; i < 3; ++i) {
      const Index u = t[i], v = t[(i + 1) % 3];
      const Point &a = tin.points.xy[u], &b = tin.points.xy[v];
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      const double s = ((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / (length * length);
      if (s < -1e-12 || s > 1 + 1e-12 || std::fabs(doubled_area(a, b, p)) > 1e-9) continue;
      if (std::fabs(tin.points.z[u] * (1 - s) + tin.points.z[v] * s - level) < 1e-9) return true;
    }
    return false;
  });
}

bool is_on_border(const Point& p, int width, int height) {
  return p.x == 0 || p.y == 0 || p.x == width - 1 || p.y == height - 1;
}

TEST(Contours, of_random_surfaces_with_ties) {
  constexpr int kWidth = 9, kHeight = 7;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    std::vector<double> z = whole_heights(kWidth * kHeight, seed % 2 == 0 ? 3 : 9, seed);
    const bool has_low_border = seed % 3 == 0;
    for (int i = 0; i < kWidth * kHeight && has_low_border; ++i)
      if (is_on_border({double(i % kWidth), double(i / kWidth)}, kWidth, kHeight)) z[i] = -1;
    const Tin tin = lattice(kWidth, kHeight, z, seed + 100);
    for (const double level : {0., 1., 1.5, 2., 2.25, 3.}) {
      double area = 0;
      for (const ContourLine& line : contours(tin, std::vector<double>{level})) {
        ASSERT_EQ(line.level, level);
        ASSERT_GE(line.xy.size(), 2u);
        for (std::size_t i = 0; i < line.xy.size(); ++i) {
          ASSERT_TRUE(is_on_surface(tin, line.xy[i], level));
          if (i > 0) {
            ASSERT_NE(line.xy[i], line.xy[i - 1]);
          }
        }
        for (const Point& end : {line.xy.front(), line.xy.back()}) {
          ASSERT_TRUE(line.is_closed() || is_on_border(end, kWidth, kHeight));
        }
        area += signed_area(line);
      }
      // Nothing is missing, and every line is the right way round.
      if (has_low_border) {
        ASSERT_NEAR(area, area_above(tin, level), 1e-9);
      }
    }
  }
}

TEST(Contours, of_many_levels_are_those_of_each) {
  const Tin tin = lattice(30, 30, whole_heights(900, 50, 5), 6);
  const std::vector<double> levels = contour_levels(tin, 2.5, 1);
  Lines expected;
  for (const double level : levels) {
    const Lines lines = contours(tin, std::vector<double>{level});
    expected.insert(expected.end(), lines.begin(), lines.end());
  }
  for (const std::size_t threads : {1, 3}) {
    const ThreadLimit limit(threads);
    const Lines lines = contours(tin, levels);
    ASSERT_EQ(lines.size(), expected.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
      ASSERT_EQ(lines[i].level, expected[i].level);
      ASSERT_EQ(lines[i].xy, expected[i].xy);
    }
  }
}

TEST(Contours, of_huge_heights_stay_between_the_ends) {
  Tin tin = pyramid();
  tin.points.z = {-1e308, -1e308, -1e308, -1e308, 1e308};
  const Lines lines = contours(tin, std::vector<double>{0});
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_DOUBLE_EQ(signed_area(lines[0]), 4);
}

TEST(Contours, levels_are_multiples_from_the_base) {
  Tin tin = pyramid();
  EXPECT_EQ(contour_levels(tin, 1), (std::vector<double>{0, 1, 2, 3, 4}));
  EXPECT_EQ(contour_levels(tin, 3, 1), (std::vector<double>{1, 4}));
  EXPECT_EQ(contour_levels(tin, 10, 1000), (std::vector<double>{0}));
  EXPECT_EQ(contour_levels(tin, 10, 5), (std::vector<double>{}));
  tin.points.z = {-7, -7, -7, -7, -2.5};
  EXPECT_EQ(contour_levels(tin, 2), (std::vector<double>{-6, -4}));
}

TEST(Contours, refuse_levels_that_numbers_do_not_tell_apart) {
  Tin tin = pyramid();
  const auto refuses = [&](double interval, double base, const std::string& does) {
    try {
      contour_levels(tin, interval, base);
      ADD_FAILURE() << interval << ' ' << base;
    } catch (const ParameterError& error) {
      EXPECT_NE(std::string(error.what()).find("choose a larger one, " + does + " does"),
                std::string::npos)
          << error.what();
    }
  };
  refuses(1, 1e17, "20");
  refuses(10, 1e17, "20");
  refuses(1, -1e17, "20");
  tin.points.z = {1e17, 1e17, 1e17, 1e17, 1e17 + 64};
  refuses(1, 0, "20");
  refuses(10, 1e17, "20");
  EXPECT_EQ(contour_levels(tin, 16, 1e17),
            (std::vector<double>{1e17, 1e17 + 16, 1e17 + 32, 1e17 + 48, 1e17 + 64}));
  EXPECT_EQ(contour_levels(tin, 32), (std::vector<double>{1e17, 1e17 + 32, 1e17 + 64}));
  EXPECT_EQ(contour_levels(pyramid(), 1, 1e15), (std::vector<double>{0, 1, 2, 3, 4}));
}

TEST(Contours, refuse_what_makes_no_sense) {
  const Tin tin = pyramid();
  EXPECT_THROW(contour_levels(tin, 0), ParameterError);
  EXPECT_THROW(contour_levels(tin, -1), ParameterError);
  EXPECT_THROW(contour_levels(tin, std::numeric_limits<double>::quiet_NaN()), ParameterError);
  for (const double interval : {1e-7, 1e-9, 1e-300, 4e-324}) try {
      contour_levels(tin, interval);
      FAIL() << interval;
    } catch (const ParameterError& error) {
      EXPECT_NE(std::string(error.what()).find("choose a larger one, 5e-07 does"),
                std::string::npos)
          << error.what();
    }
  EXPECT_THROW(contours(tin, {}), ParameterError);
  EXPECT_THROW(contours(tin, std::vector<double>{1, 1}), ParameterError);
  Tin planar = tin;
  planar.points.z.clear();
  EXPECT_THROW(contours(planar, std::vector<double>{1}), ParameterError);
  Tin fan = tin;  // three triangles at one edge
  fan.triangles.push_back({0, 1, 4});
  EXPECT_THROW(contours(fan, std::vector<double>{1}), InputError);
}

}  // namespace
}  // namespace hodt
