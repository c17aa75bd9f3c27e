#include "hodt/order/voronoi/voronoi_polygons.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "../support/convert.h"
#include "../support/shapes.h"
#include <gtest/gtest.h>

#include "hodt/base/error.h"

namespace hodt {
namespace {

using Polygon = std::vector<Point>;

double turn(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double area(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i)
    twice += turn(polygon[0], polygon[i - 1], polygon[i]);
  return twice / 2;
}

double area(const Box& box) {
  return (box.high.x - box.low.x) * (box.high.y - box.low.y);
}

/// By crossings of a ray: very short sides, whose directions are rounding only, do no harm.
bool contains(const Polygon& polygon, const Point& q) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if ((a.y > q.y) == (b.y > q.y)) continue;
    if (a.y < b.y ? turn(a, b, q) > 0 : turn(b, a, q) > 0) inside = !inside;
  }
  return inside;
}

/// The cells' polygons by their members.
std::map<std::vector<Index>, Polygon> polygons_of(std::span<const Point> xy,
                                                  const VoronoiDiagram& diagram, const Box& box) {
  const VoronoiPolygons polygons(xy, diagram, box);
  std::map<std::vector<Index>, Polygon> result;
  for (Index cell = 0; cell < diagram.cell_count(); ++cell) {
    const auto members = diagram.members_of(cell);
    polygons.polygon_of(cell, result[{members.begin(), members.end()}]);
  }
  return result;
}

void expect_tiling(const std::map<std::vector<Index>, Polygon>& cells, const Box& box,
                   const std::string& what) {
  double sum = 0;
  for (const auto& [members, polygon] : cells) {
    if (polygon.empty()) continue;
    EXPECT_GE(polygon.size(), 3u);
    for (const Point& p : polygon)
      EXPECT_TRUE(box.low.x <= p.x && p.x <= box.high.x && box.low.y <= p.y && p.y <= box.high.y);
    sum += area(polygon);
  }
  // Coordinates that are too coarse for the box turn slivers around, and these have no polygon.
  const double size = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  const double largest = std::max(
      {std::fabs(box.low.x), std::fabs(box.low.y), std::fabs(box.high.x), std::fabs(box.high.y)});
  const double coarse = 10 * size * largest * std::numeric_limits<double>::epsilon();
  ASSERT_NEAR(sum, area(box), 1e-9 * area(box) + coarse) << what;
}

/// The order nearest points of q, and by how much they are nearer than the next.
std::pair<std::vector<Index>, double> nearest(std::span<const Point> xy, const Point& q,
                                              Index order) {
  std::vector<std::pair<double, Index>> all;
  for (Index v = 0; v < xy.size(); ++v)
    all.emplace_back(std::hypot(xy[v].x - q.x, xy[v].y - q.y), v);
  std::sort(all.begin(), all.end());
  std::vector<Index> members;
  for (Index i = 0; i < order; ++i) members.push_back(all[i].second);
  std::sort(members.begin(), members.end());
  return {members, all[order].first - all[order - 1].first};
}

void expect_nearest_points(std::span<const Point> xy, Index order,
                           const std::map<std::vector<Index>, Polygon>& cells, const Box& box,
                           int queries, const std::string& what) {
  families::Random random(order);
  const double size = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  for (int i = 0; i < queries; ++i) {
    const double x = random.real(box.low.x, box.high.x), y = random.real(box.low.y, box.high.y);
    const auto [members, gap] = nearest(xy, {x, y}, order);
    if (gap < 1e-6 * size) continue;
    const auto cell = cells.find(members);
    ASSERT_TRUE(cell != cells.end()) << x << ' ' << y << " m " << order << ' ' << what;
    EXPECT_TRUE(contains(cell->second, {x, y})) << x << ' ' << y << ' ' << what;
  }
}

void check(const support::Points& points, Index order, int queries) {
  const Delaunay d = delaunay({points, {}});
  const std::string what = "m " + std::to_string(order) + ' ' +
                           (points.size() < 50 ? support::to_source(d.vertices.xy) : "");
  const VoronoiDiagram diagram = voronoi_diagram(DelaunayGraph(d), order);
  for (const double margin : {0.1, 3.0, -0.2}) {
    const Box box = enlarged_bounding_box(d.vertices.xy, margin);
    if (!(box.low.x < box.high.x && box.low.y < box.high.y)) continue;
    const auto cells = polygons_of(d.vertices.xy, diagram, box);
    ASSERT_NO_FATAL_FAILURE(expect_tiling(cells, box, what));
    ASSERT_NO_FATAL_FAILURE(expect_nearest_points(d.vertices.xy, order, cells, box, queries, what));
  }
}

