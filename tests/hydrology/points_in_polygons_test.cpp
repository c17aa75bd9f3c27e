// Also covers run_tree.h.
#include "hodt/hydrology/points_in_polygons.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "../support/shapes.h"
#include <gmpxx.h>
#include <gtest/gtest.h>

#include "hodt/base/parallel.h"
#include "hodt/delaunay/spatial_order.h"

namespace hodt {
namespace {

using Ring = std::vector<Point>;

int sign_of_turn(const Point& a, const Point& b, const Point& c) {
  const mpq_class ax(a.x), ay(a.y);
  return sgn((b.x - ax) * (c.y - ay) - (b.y - ay) * (c.x - ax));
}

bool is_on(const Point& a, const Point& b, const Point& p) {
  return sign_of_turn(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
         std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
}

/// By a ray upwards, in rational numbers.
bool is_inside(const Polygon& polygon, const Point& p) {
  bool inside = false;
  for (const Ring& ring : polygon.rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      Point a = ring[i], b = ring[(i + 1) % ring.size()];
      if (is_on(a, b, p)) return true;
      if (b.x < a.x) std::swap(a, b);
      if (a.x <= p.x && p.x < b.x && sign_of_turn(a, b, p) < 0) inside = !inside;
    }
  return inside;
}

void expect_as_the_oracle(const std::vector<Point>& points, const std::vector<Polygon>& polygons,
                          const std::string& name) {
  const PointsInPolygons found = points_in_polygons(points, polygons);
  ASSERT_EQ(found.is_inside.size(), points.size());
  ASSERT_EQ(found.holds_point.size(), polygons.size());
  std::vector<bool> inside(points.size(), false);
  for (std::size_t j = 0; j < polygons.size(); ++j) {
    bool holds = false;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (is_inside(polygons[j], points[i])) inside[i] = holds = true;
    EXPECT_EQ(found.holds_point[j], holds) << name << ", polygon " << j;
  }
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(found.is_inside[i], inside[i])
        << name << ", point " << points[i].x << " " << points[i].y;
}

std::vector<Point> in_spatial_order(std::vector<Point> points) {
  const Buffer<Point> sorted = spatial_order({std::move(points), {}}).vertices.xy;
  return {sorted.begin(), sorted.end()};
}

/// Corners on a lattice, crossing and touching each other at will.
Polygon random_polygon(families::Random& random, int corners, int size) {
  Polygon polygon;
  for (int rings = random.integer(1, 3); rings > 0; --rings) {
    Ring ring;
    for (int i = random.integer(3, corners); i > 0; --i)
      ring.push_back({double(random.integer(-1, size)), double(random.integer(-1, size))});
    if (random.integer(0, 1)) ring.push_back(ring.front());
    polygon.rings.push_back(ring);
  }
  return polygon;
}

TEST(PointsInPolygons, equal_the_oracle_on_a_lattice) {
  families::Random random(1);
  for (const int side : {3, 12, 30}) {
    const std::vector<Point> points = in_spatial_order(support::lattice(side, side));
    for (int round = 0; round < 25; ++round)
      expect_as_the_oracle(points,
                           {random_polygon(random, 4, side), random_polygon(random, 30, side)},
                           "lattice " + std::to_string(side));
  }
}

TEST(PointsInPolygons, equal_the_oracle_on_all_families) {
  families::Random random(2);
  for (const auto& family : families::all()) {
    std::vector<Point> points;
    for (const auto& [x, y] : family.make(60, 5)) points.push_back({x, y});
    points = in_spatial_order(points);
    for (int round = 0; round < 4; ++round) {
      // Corners are points, or near them.
      Polygon polygon;
      for (int rings = 0; rings < 2; ++rings) {
        Ring ring;
        for (int i = 0; i < 9; ++i) {
          Point corner = points[random.bits() % points.size()];
          if (round % 2) corner.x = std::nextafter(corner.x, random.real(-1, 1));
          ring.push_back(corner);
        }
        polygon.rings.push_back(ring);
      }
      expect_as_the_oracle(points, {polygon}, family.name);
    }
  }
}

TEST(PointsInPolygons, equal_the_oracle_on_many_points) {
  families::Random random(3);
  const std::vector<Point> points = in_spatial_order(support::clustered(1000, 4));
  std::vector<Polygon> polygons;
  for (int i = 0; i < 20; ++i) {
    const Point& centre = points[random.bits() % points.size()];
    const double size = std::pow(10, random.real(-5, 0));
    Ring ring;
    for (int corner = 0; corner < 40; ++corner)
      ring.push_back({centre.x + size * random.real(-1, 1), centre.y + size * random.real(-1, 1)});
    polygons.push_back({{ring}});
  }
  expect_as_the_oracle(points, polygons, "clustered");
}

TEST(PointsInPolygons, what_touches_counts_and_what_is_in_a_hole_does_not) {
  const std::vector<Point> points{{0, 0}, {1, 0}, {1, 1}, {2, 2}, {3, 3}, {5, 5}, {4, 4}, {9, 9}};
  const Polygon with_hole{{{{0, 0}, {6, 0}, {6, 6}, {0, 6}}, {{1, 1}, {4, 1}, {4, 4}, {1, 4}}}};
  const PointsInPolygons found = points_in_polygons(points, std::vector<Polygon>{with_hole});
  EXPECT_EQ(std::vector<bool>(found.is_inside.begin(), found.is_inside.end()),
            (std::vector<bool>{true, true, true, false, false, true, true, false}));
}

TEST(PointsInPolygons, all_on_one_side_of_a_polygon_are_inside) {
  std::vector<Point> points;
  for (int i = 0; i < 1000; ++i) points.push_back({double(i), double(i)});
  expect_as_the_oracle(points, {{{{{-1, -1}, {2000, 2000}, {0, 700}}}}}, "diagonal");
  expect_as_the_oracle(points, {{{{{0, 0}, {0, 0}, {0, 0}}}}}, "one place");
}

TEST(PointsInPolygons, the_largest_numbers_are_coordinates_too) {
  constexpr double most = std::numeric_limits<double>::max();
  const Polygon all{{{{-most, -most}, {most, -most}, {most, most}, {-most, most}}}};
  const std::vector<Point> points{{0, 0}, {most, 1}, {-most, -most}, {1e-320, 5}};
  expect_as_the_oracle(points, {all}, "all");
  const Polygon half{{{{-most, -most}, {most, -most}, {most, most}}}};
  expect_as_the_oracle(points, {half}, "half");
}

TEST(PointsInPolygons, few_points_and_no_polygons) {
  EXPECT_EQ(points_in_polygons({}, std::vector<Polygon>(2)).holds_point.size(), 2u);
  EXPECT_FALSE(points_in_polygons(std::vector<Point>{{1, 1}}, {}).is_inside[0]);
  EXPECT_FALSE(
      points_in_polygons(std::vector<Point>{{1, 1}}, std::vector<Polygon>(1)).is_inside[0]);
}

TEST(PointsInPolygons, a_large_polygon_is_shared_among_threads) {
  const std::vector<Point> points = in_spatial_order(support::uniform(70000, 6));
  families::Random random(7);
  Ring ring;
  for (int i = 0; i < 300; ++i) ring.push_back({random.real(), random.real()});
  const std::vector<Polygon> polygons{{{ring}}};
  const auto on = [&](std::size_t threads) {
    const ThreadLimit limit(threads);
    const Buffer<bool> inside = points_in_polygons(points, polygons).is_inside;
    return std::vector<bool>(inside.begin(), inside.end());
  };
  const std::vector<bool> one = on(1);
  EXPECT_EQ(one, on(2));
  for (std::size_t i = 0; i < points.size(); i += 397)
    EXPECT_EQ(one[i], is_inside(polygons[0], points[i]));
}

}  // namespace
}  // namespace hodt
