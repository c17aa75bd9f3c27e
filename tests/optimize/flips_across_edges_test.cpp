#include "hodt/optimize/flip/flips_across_edges.h"

#include <cmath>
#include <string>
#include <vector>

#include "../support/convert.h"
#include "../support/shapes.h"
#include "solution_check.h"
#include <gtest/gtest.h>

#include "hodt/base/parallel.h"
#include "hodt/geometry/predicates.h"
#include "hodt/order/circle_counter.h"

namespace hodt {
namespace {

Terrain rough_terrain(const support::Points& points) {
  return {points, support::rough_heights(points, 0.1, 6)};
}

TriangleMesh improved(const Terrain& terrain, const Objective& objective, Index k, int most) {
  TriangleMesh mesh = terrain.delaunay.mesh;
  const EdgeValues values(objective, terrain.graph.xy, terrain.z());
  improve_across_edges(terrain.graph, values, k, most, {}, mesh);
  return mesh;
}

/// All meshes that one flip makes of the mesh, of order at most k.
template <class F>
void for_each_flip(const Terrain& terrain, const TriangleMesh& mesh, Index k, const F& f) {
  CircleCounter counter(terrain.graph);
  const auto is_triangle = [&](VertexId a, VertexId b, VertexId c) {
    const DelaunayGraph& graph = terrain.graph;
    return orient(graph.point(a), graph.point(b), graph.point(c)) > 0 &&
           counter.count(a, b, c, k) <= k;
  };
  for (Index i = 0; i < mesh.halfedge_count(); ++i) {
    const HalfEdgeId h(i), twin = mesh.twin(h);
    if (!twin.valid() || twin < h) continue;
    const VertexId a = mesh.origin(h), b = mesh.target(h), c = mesh.apex(h), d = mesh.apex(twin);
    if (!is_triangle(a, d, c) || !is_triangle(b, c, d)) continue;
    TriangleMesh flipped = mesh;
    flipped.flip(h);
    f(flipped);
  }
}

std::string problem(const Terrain& terrain, const TriangleMesh& mesh, Index k) {
  if (auto p = connectivity_problem(mesh, Surface::disk); !p.empty()) return p;
  if (auto p = embedding_problem(terrain.graph.xy, mesh); !p.empty()) return p;
  return order_problem(terrain.graph, mesh, k);
}

class FlipsAcrossEdges : public testing::TestWithParam<families::Family> {};

/// On small sets of every shape: a triangulation of the order, never worse, that no valid flip
/// makes better.
TEST_P(FlipsAcrossEdges, leave_none_that_is_better) {
  if (GetParam().name == "wide_range" || GetParam().name == "subnormal_lattice") return;
  for (const int n : {4, 6, 9, 14}) {
    const PointSet set = support::to_point_set(GetParam().make(n, 30 + n));
    const Terrain terrain = rough_terrain(set.xy);
    for (const char* name : {"min-sum-abn", "min-sum-jnd", "max-sum-wabn"}) {
      const Objective objective = objective_from_name(name);
      const EdgeValues values(objective, terrain.graph.xy, terrain.z());
      for (const Index k : {1u, 2u, 4u}) {
        const TriangleMesh mesh = improved(terrain, objective, k, 6);
        ASSERT_EQ(problem(terrain, mesh, k), "") << name << ' ' << k << ' ' << terrain.source();
        const double value = values.of(mesh);
        const auto is_gain = [&](double other) {
          return values.better(other, value) &&
                 std::fabs(other - value) > 1e-9 * (std::fabs(value) + std::fabs(other));
        };
        ASSERT_FALSE(values.better(values.of(terrain.delaunay.mesh), value)) << terrain.source();
        for_each_flip(terrain, mesh, k, [&](const TriangleMesh& once) {
          ASSERT_FALSE(is_gain(values.of(once))) << name << ' ' << k << ' ' << terrain.source();
        });
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, FlipsAcrossEdges, testing::ValuesIn(families::all()),
                         [](const auto& each) { return each.param.name; });

/// Over several levels of blocks.
TEST(FlipsAcrossEdges, are_the_same_on_any_number_of_threads) {
  for (const bool scattered : {true, false}) {
    const Terrain terrain =
        rough_terrain(scattered ? support::uniform(40'000, 5) : support::lattice(200, 200));
    for (const char* name : {"min-sum-abn", "min-max-jnd"}) {
      const Objective objective = objective_from_name(name);
      TriangleMesh first;
      for (const std::size_t threads : {1u, 2u, 3u, 8u}) {
        const ThreadLimit limit(threads);
        const TriangleMesh mesh = improved(terrain, objective, 4, 6);
        if (threads == 1) {
          first = mesh;
          EXPECT_EQ(problem(terrain, mesh, 4), "");
        }
        EXPECT_TRUE(support::same_arrays(mesh, first)) << name << ' ' << threads;
      }
    }
  }
}

/// Nothing is left at the borders of blocks either.
TEST(FlipsAcrossEdges, leave_no_flip_at_borders) {
  const Terrain terrain = rough_terrain(support::uniform(10'000, 7));
  const Objective objective = objective_from_name("min-sum-abn");
  const EdgeValues values(objective, terrain.graph.xy, terrain.z());
  for (const int most : {1, 2, 3, 6}) {
    const TriangleMesh mesh = improved(terrain, objective, 3, most);
    TriangleMesh again = mesh;
    improve_across_edges(terrain.graph, values, 3, 1, {}, again);
    EXPECT_TRUE(support::same_arrays(mesh, again));
  }
}

TEST(FlipsAcrossEdges, end_at_a_deadline) {
  const Terrain terrain = rough_terrain(support::uniform(20'000, 8));
  const Objective objective = objective_from_name("min-sum-abn");
  const EdgeValues values(objective, terrain.graph.xy, terrain.z());
  TriangleMesh mesh = terrain.delaunay.mesh;
  improve_across_edges(terrain.graph, values, 4, 6, Deadline(1e-4), mesh);
  EXPECT_EQ(problem(terrain, mesh, 4), "");
  EXPECT_LE(values.of(mesh), values.of(terrain.delaunay.mesh));
}

}  // namespace
}  // namespace hodt