class VoronoiPolygonFamilies : public testing::TestWithParam<families::Family> {};

TEST_P(VoronoiPolygonFamilies, tile_the_box_by_nearest_points) {
  if (GetParam().name == "wide_range" || GetParam().name == "subnormal_lattice")
    GTEST_SKIP() << "no areas in doubles";
  for (const int n : {5, 8, 13, 40}) {
    const support::Points points = support::to_point_set(GetParam().make(n, 3)).xy;
    for (Index m = 1; m < std::min<std::size_t>(points.size(), 14); ++m)
      ASSERT_NO_FATAL_FAILURE(check(points, m, 40));
  }
}

INSTANTIATE_TEST_SUITE_P(All, VoronoiPolygonFamilies, testing::ValuesIn(families::all()),
                         [](const auto& each) { return each.param.name; });

TEST(VoronoiPolygons, of_a_thousand_points) {
  for (const support::Points& points : {support::uniform(1000, 1), support::lattice(32, 32),
                                        support::clustered(1000, 2), support::utm_lattice(32, 32)})
    for (const Index m : {1u, 2u, 5u, 9u}) ASSERT_NO_FATAL_FAILURE(check(points, m, 60));
}

TEST(VoronoiPolygons, of_a_square_are_exact) {
  const Delaunay d = delaunay({support::lattice(2, 2), {}});
  const DelaunayGraph graph(d);
  const Box box{{-1, -1}, {2, 2}};
  for (const Index m : {1u, 2u, 3u}) {
    std::size_t with_area = 0;
    for (const auto& [members, polygon] :
         polygons_of(d.vertices.xy, voronoi_diagram(graph, m), box))
      if (!polygon.empty()) {
        ++with_area;
        EXPECT_EQ(area(polygon), 9.0 / 4) << m;
      }
    // At m = 2 a fifth cell, between opposite corners, is there by the perturbation only.
    EXPECT_EQ(with_area, 4u) << m;
  }
  EXPECT_EQ(voronoi_diagram(graph, 2).cell_count(), 5u);
}

/// Scaled by a power of two, everything is the same bit for bit.
TEST(VoronoiPolygons, of_huge_and_tiny_coordinates) {
  const support::Points points = support::to_point_set(families::lattice_subset(20, 4, 6)).xy;
  const auto polygons_at = [&](int exponent) {
    support::Points scaled;
    for (const Point& p : points)
      scaled.push_back({std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)});
    const Delaunay d = delaunay({scaled, {}});
    const Box box = enlarged_bounding_box(d.vertices.xy, 0.25);
    auto cells = polygons_of(d.vertices.xy, voronoi_diagram(DelaunayGraph(d), 3), box);
    for (auto& [members, polygon] : cells)
      for (Point& p : polygon) p = {std::ldexp(p.x, -exponent), std::ldexp(p.y, -exponent)};
    return cells;
  };
  const auto expected = polygons_at(0);
  for (const int exponent : {-900, -30, 1, 300, 1018}) EXPECT_EQ(polygons_at(exponent), expected);
}

TEST(VoronoiPolygons, refuse_a_box_without_area) {
  const Delaunay d = delaunay({support::lattice(2, 2), {}});
  const VoronoiDiagram diagram = voronoi_diagram(DelaunayGraph(d), 1);
  constexpr double infinite = std::numeric_limits<double>::infinity();
  for (const Box& box : {Box{{0, 0}, {0, 1}}, Box{{0, 1}, {1, 0}}, Box{{0, 0}, {infinite, 1}}})
    EXPECT_THROW(VoronoiPolygons(d.vertices.xy, diagram, box), ParameterError);
}

/// Whatever the coordinates, every corner is in the box.
TEST(VoronoiPolygons, never_leave_the_box) {
  for (const auto make : {families::wide_range, families::subnormal_lattice, families::tiny_gaps}) {
    const Delaunay d = delaunay(support::to_point_set(make(16, 2)));
    const Box box = enlarged_bounding_box(d.vertices.xy, 0.5);
    for (const Index m : {1u, 2u, 4u})
      for (const auto& [members, polygon] :
           polygons_of(d.vertices.xy, voronoi_diagram(DelaunayGraph(d), m), box))
        for (const Point& p : polygon)
          EXPECT_TRUE(box.low.x <= p.x && p.x <= box.high.x && box.low.y <= p.y &&
                      p.y <= box.high.y);
  }
}

}  // namespace
}  // namespace hodt
