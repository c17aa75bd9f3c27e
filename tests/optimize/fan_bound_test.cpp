#include "hodt/optimize/edge_measure/fan_bound.h"

#include <algorithm>
#include <string>
#include <vector>

#include "../support/convert.h"
#include "../support/shapes.h"
#include "solution_check.h"
#include <gtest/gtest.h>

#include "hodt/base/parallel.h"
#include "hodt/optimize/edge_measure/useful_neighbours.h"
#include "hodt/order/edges.h"

namespace hodt {
namespace {

Terrain rough_terrain(const support::Points& points) {
  return {points, support::rough_heights(points, 0.1, 6)};
}

/// The value of a triangulation of the oracle, by the edges that two of its triangles have.
double value_of(const EdgeValues& values, const oracle::Triangles& triangles) {
  double value = 0;
  for (const auto& t : triangles)
    for (int i = 0; i < 3; ++i)
      for (const auto& s : triangles)
        for (int j = 0; j < 3; ++j)
          if (t[i] == s[(j + 1) % 3] && t[(i + 1) % 3] == s[j] && t[i] < s[j])
            value += values.of(VertexId(Index(t[i])), VertexId(Index(s[j])),
                               VertexId(Index(t[(i + 2) % 3])), VertexId(Index(s[(j + 2) % 3])));
  return value;
}

class FanBoundFamilies : public testing::TestWithParam<families::Family> {};

TEST_P(FanBoundFamilies, no_triangulation_is_better) {
  if (GetParam().name == "wide_range" || GetParam().name == "subnormal_lattice") return;
  for (const int n : {4, 6, 8, 9})
    for (int seed = 0; seed < 3; ++seed) {
      const Terrain terrain =
          rough_terrain(support::to_point_set(GetParam().make(n, 50 + seed)).xy);
      const oracle::Instance instance(support::to_oracle(terrain.graph.xy));
      const oracle::Catalogue catalogue(instance);
      for (const char* name : {"min-sum-abn", "min-sum-jnd", "max-sum-wabn", "max-sum-jnd"}) {
        const EdgeValues values(objective_from_name(name), terrain.graph.xy, terrain.z());
        for (const Index k : {0u, 1u, 2u, 3u, 4u}) {
          const double bound = bound_by_fans(terrain.graph, values, k, {});
          for (const auto& t : catalogue.triangulations()) {
            if (t.order > int(k)) continue;
            const double value = value_of(values, t.triangles);
            const double slack = 1e-12 * (value + bound);  // of the sum here
            if (values.sign() > 0) {
              ASSERT_LE(bound, value + slack) << name << ' ' << k << ' ' << terrain.source();
            } else {
              ASSERT_GE(bound, value - slack) << name << ' ' << k << ' ' << terrain.source();
            }
          }
        }
      }
    }
}

INSTANTIATE_TEST_SUITE_P(All, FanBoundFamilies, testing::ValuesIn(families::all()),
                         [](const auto& each) { return each.param.name; });

/// At order 0 there is one fan at each vertex.
TEST(FanBound, is_the_value_at_order_0) {
  for (const bool scattered : {true, false}) {
    const Terrain terrain =
        rough_terrain(scattered ? support::uniform(2000, 5) : support::lattice(40, 40));
    for (const char* name : {"min-sum-abn", "max-sum-wabn"}) {
      const EdgeValues values(objective_from_name(name), terrain.graph.xy, terrain.z());
      const double value = values.of(terrain.delaunay.mesh);
      const double bound = bound_by_fans(terrain.graph, values, 0, {});
      EXPECT_NEAR(bound, value, 1e-12 * value);
      EXPECT_LE(values.sign() * bound, values.sign() * value);
    }
  }
}

TEST(FanBound, is_the_same_on_any_number_of_threads) {
  const Terrain terrain = rough_terrain(support::uniform(20'000, 5));
  const EdgeValues values(objective_from_name("min-sum-abn"), terrain.graph.xy, terrain.z());
  const auto bound = [&](std::size_t threads) {
    const ThreadLimit limit(threads);
    return bound_by_fans(terrain.graph, values, 4, {});
  };
  for (const std::size_t threads : {2u, 3u, 8u}) EXPECT_EQ(bound(threads), bound(1));
}

TEST(UsefulNeighbours, are_the_other_ends) {
  for (const bool scattered : {true, false}) {
    const Terrain terrain =
        rough_terrain(scattered ? support::uniform(500, 5) : support::lattice(20, 20));
    std::vector<std::vector<Index>> expected(terrain.graph.xy.size());
    for_each_edge(terrain.graph, EdgeClass::useful, 3, [&](std::span<const EdgeRecord> piece) {
      for (const EdgeRecord& e : piece) expected[e.u].push_back(e.v), expected[e.v].push_back(e.u);
    });
    const UsefulNeighbours neighbours(terrain.graph, 3, {});
    for (Index v = 0; v < expected.size(); ++v) {
      const auto all = neighbours.of(VertexId(v)), greater = neighbours.greater_of(VertexId(v));
      std::vector<Index> found(all.begin(), all.end());
      std::sort(found.begin(), found.end());
      std::sort(expected[v].begin(), expected[v].end());
      EXPECT_EQ(found, expected[v]);
      for (const Index w : greater) {
        const auto others = neighbours.greater_of(VertexId(w));
        EXPECT_EQ(std::find(others.begin(), others.end(), v), others.end());
      }
    }
  }
}

}  // namespace
}  // namespace hodt
