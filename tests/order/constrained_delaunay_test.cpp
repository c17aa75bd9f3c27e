// Walls in the Delaunay triangulation, against what defines it and against CGAL's.
#include "hodt/order/constrained/constrained_delaunay.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <vector>

#include "../oracle/families.h"
#include "../support/cgal_triangles.h"
#include "../support/connectivity_problem.h"
#include "../support/convert.h"
#include "../support/shapes.h"
#include "../support/triangulation_problems.h"
#include <gtest/gtest.h>

#include "hodt/geometry/predicates.h"
#include "hodt/mesh/degrees.h"

namespace hodt {
namespace {

using Edges = std::vector<std::array<VertexId, 2>>;

bool is_between(const Point& a, const Point& b, const Point& p) {
  const bool first = lexicographically_less(a, p) && lexicographically_less(p, b);
  const bool second = lexicographically_less(b, p) && lexicographically_less(p, a);
  return orient(a, b, p) == 0 && (first || second);
}

/// The edge as the pieces between the vertices on it.
std::set<std::pair<Index, Index>> pieces_of(std::span<const Point> xy, const Edges& edges) {
  std::set<std::pair<Index, Index>> pieces;
  for (const auto& [u, v] : edges) {
    if (u == v) continue;
    std::vector<Index> on{u, v};
    for (Index p = 0; p < xy.size(); ++p)
      if (is_between(xy[u], xy[v], xy[p])) on.push_back(p);
    std::sort(on.begin(), on.end(),
              [&](Index p, Index q) { return lexicographically_less(xy[p], xy[q]); });
    for (std::size_t i = 1; i < on.size(); ++i) pieces.insert(std::minmax(on[i - 1], on[i]));
  }
  return pieces;
}

/// Where they meet is no vertex.
bool is_crossed(std::span<const Point> xy, const std::array<VertexId, 2>& e,
                const std::array<VertexId, 2>& f) {
  const Point &a = xy[e[0]], &b = xy[e[1]], &p = xy[f[0]], &q = xy[f[1]];
  return orient(a, b, p) * orient(a, b, q) < 0 && orient(p, q, a) * orient(p, q, b) < 0 &&
         std::none_of(xy.begin(), xy.end(),
                      [&](const Point& v) { return is_between(a, b, v) && is_between(p, q, v); });
}

/// Takes of random edges those that cross none that was taken before.
Edges random_edges(std::span<const Point> xy, std::size_t count, double reach, std::uint64_t seed) {
  families::Random random(seed);
  const auto n = static_cast<int>(xy.size());
  Edges edges;
  for (std::size_t attempt = 0; attempt < 20 * count && edges.size() < count; ++attempt) {
    // Often near each other along the curve.
    const int a = random.integer(0, n - 1), most = attempt % 2 == 0 ? 200 : n;
    const int b = (a + random.integer(0, most)) % n;
    const std::array<VertexId, 2> edge{VertexId{Index(a)}, VertexId{Index(b)}};
    const double dx = xy[edge[0]].x - xy[edge[1]].x, dy = xy[edge[0]].y - xy[edge[1]].y;
    if (dx * dx + dy * dy > reach * reach) continue;
    if (std::none_of(edges.begin(), edges.end(),
                     [&](const auto& other) { return is_crossed(xy, edge, other); }))
      edges.push_back(edge);
  }
  return edges;
}

/// A triangulation with the pieces of the edges as walls, whose other edges are Delaunay, each by
/// itself: that is the constrained Delaunay triangulation.
void expect_constrained_delaunay(const Delaunay& d, const Edges& edges) {
  const std::span<const Point> xy = d.vertices.xy;
  ASSERT_EQ(connectivity_problem(d.mesh), "");
  ASSERT_EQ(embedding_problem(xy, d.mesh), "");
  std::set<std::pair<Index, Index>> walls;
  for (Index i = 0; i < d.mesh.halfedge_count(); ++i) {
    const HalfEdgeId h(i), twin = d.mesh.twin(h);
    if (d.walls[h]) walls.insert(std::minmax<Index>(d.mesh.origin(h), d.mesh.target(h)));
    if (!twin.valid()) continue;
    ASSERT_EQ(d.walls[h], d.walls[twin]);
    if (d.walls[h]) continue;
    ASSERT_FALSE(in_circle(xy[d.mesh.origin(h)], xy[d.mesh.target(h)], xy[d.mesh.apex(h)],
                           xy[d.mesh.apex(twin)]));
  }
  ASSERT_EQ(walls, pieces_of(xy, edges));
}

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
                         [](const auto& info) { return info.param.name; });

void expect_as_cgal(const support::Points& points, std::size_t count, double reach) {
  Delaunay d = delaunay({points, {}});
  const Edges edges = random_edges(d.vertices.xy, count, reach, 7);
  ASSERT_GT(edges.size(), count / 5);
  ASSERT_TRUE(insert_walls(d, edges).empty());
  std::vector<std::pair<int, int>> pairs;
  for (const auto& [a, b] : edges)
    if (a != b) pairs.emplace_back(a, b);
  ASSERT_EQ(support::triangles_of(d.mesh), support::cgal_constrained(d.vertices.xy, pairs));
}

TEST(ConstrainedDelaunay, is_as_cgals_off_ties) {
  expect_as_cgal(support::uniform(5000, 1), 1000, 0.02);
  expect_as_cgal(support::uniform(5000, 2), 100, 2);
  expect_as_cgal(support::clustered(5000, 3), 1000, 0.05);
  expect_as_cgal(support::noisy_lattice(70, 70, 1e-6, 4), 1000, 12);
}

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
