// Walls in the Delaunay triangulation, against what defines it.
#include "hodt/order/constrained/constrained_delaunay.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <vector>

#include "../oracle/families.h"
#include "../support/connectivity_problem.h"
#include "../support/convert.h"
#include "../support/shapes.h"
#include "../support/walls.h"
#include <gtest/gtest.h>

#include "hodt/geometry/predicates.h"
#include "hodt/mesh/degrees.h"

namespace hodt {
namespace {

using namespace support::walls;

class Walls : public testing::TestWithParam<families::Family> {};

TEST_P(Walls, has_the_edges_and_is_delaunay_apart_from_them) {
  for (const int n : {4, 6, 9, 15, 40, 120})
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      const PointSet points = support::to_point_set(GetParam().make(n, seed));
      Delaunay d = delaunay(points);
      const Edges edges = random_edges(d.vertices.xy, 1 + seed * n / 12, 1e308, seed);
      ASSERT_TRUE(insert_walls(d, edges).empty());
      expect_constrained_delaunay(d, edges);
      if (testing::Test::HasFatalFailure()) FAIL() << "n " << n << " seed " << seed;
    }
}

INSTANTIATE_TEST_SUITE_P(families, Walls, testing::ValuesIn(families::all()),
                         [](const auto& family) { return family.param.name; });

/// One edge across a lattice, past hundreds of vertices or through them.
TEST(ConstrainedDelaunay, has_long_edges) {
  Delaunay d = delaunay({support::lattice(300, 200), {}});
  const std::span<const Point> xy = d.vertices.xy;
  const auto at = [&](double x, double y) {
    const auto place =
        std::find_if(xy.begin(), xy.end(), [&](const Point& p) { return p.x == x && p.y == y; });
    return VertexId(Index(place - xy.begin()));
  };
  const Edges edges{{at(0, 1), at(299, 199)}, {at(0, 0), at(299, 0)}, {at(5, 0), at(199, 97)}};
  ASSERT_TRUE(insert_walls(d, edges).empty());
  expect_constrained_delaunay(d, edges);
}

/// A hub whose every edge is a wall must not take the square of their number.
TEST(ConstrainedDelaunay, has_all_edges_of_a_hub) {
  const PointSet points = support::to_point_set(families::star(100000, 1));
  Delaunay d = delaunay(points);
  const Buffer<VertexId> vertex = vertices_of_rows(points, d.vertices);
  const Buffer<Index> degrees = degrees_of(d.mesh);
  const VertexId hub(Index(std::max_element(degrees.begin(), degrees.end()) - degrees.begin()));
  Edges edges;
  for (const VertexId v : vertex) edges.push_back({hub, v});
  ASSERT_TRUE(insert_walls(d, edges).empty());
  ASSERT_EQ(std::count(d.walls.begin(), d.walls.end(), true),
            std::ptrdiff_t(2 * (edges.size() - 1)));
}

TEST(ConstrainedDelaunay, names_edges_that_cross) {
  const PointSet points{{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 0}, {2, 5}, {1, 1}}, {}};
  Delaunay d = delaunay(points);
  const Buffer<VertexId> v = vertices_of_rows(points, d.vertices);
  // The first goes through a vertex before it meets the second.
  const Edges edges{{v[0], v[2]}, {v[3], v[1]}, {v[4], v[5]}, {v[0], v[1]}, {v[5], v[6]}};
  const std::vector<CrossingEdges> crossings = insert_walls(d, edges);
  std::set<std::pair<Index, Index>> found, all{{0, 1}, {0, 2}, {1, 2}, {1, 4}};
  for (const auto& [first, second] : crossings) found.emplace(first, second);
  ASSERT_FALSE(found.empty());
  ASSERT_EQ(found.size(), crossings.size());
  ASSERT_TRUE(std::includes(all.begin(), all.end(), found.begin(), found.end()));
  ASSERT_EQ(connectivity_problem(d.mesh), "");
  ASSERT_EQ(embedding_problem(d.vertices.xy, d.mesh), "");
}

/// Of random edges, no pair that is found does not cross, and if any cross, one is found.
TEST_P(Walls, finds_a_crossing_if_there_is_one) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    families::Random random(seed);
    Delaunay d = delaunay(support::to_point_set(GetParam().make(12, seed)));
    const auto n = static_cast<int>(d.vertices.size());
    Edges edges;
    for (int i = 0; i < 4; ++i)
      edges.push_back(
          {VertexId{Index(random.integer(0, n - 1))}, VertexId{Index(random.integer(0, n - 1))}});
    const std::vector<CrossingEdges> found = insert_walls(d, edges);
    std::vector<CrossingEdges> all;
    for (Index i = 0; i < edges.size(); ++i)
      for (Index j = i + 1; j < edges.size(); ++j)
        if (is_crossed(d.vertices.xy, edges[i], edges[j])) all.push_back({i, j});
    ASSERT_TRUE(std::includes(all.begin(), all.end(), found.begin(), found.end()));
    ASSERT_EQ(found.empty(), all.empty());
  }
}

}  // namespace
}  // namespace hodt
