// Many locked edges on larger sets, against CGAL's constrained Delaunay triangulation.
#include <utility>
#include <vector>

#include "../support/cgal_triangles.h"
#include "../support/shapes.h"
#include <gtest/gtest.h>

#include "hodt/order/constrained/constrained_triangulation.h"

namespace hodt {
namespace {

/// Locks up to 50 random edges to vertices within a distance, those that fit.
void expect_same(const support::Points& points, double reach, std::uint64_t seed) {
  families::Random random(seed);
  const Delaunay d = delaunay({points, {}});
  const DelaunayGraph graph(d);
  const auto n = static_cast<int>(graph.xy.size());
  ConstrainedTriangulation triangulation(graph);
  std::vector<std::pair<int, int>> edges;
  for (int attempts = 0; attempts < 20000 && edges.size() < 50; ++attempts) {
    const int a = random.integer(0, n - 1), b = random.integer(0, n - 1);
    const double dx = graph.xy[a].x - graph.xy[b].x, dy = graph.xy[a].y - graph.xy[b].y;
    const VertexId from{Index(a)}, to{Index(b)};
    if (a == b || dx * dx + dy * dy > reach * reach) continue;
    if (triangulation.owns_locked_edge(from) || !triangulation.lock(from, to)) continue;
    edges.emplace_back(a, b);
  }
  ASSERT_GT(edges.size(), 10u);
  ASSERT_EQ(support::triangles_of(triangulation.mesh()),
            support::cgal_constrained(graph.xy, edges));
  // And after every other was released again.
  std::vector<std::pair<int, int>> rest;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (i % 2 == 0)
      triangulation.release(VertexId{Index(edges[i].first)});
    else
      rest.push_back(edges[i]);
  }
  ASSERT_EQ(support::triangles_of(triangulation.mesh()), support::cgal_constrained(graph.xy, rest));
}

TEST(ConstrainedByCgal, uniform_points) {
  for (int seed = 0; seed < 4; ++seed) {
    expect_same(support::uniform(3000, seed), 0.1, seed);
    expect_same(support::uniform(3000, seed), 0.5, seed);
    expect_same(support::uniform(3000, seed), 2, seed);
  }
}

TEST(ConstrainedByCgal, clustered_points) {
  for (int seed = 0; seed < 4; ++seed) {
    expect_same(support::clustered(3000, seed), 0.1, seed);
    expect_same(support::clustered(3000, seed), 2, seed);
  }
}

TEST(ConstrainedByCgal, a_lattice_without_ties) {
  for (int seed = 0; seed < 4; ++seed)
    expect_same(support::noisy_lattice(50, 50, 1e-6, seed), 12, seed);
}

}  // namespace
}  // namespace hodt
