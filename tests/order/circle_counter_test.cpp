#include "hodt/order/circle_counter.h"

#include <algorithm>
#include <vector>

#include "../support/convert.h"
#include "../support/shapes.h"
#include <gtest/gtest.h>

namespace hodt {
namespace {

TEST(CircleCounter, equals_the_oracle_on_all_families) {
  for (const auto& family : families::all()) {
    const int n = family.name == "wide_range" ? 10 : 16;
    const Delaunay d = delaunay(support::to_point_set(family.make(n, 21)));
    const DelaunayGraph graph(d);
    const oracle::Instance instance(support::to_oracle(d.vertices.xy));
    CircleCounter counter(graph);
    for (int a = 0; a < instance.size(); ++a)
      for (int b = 0; b < instance.size(); ++b)
        for (int c = b + 1; c < instance.size(); ++c) {
          if (a == b || a == c || instance.orient(a, b, c) <= 0) continue;
          const auto order = static_cast<Index>(instance.triangle_order(a, b, c));
          const VertexId va{Index(a)}, vb{Index(b)}, vc{Index(c)};
          ASSERT_EQ(counter.count(va, vb, vc, kUnlimited), order) << family.name;
          ASSERT_EQ(counter.inside().size(), order);
          for (const Index limit : {0u, 1u, 2u, 5u})
            ASSERT_EQ(counter.count(va, vb, vc, limit), std::min(order, limit + 1));
        }
  }
}

/// Whatever the circle and whichever vertices on it or inside it the search starts from.
TEST(CircleCounter, equals_a_loop_over_all_points) {
  families::Random random(1);
  for (const support::Points& points :
       {support::uniform(1500, 2), support::lattice(38, 38), support::clustered(1500, 3),
        support::cocircular_rings(5)}) {
    const Delaunay d = delaunay({points, {}});
    const DelaunayGraph graph(d);
    CircleCounter counter(graph);
    const auto any = [&] { return VertexId(Index(random.bits() % graph.xy.size())); };
    int circles = 0;
    while (circles < 800) {
      VertexId a = any(), b = any(), c = any();
      if (circles % 4 != 0) {  // three of one neighbourhood: small circles
        std::vector<VertexId> near;
        graph.for_each_neighbour(a, [&](VertexId v) { near.push_back(v); });
        b = near[random.bits() % near.size()];
        near.clear();
        graph.for_each_neighbour(b, [&](VertexId v) { near.push_back(v); });
        c = near[random.bits() % near.size()];
      }
      const int turn = orient(graph.point(a), graph.point(b), graph.point(c));
      if (turn == 0) continue;
      if (turn < 0) std::swap(b, c);
      ++circles;
      std::vector<Index> expected;
      for (Index v = 0; v < graph.xy.size(); ++v)
        if (in_circle(graph.point(a), graph.point(b), graph.point(c), graph.xy[v]))
          expected.push_back(v);
      ASSERT_EQ(counter.count(a, b, c, kUnlimited), expected.size());
      std::vector<Index> found(counter.inside().begin(), counter.inside().end());
      std::sort(found.begin(), found.end());
      ASSERT_EQ(found, expected);

      const auto limit = static_cast<Index>(random.integer(0, 12));
      ASSERT_EQ(counter.count(a, b, c, limit), std::min<std::size_t>(expected.size(), limit + 1));
      ASSERT_LE(counter.inside().size(), limit + 1);
      for (const VertexId v : counter.inside())
        ASSERT_TRUE(std::binary_search(expected.begin(), expected.end(), Index(v)));
    }
  }
}

}  // namespace
}  // namespace hodt
