// Thousands of walls in large sets, against CGAL's constrained Delaunay triangulation.
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "../support/cgal_triangles.h"
#include "../support/shapes.h"
#include "../support/walls.h"
#include <gtest/gtest.h>

#include "hodt/order/constrained/constrained_delaunay.h"

namespace hodt {
namespace {

using support::walls::Edges;

std::vector<std::pair<int, int>> pairs_of(const Edges& edges) {
  std::vector<std::pair<int, int>> pairs;
  for (const auto& [a, b] : edges)
    if (a != b) pairs.emplace_back(a, b);
  return pairs;
}

/// Off ties there is one triangulation.
void expect_as_cgal(const support::Points& points, std::size_t count, double reach) {
  Delaunay d = delaunay({points, {}});
  const Edges edges = support::walls::random_edges(d.vertices.xy, count, reach, 7);
  ASSERT_GT(edges.size(), count / 5);
  ASSERT_TRUE(insert_walls(d, edges).empty());
  ASSERT_TRUE(support::triangles_of(d.mesh) ==
              support::cgal_constrained(d.vertices.xy, pairs_of(edges)));
}

TEST(ConstrainedDelaunayByCgal, few_points) {
  expect_as_cgal(support::uniform(5000, 1), 1000, 0.02);
  expect_as_cgal(support::uniform(5000, 2), 100, 2);
  expect_as_cgal(support::clustered(5000, 3), 1000, 0.05);
  expect_as_cgal(support::noisy_lattice(70, 70, 1e-6, 4), 1000, 12);
}

TEST(ConstrainedDelaunayByCgal, uniform_points) {
  expect_as_cgal(support::uniform(100000, 5), 4000, 0.01);
}

TEST(ConstrainedDelaunayByCgal, clustered_points) {
  expect_as_cgal(support::clustered(100000, 6), 2000, 0.001);
}

/// Lines are walls from end to end, among other points.
TEST(ConstrainedDelaunayByCgal, contours) {
  constexpr int kLines = 20, kCorners = 400;
  support::Points points = support::uniform(100000 - kLines * kCorners, 8);
  std::vector<std::pair<std::size_t, std::size_t>> rows;
  for (int line = 0; line < kLines; ++line)
    for (int i = 0; i < kCorners; ++i) {
      const double x = 0.9 * i / kCorners + 0.01;
      if (i > 0) rows.emplace_back(points.size() - 1, points.size());
      points.push_back({x, 0.04 * line + 0.05 + 0.03 * std::sin(9 * x + 0.1 * line)});
    }
  Delaunay d = delaunay({points, {}});
  const Buffer<VertexId> vertex = vertices_of_rows({points, {}}, d.vertices);
  Edges edges;
  for (const auto& [a, b] : rows) edges.push_back({vertex[a], vertex[b]});
  ASSERT_TRUE(insert_walls(d, edges).empty());
  ASSERT_TRUE(support::triangles_of(d.mesh) ==
              support::cgal_constrained(d.vertices.xy, pairs_of(edges)));
}

/// With ties both are valid.
TEST(ConstrainedDelaunayByCgal, a_lattice_of_survey_coordinates) {
  Delaunay d = delaunay({support::utm_lattice(316, 316), {}});
  const Point &first = d.vertices.xy[0], &next = d.vertices.xy[1];
  const double step = std::max(std::fabs(first.x - next.x), std::fabs(first.y - next.y));
  const Edges edges = support::walls::random_edges(d.vertices.xy, 1000, 12 * step, 7);
  ASSERT_GT(edges.size(), 200u);
  ASSERT_TRUE(insert_walls(d, edges).empty());
  support::walls::expect_constrained_delaunay(d, edges);
  ASSERT_EQ(d.mesh.triangle_count(),
            support::cgal_constrained(d.vertices.xy, pairs_of(edges)).size());
}

}  // namespace
}  // namespace hodt
