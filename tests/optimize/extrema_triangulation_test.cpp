#include "hodt/optimize/extrema/extrema_triangulation.h"

#include <vector>

#include "solution_check.h"
#include <gtest/gtest.h>

namespace hodt {
namespace {

/// Edges are locked and released at random: the extrema are those of a recount, and what is
/// refused changes nothing.
TEST(ExtremaTriangulation, knows_its_extrema_throughout) {
  int accepted = 0;
  for (const auto& family : families::all()) {
    if (family.name == "wide_range") continue;
    const families::Points points = family.make(16, 5);
    const Terrain terrain(support::to_point_set(points, families::permutation_heights(points, 7)));
    const auto n = Index(terrain.graph.xy.size());
    const Heights heights{terrain.graph.xy, terrain.z()};
    families::Random random(11);
    for (const Objective objective : {Objective::min_local_minima, Objective::min_local_extrema}) {
      ExtremaTriangulation triangulation(terrain.graph, heights, objective, {});
      const auto recount = [&] {
        return count_extrema(terrain, triangulation.triangulation().mesh(), objective);
      };
      for (int round = 0; round < 60; ++round) {
        const VertexId u(Index(random.integer(0, int(n) - 1)));
        const VertexId v(Index(random.integer(0, int(n) - 1)));
        if (u == v || triangulation.triangulation().owns_locked_edge(u)) {
          triangulation.hold(Buffer<Index>(n, kNone));
          ASSERT_EQ(triangulation.extrema(), recount()) << family.name;
          continue;
        }
        const oracle::Instance instance(support::to_oracle(terrain.graph.xy));
        if (!instance.useful_order_by_lemma(int(Index(u)), int(Index(v)))) continue;
        const std::size_t before = triangulation.extrema();
        triangulation.lock_if_better(u, v);
        ASSERT_EQ(triangulation.extrema(), recount()) << family.name;
        ASSERT_LE(triangulation.extrema(), before) << family.name;
        const bool is_locked = triangulation.triangulation().owns_locked_edge(u);
        ASSERT_EQ(is_locked, triangulation.extrema() < before) << family.name;
        accepted += is_locked;
      }
    }
  }
  EXPECT_GT(accepted, 20);
}

}  // namespace
}  // namespace hodt
