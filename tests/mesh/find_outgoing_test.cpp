#include "hodt/mesh/find_outgoing.h"

#include <vector>

#include "../support/convert.h"
#include <gtest/gtest.h>

namespace hodt {
namespace {

/// A hub, 0, with triangles to 1, 2, ..., all the way around or to the last.
TriangleMesh fan(Index ends, bool is_closed) {
  std::vector<std::array<Index, 3>> triangles;
  for (Index v = 1; v < ends; ++v) triangles.push_back({0, v, v + 1});
  if (is_closed) triangles.push_back({0, ends, 1});
  return support::make_mesh(ends + 1, triangles);
}

TEST(FindOutgoing, finds_what_a_walk_meets_in_time) {
  for (const bool is_closed : {false, true}) {
    const TriangleMesh mesh = fan(6, is_closed);
    const Buffer<HalfEdgeId> outgoing = outgoing_halfedges(mesh);
    std::vector<HalfEdgeId> all;
    for_each_outgoing(mesh, outgoing[0], [&](HalfEdgeId h) { all.push_back(h); });
    const auto count = Index(all.size());
    ASSERT_EQ(count, is_closed ? 6u : 5u);
    for (Index most = 0; most <= count + 1; ++most) {
      for (Index i = 0; i < count; ++i) {
        const FoundOutgoing found =
            find_outgoing(mesh, outgoing[0], most, [&](HalfEdgeId h) { return h == all[i]; });
        EXPECT_EQ(found.halfedge, i < most ? all[i] : HalfEdgeId());
        EXPECT_EQ(found.is_known, i < most);
      }
      const FoundOutgoing none =
          find_outgoing(mesh, outgoing[0], most, [](HalfEdgeId) { return false; });
      EXPECT_FALSE(none.halfedge.valid());
      EXPECT_EQ(none.is_known, most >= count);
    }
  }
}

}  // namespace
}  // namespace hodt
