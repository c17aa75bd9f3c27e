#include "triangulation_problems.h"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "connectivity_problem.h"
#include "convert.h"
#include "shapes.h"
#include <gtest/gtest.h>

#include "hodt/geometry/predicates.h"

namespace hodt {
namespace {

using support::make_mesh;
using support::Points;
using Triangles = std::vector<std::array<Index, 3>>;

void expect_problem(const std::string& found, const std::string& words) {
  EXPECT_NE(found.find(words), std::string::npos) << "found: " << found;
}

TriangleMesh mesh_of(std::size_t vertices, const oracle::Triangles& triangles) {
  Triangles list;
  for (const auto& [a, b, c] : triangles) list.push_back({Index(a), Index(b), Index(c)});
  return make_mesh(vertices, list);
}

/// Points around the origin, one every `step` degrees, after the origin itself.
Points hub_and_ring(int count, double step) {
  Points points{{0, 0}};
  for (int i = 0; i < count; ++i) {
    const double angle = i * step * std::numbers::pi / 180;
    points.push_back({std::cos(angle), std::sin(angle)});
  }
  return points;
}

const Triangles kWheel{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1}};

TEST(EmbeddingProblem, none_in_triangulations) {
  for (const auto& family : families::all()) {
    const Delaunay d = delaunay(support::to_point_set(family.make(30, 1)));
    EXPECT_EQ(embedding_problem(d.vertices.xy, d.mesh), "") << family.name;
  }
  EXPECT_EQ(embedding_problem(hub_and_ring(5, 72), make_mesh(6, kWheel)), "");
}

TEST(EmbeddingProblem, a_vertex_without_a_triangle) {
  expect_problem(
      embedding_problem(Points{{0, 0}, {1, 0}, {0.1, 0.1}, {0, 1}}, make_mesh(4, {{0, 1, 3}})),
      "vertex 2 has no triangle");
  expect_problem(embedding_problem(Points{{0, 0}, {1, 0}}, make_mesh(3, {{0, 1, 2}})),
                 "2 points, but 3 vertices");
  expect_problem(embedding_problem(Points{}, TriangleMesh()), "no boundary");
}

TEST(EmbeddingProblem, clockwise_and_flat_triangles) {
  Points points = hub_and_ring(5, 72);
  const TriangleMesh mesh = make_mesh(6, kWheel);
  points[0] = {3, 0.1};
  expect_problem(embedding_problem(points, mesh), "triangle 0 is not counter-clockwise");
  expect_problem(embedding_problem(Points{{0, 0}, {1, 1}, {2, 2}}, make_mesh(3, {{0, 1, 2}})),
                 "triangle 0 is not counter-clockwise");
}

TEST(EmbeddingProblem, a_notch_in_the_outline) {
  const Triangles notched(kWheel.begin() + 1, kWheel.end());
  const TriangleMesh mesh = make_mesh(6, notched);
  ASSERT_EQ(connectivity_problem(mesh, Surface::disk), "");
  expect_problem(embedding_problem(hub_and_ring(5, 72), mesh), "turns right at vertex 0");
  // Flat, it is no notch: the hub is on the side from 1 to 2.
  Points points = hub_and_ring(5, 72);
  points[1] = {1, 0}, points[2] = {-1, 0}, points[3] = {-1, -1}, points[4] = {0, -2};
  points[5] = {1, -1};
  EXPECT_EQ(embedding_problem(points, mesh), "");
}

TEST(EmbeddingProblem, a_slit) {
  Points points = hub_and_ring(5, 72);
  points.push_back(points[1]);
  const TriangleMesh mesh = make_mesh(7, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}});
  ASSERT_EQ(connectivity_problem(mesh, Surface::disk), "");
  expect_problem(embedding_problem(points, mesh), "turns back at vertex 0");
}

TEST(EmbeddingProblem, a_surface_that_winds_twice) {
  const TriangleMesh mesh = make_mesh(6, kWheel);
  expect_problem(embedding_problem(hub_and_ring(5, 144), mesh), "winds around 2 times");
}

TEST(EmbeddingProblem, several_pieces_and_holes) {
  const Points points{{0, 0}, {1, 0}, {0, 1}, {5, 5}, {6, 5}, {5, 6}};
  expect_problem(embedding_problem(points, make_mesh(6, {{0, 1, 2}, {3, 4, 5}})),
                 "more than one path: 3 of its 6 edges");
  // A ring of six triangles around the hole 0 1 2.
  const Points around{{0, 0}, {1, 0}, {0, 1}, {0.5, -9}, {9, 9}, {-9, 9}};
  const TriangleMesh ring =
      make_mesh(6, {{0, 3, 1}, {1, 3, 4}, {1, 4, 2}, {2, 4, 5}, {2, 5, 0}, {0, 5, 3}});
  EXPECT_NE(embedding_problem(around, ring), "");
}

