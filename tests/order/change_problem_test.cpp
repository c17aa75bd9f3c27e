#include "hodt/order/change_problem.h"

#include <utility>
#include <vector>

#include "../support/connectivity_problem.h"
#include "../support/convert.h"
#include "../support/shapes.h"
#include "../support/triangulation_problems.h"
#include <gtest/gtest.h>

#include "hodt/geometry/predicates.h"

namespace hodt {
namespace {

/// By checks that look at everything.
bool is_triangulation(std::span<const Point> xy, const TriangleMesh& mesh) {
  return connectivity_problem(mesh, Surface::disk).empty() && embedding_problem(xy, mesh).empty();
}

bool is_convex_at(const DelaunayGraph& graph, const TriangleMesh& mesh, HalfEdgeId h) {
  const Point &a = graph.point(mesh.origin(h)), &b = graph.point(mesh.target(h));
  const Point &c = graph.point(mesh.apex(h)), &d = graph.point(mesh.apex(mesh.twin(h)));
  return orient(d, c, a) * orient(d, c, b) < 0;
}

/// Some flips, of convex quadrilaterals.
void flip_some(const DelaunayGraph& graph, TriangleMesh& mesh, families::Random& random) {
  for (int i = random.integer(0, 20); i > 0; --i) {
    const HalfEdgeId h(Index(random.integer(0, int(mesh.halfedge_count()) - 1)));
    if (!mesh.is_boundary(h) && is_convex_at(graph, mesh, h)) mesh.flip(h);
  }
}

/// A change of the arrays, mostly to the worse.
void spoil(TriangleMesh& mesh, families::Random& random) {
  const int half_edges = int(mesh.halfedge_count());
  const auto any = [&] { return Index(random.integer(0, half_edges - 1)); };
  Buffer<Index>& array = random.integer(0, 1) == 0 ? mesh.origins() : mesh.twins();
  switch (random.integer(0, 3)) {
    case 0:
      array[any()] = Index(random.integer(0, half_edges));
      return;
    case 1:
      array[any()] = kNone;
      return;
    case 2:
      std::swap(array[any()], array[any()]);
      return;
    default:
      mesh.glue(HalfEdgeId(any()), HalfEdgeId(any()));
  }
}

class ChangeProblemFamilies : public testing::TestWithParam<families::Family> {};

TEST_P(ChangeProblemFamilies, is_found_where_a_look_at_everything_finds_one) {
  families::Random random(8);
  int good = 0, bad = 0;
  for (const int n : {4, 5, 7, 12, 30})
    for (int round = 0; round < 60; ++round) {
      const Delaunay d = delaunay(support::to_point_set(GetParam().make(n, n + round / 20)));
      const DelaunayGraph graph(d);
      TriangleMesh mesh = d.mesh;
      flip_some(graph, mesh, random);
      ASSERT_TRUE(is_triangulation(graph.xy, mesh));
      ASSERT_EQ(change_problem(graph, mesh), "");
      for (int spoilt = random.integer(0, 3); spoilt > 0; --spoilt) spoil(mesh, random);
      const bool is_good = is_triangulation(graph.xy, mesh);
      ++(is_good ? good : bad);
      ASSERT_EQ(change_problem(graph, mesh).empty(), is_good)
          << change_problem(graph, mesh) << support::to_source(graph.xy);
    }
  EXPECT_GT(good, 50);
  EXPECT_GT(bad, 50);
}

INSTANTIATE_TEST_SUITE_P(All, ChangeProblemFamilies, testing::ValuesIn(families::all()),
                         [](const auto& each) { return each.param.name; });

// Flips of quadrilaterals that are not convex leave all twins as they should be.
TEST(ChangeProblem, a_clockwise_triangle) {
  const Delaunay d = delaunay({support::uniform(40, 3), {}});
  const DelaunayGraph graph(d);
  int found = 0;
  for (Index i = 0; i < d.mesh.halfedge_count(); ++i) {
    const HalfEdgeId h(i);
    if (d.mesh.is_boundary(h) || is_convex_at(graph, d.mesh, h)) continue;
    TriangleMesh mesh = d.mesh;
    mesh.flip(h);
    EXPECT_NE(change_problem(graph, mesh).find("counter-clockwise"), std::string::npos);
    ++found;
  }
  EXPECT_GT(found, 10);
}

TEST(ChangeProblem, another_size) {
  const Delaunay d = delaunay({support::uniform(30, 1), {}});
  const Delaunay other = delaunay({support::uniform(31, 1), {}});
  EXPECT_NE(change_problem(DelaunayGraph(d), other.mesh), "");
  EXPECT_NE(change_problem(DelaunayGraph(d), TriangleMesh()), "");
}

}  // namespace
}  // namespace hodt
