#include "hodt/tin/interpolate.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "../support/convert.h"
#include "families.h"
#include <gmpxx.h>
#include <gtest/gtest.h>

#include "hodt/pipeline.h"

namespace hodt {
namespace {

using Triangle = std::array<Index, 3>;

/// In rational numbers.
int turn(const Point& a, const Point& b, const Point& c) {
  const mpq_class ax(a.x), ay(a.y);
  return sgn((b.x - ax) * (c.y - ay) - (b.y - ay) * (c.x - ax));
}

bool is_in(const Tin& tin, const Triangle& corners, const Point& p) {
  const std::vector<Point>& xy = tin.points.xy;
  const auto [a, b, c] = corners;
  const int way = turn(xy[a], xy[b], xy[c]);
  return way * turn(xy[a], xy[b], p) >= 0 && way * turn(xy[b], xy[c], p) >= 0 &&
         way * turn(xy[c], xy[a], p) >= 0;
}

bool is_in_any(const Tin& tin, const Point& p) {
  return std::any_of(tin.triangles.begin(), tin.triangles.end(),
                     [&](const Triangle& t) { return is_in(tin, t, p); });
}

/// For each place a triangle that contains it, or none and there is none.
void expect_located(const Tin& tin, const std::vector<Point>& places) {
  const std::vector<Index> found = triangles_at(tin, places);
  ASSERT_EQ(found.size(), places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (found[i] == kNone)
      ASSERT_FALSE(is_in_any(tin, places[i])) << places[i].x << ", " << places[i].y;
    else
      ASSERT_TRUE(is_in(tin, tin.triangles.at(found[i]), places[i]))
          << places[i].x << ", " << places[i].y;
  }
}

/// The vertices, points on and near the edges, inside the triangles and around them all.
std::vector<Point> telling_places(const Tin& tin) {
  const std::vector<Point>& xy = tin.points.xy;
  std::vector<Point> places = xy;
  for (const auto& [a, b, c] : tin.triangles) {
    const auto middle = [](const Point& p, const Point& q) {
      return Point{p.x / 2 + q.x / 2, p.y / 2 + q.y / 2};
    };
    places.push_back(middle(xy[a], xy[b]));
    places.push_back(middle(xy[b], xy[c]));
    places.push_back(middle(middle(xy[a], xy[b]), xy[c]));
    places.push_back({xy[a].x, xy[b].y});  // above, below and beside vertices
    places.push_back({2 * xy[a].x - xy[b].x, 2 * xy[a].y - xy[b].y});
  }
  std::erase_if(places, [](const Point& p) { return !std::isfinite(p.x) || !std::isfinite(p.y); });
  return places;
}

/// Not Delaunay: flattened minima, the triangles in any order, some clockwise.
Tin tangled(const families::Points& points, std::mt19937& random) {
  const auto heights = families::permutation_heights(points, random());
  TriangulateOptions options;
  options.order = 6;
  Tin tin = triangulate(support::to_point_set(points, heights), options).tin;
  std::shuffle(tin.triangles.begin(), tin.triangles.end(), random);
  for (Triangle& t : tin.triangles)
    if (random() % 2) std::swap(t[0], t[1]);
  return tin;
}

class InterpolateFamilies : public testing::TestWithParam<families::Family> {};

TEST_P(InterpolateFamilies, FindsATriangleOrThereIsNone) {
  std::mt19937 random(1);
  for (int round = 0; round < 8; ++round) {
    const Tin tin = tangled(GetParam().make(6 + 5 * round, random()), random);
    expect_located(tin, telling_places(tin));
  }
}

TEST_P(InterpolateFamilies, FindsHoles) {
  std::mt19937 random(2);
  for (int round = 0; round < 8; ++round) {
    Tin tin = tangled(GetParam().make(6 + 5 * round, random()), random);
    const std::vector<Point> places = telling_places(tin);
    std::erase_if(tin.triangles, [&](const Triangle&) { return random() % 3 == 0; });
    expect_located(tin, places);
  }
}

/// Also in needles, in giants and where areas round to nothing.
TEST_P(InterpolateFamilies, StaysBetweenTheCorners) {
  std::mt19937 random(9);
  for (int round = 0; round < 8; ++round) {
    const Tin tin = tangled(GetParam().make(6 + 5 * round, random()), random);
    const std::vector<Point> places = telling_places(tin);
    const std::vector<Index> triangles = triangles_at(tin, places);
    const std::vector<double> heights = interpolate(tin, places);
    for (std::size_t i = 0; i < places.size(); ++i) {
      ASSERT_EQ(std::isnan(heights[i]), triangles[i] == kNone);
      if (triangles[i] == kNone) continue;
      const auto& [a, b, c] = tin.triangles[triangles[i]];
      const auto [low, high] = std::minmax({tin.points.z[a], tin.points.z[b], tin.points.z[c]});
      ASSERT_LE(low, heights[i]);
      ASSERT_LE(heights[i], high);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, InterpolateFamilies, testing::ValuesIn(families::all()),
                         testing::PrintToStringParamName());

/// The plane through three points, solved as a linear system.
double height_on_plane(const PointSet& points, const Triangle& t, const Point& p) {
  using Real = long double;
  const Point &a = points.xy[t[0]], &b = points.xy[t[1]], &c = points.xy[t[2]];
  const Real ux = Real(b.x) - a.x, uy = Real(b.y) - a.y, uz = Real(points.z[t[1]]) - points.z[t[0]];
  const Real vx = Real(c.x) - a.x, vy = Real(c.y) - a.y, vz = Real(points.z[t[2]]) - points.z[t[0]];
  const Real determinant = ux * vy - uy * vx;
  const Real slope_x = (uz * vy - uy * vz) / determinant;
  const Real slope_y = (ux * vz - uz * vx) / determinant;
  return double(points.z[t[0]] + slope_x * (Real(p.x) - a.x) + slope_y * (Real(p.y) - a.y));
}

void expect_heights(const Tin& tin, const std::vector<Point>& places) {
  const std::vector<double> heights = interpolate(tin, places);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto t =
        std::find_if(tin.triangles.begin(), tin.triangles.end(),
                     [&](const Triangle& corners) { return is_in(tin, corners, places[i]); });
    ASSERT_EQ(std::isnan(heights[i]), t == tin.triangles.end());
    if (t == tin.triangles.end()) continue;
    ASSERT_NEAR(heights[i], height_on_plane(tin.points, *t, places[i]), 1e-6);
  }
}

TEST(Interpolate, AgreesWithPlanesThroughTriangles) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> around(-0.2, 1.2);
  for (int round = 0; round < 5; ++round) {
    const Tin tin = tangled(families::random_square(60, random()), random);
    const auto [low, high] =
        std::minmax_element(tin.points.xy.begin(), tin.points.xy.end(),
                            [](const Point& p, const Point& q) { return p.x + p.y < q.x + q.y; });
    std::vector<Point> places = tin.points.xy;
    for (int i = 0; i < 200; ++i)
      places.push_back({low->x + around(random) * (high->x - low->x),
                        low->y + around(random) * (high->y - low->y)});
    expect_heights(tin, places);
  }
}

TEST(Interpolate, AgreesWithPlanesOnLattices) {
  std::mt19937 random(4);
  for (int round = 0; round < 5; ++round) {
    const Tin tin = tangled(families::lattice_subset(40, random(), 9), random);
    std::vector<Point> places;
    for (int x = -2; x < 40; ++x)
      for (int y = -2; y < 40; ++y) places.push_back({x / 4.0, y / 4.0});
    expect_heights(tin, places);
  }
}

TEST(Interpolate, IsExactAtVertices) {
  std::mt19937 random(5);
  std::normal_distribution<double> height(100, 1000);
  Tin tin = tangled(families::random_square(300, 1), random);
  for (double& z : tin.points.z) z = height(random);
  EXPECT_EQ(interpolate(tin, tin.points.xy), tin.points.z);
}

TEST(Interpolate, KeepsAPlane) {
  std::mt19937 random(6);
  Tin tin = tangled(families::lattice_subset(50, 1, 10), random);
  const auto plane = [](const Point& p) { return 3 * p.x - 2 * p.y + 1; };
  for (std::size_t i = 0; i < tin.points.size(); ++i) tin.points.z[i] = plane(tin.points.xy[i]);
  std::vector<Point> places;
  for (int x = 0; x < 20; ++x)
    for (int y = 0; y < 20; ++y) places.push_back({x / 2.0, y / 2.0});
  const std::vector<double> heights = interpolate(tin, places);
  std::size_t inside = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (std::isnan(heights[i])) continue;
    ++inside;
    EXPECT_EQ(heights[i], plane(places[i]));
  }
  EXPECT_GT(inside, 200u);
}

TEST(Interpolate, HasNoHeightOutside) {
  Tin tin;
  tin.points.xy = {{0, 0}, {4, 0}, {0, 4}};
  tin.points.z = {0, 4, 8};
  tin.triangles = {{0, 1, 2}};
  const std::vector<double> heights =
      interpolate(tin, std::vector<Point>{{2.1, 2}, {-1, 0}, {5, 0}, {0, 4.5}, {2, -1}, {2, 2}});
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(std::isnan(heights[i])) << i;
  EXPECT_EQ(heights[5], 6);
}

TEST(Interpolate, NeedsNeitherTrianglesNorPlaces) {
  Tin tin;
  EXPECT_TRUE(std::isnan(interpolate(tin, std::vector<Point>{{0, 0}}).at(0)));
  EXPECT_TRUE(interpolate(tin, {}).empty());
}

TEST(Interpolate, FindsTrianglesOfLargeMeshes) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> uniform(0, 1);
  Tin tin = tangled(families::random_square(20000, 1), random);
  for (const double scale : {1.0, 1e-3}) {  // everywhere, and all near one another
    std::vector<Point> places;
    const Point corner = tin.points.xy[7];
    const Point size{tin.points.xy[9].x - corner.x, tin.points.xy[9].y - corner.y};
    for (int i = 0; i < 20000; ++i)
      places.push_back({corner.x + scale * uniform(random) * size.x,
                        corner.y + scale * uniform(random) * size.y});
    const std::vector<Index> found = triangles_at(tin, places);
    for (std::size_t i = 0; i < places.size(); ++i) {
      ASSERT_NE(found[i], kNone);
      ASSERT_TRUE(is_in(tin, tin.triangles.at(found[i]), places[i]));
    }
  }
}

}  // namespace
}  // namespace hodt
