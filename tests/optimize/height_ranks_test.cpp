#include "hodt/optimize/extrema/height_ranks.h"

#include "solution_check.h"
#include <gtest/gtest.h>

#include "hodt/base/parallel.h"

namespace hodt {
namespace {

/// Random points, every height shared by many.
Terrain terraces(std::size_t n) {
  PointSet points{support::uniform(n, 3), {}};
  families::Random random(4);
  for (std::size_t i = 0; i < n; ++i) points.z.push_back(random.integer(0, 5));
  return Terrain(points);
}

TEST(HeightRanks, are_those_of_a_look_at_every_triangle) {
  const Terrain terrain = terraces(40000);
  const Heights heights{terrain.graph.xy, terrain.z()};
  for (const std::size_t threads : {1, 2}) {
    const ThreadLimit limit(threads);
    const Buffer<HeightRanks> ranks = height_ranks_of(terrain.graph.mesh, heights);
    for (Index v = 0; v < ranks.size(); ++v) {
      bool expected[3] = {false, false, false};
      for_each_outgoing(terrain.graph.mesh, terrain.graph.outgoing[v], [&](HalfEdgeId h) {
        const VertexId a = terrain.graph.mesh.target(h), b = terrain.graph.mesh.apex(h);
        expected[heights.lower(a, VertexId(v)) + heights.lower(b, VertexId(v))] = true;
      });
      for (int lower = 0; lower < 3; ++lower)
        ASSERT_EQ(ranks[v].with_lower[lower], expected[lower]) << v << ' ' << lower;
      for (const Extremum kind : kExtrema) {
        bool none = true;
        terrain.graph.for_each_neighbour(
            VertexId(v), [&](VertexId w) { none &= !heights.removes(w, VertexId(v), kind); });
        ASSERT_EQ(ranks[v].is_extremum(kind), none);
      }
    }
  }
}

}  // namespace
}  // namespace hodt