/// Every triangulation of small sets passes, and with two of its vertices exchanged it passes
/// exactly if the oracle finds that it is still one.
TEST(EmbeddingProblem, agrees_with_the_oracle) {
  int good = 0, bad = 0;
  families::Random random(3);
  for (const auto& family : families::all()) {
    for (const int n : {4, 6, 7, 8}) {
      const oracle::Instance instance(family.make(n, 8));
      const Points points = support::to_point_set(instance.points()).xy;
      const oracle::Catalogue catalogue(instance);
      for (const auto& each : catalogue.triangulations()) {
        const TriangleMesh mesh = mesh_of(points.size(), each.triangles);
        ASSERT_EQ(connectivity_problem(mesh, Surface::disk), "");
        ASSERT_EQ(embedding_problem(points, mesh), "") << family.name;
        const int i = random.integer(0, instance.size() - 1);
        const int j = random.integer(0, instance.size() - 1);
        oracle::Triangles renamed = each.triangles;
        for (auto& t : renamed)
          for (int& v : t) v = v == i ? j : v == j ? i : v;
        bool turned = false;
        for (const auto& [a, b, c] : renamed) turned |= instance.orient(a, b, c) <= 0;
        const bool fine = !turned && instance.why_not_triangulation(renamed).empty();
        const std::string found = embedding_problem(points, mesh_of(points.size(), renamed));
        ASSERT_EQ(found.empty(), fine) << found << ' ' << support::to_source(points);
        ++(fine ? good : bad);
      }
    }
  }
  EXPECT_GT(good, 100);
  EXPECT_GT(bad, 1000);
}

TEST(OrderProblem, agrees_with_the_oracle) {
  for (const auto& family : families::all()) {
    const Delaunay d = delaunay(support::to_point_set(family.make(7, 4)));
    const DelaunayGraph graph(d);
    const oracle::Instance instance(support::to_oracle(d.vertices.xy));
    const oracle::Catalogue catalogue(instance);
    for (const auto& each : catalogue.triangulations()) {
      const TriangleMesh mesh = mesh_of(d.vertices.size(), each.triangles);
      for (int k = 0; k < 5; ++k)
        ASSERT_EQ(order_problem(graph, mesh, Index(k)).empty(), each.order <= k) << family.name;
      ASSERT_EQ(order_problem(graph, mesh, kNone), "");
      ASSERT_EQ(delaunay_problem(d.vertices.xy, mesh).empty(), each.order == 0);
    }
  }
}

TEST(OrderProblem, names_the_triangle) {
  Delaunay d = delaunay({support::uniform(20000, 1), {}});
  const DelaunayGraph graph(d);
  EXPECT_EQ(order_problem(graph, d.mesh, 0), "");
  TriangleMesh mesh = d.mesh;
  const auto convex = [&](HalfEdgeId h) {
    const auto& p = d.vertices.xy;
    if (d.mesh.is_boundary(h)) return false;
    const Point &a = p[mesh.origin(h)], &b = p[mesh.target(h)], &c = p[mesh.apex(h)],
                &e = p[mesh.apex(mesh.twin(h))];
    return orient(a, e, c) > 0 && orient(b, c, e) > 0;
  };
  HalfEdgeId h(30000);
  while (!convex(h)) h = HalfEdgeId(h + 1);
  mesh.flip(h);
  const std::string problem = order_problem(graph, mesh, 0);
  expect_problem(problem, "has more than 0 points in its circle");
  expect_problem(problem,
                 "triangle " + std::to_string(std::min(TriangleMesh::triangle(h),
                                                       TriangleMesh::triangle(d.mesh.twin(h)))));
  expect_problem(delaunay_problem(d.vertices.xy, mesh), "is inside the circle of triangle");
  EXPECT_EQ(connectivity_problem(mesh, Surface::disk), "");
  EXPECT_EQ(embedding_problem(d.vertices.xy, mesh), "");
}

TEST(OrderProblem, other_meshes_are_refused) {
  const Delaunay d = delaunay(PointSet{{{0, 0}, {1, 0}, {0, 1}}, {}});
  const DelaunayGraph graph(d);
  expect_problem(order_problem(graph, make_mesh(4, {{0, 1, 3}}), 3), "4 vertices");
  TriangleMesh clockwise = d.mesh;
  std::swap(clockwise.origins()[0], clockwise.origins()[1]);
  expect_problem(order_problem(graph, clockwise, 3), "triangle 0 is not counter-clockwise");
  expect_problem(delaunay_problem(d.vertices.xy, clockwise), "triangle 0 is not counter-clockwise");
}

}  // namespace
}  // namespace hodt
