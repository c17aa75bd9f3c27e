#include "hodt/mesh/find_outgoing.h"

#include <algorithm>
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

/// All edges of a fan, from either end, and none between vertices that are not joined; at a hub of
/// more triangles than are asked first, too.
TEST(FindOutgoing, finds_edges_from_either_end) {
  for (const Index ends : {6u, 2 * kFewTriangles})
    for (const bool is_closed : {false, true}) {
      const TriangleMesh mesh = fan(ends, is_closed);
      const Buffer<HalfEdgeId> outgoing = outgoing_halfedges(mesh);
      for (Index u = 0; u <= ends; ++u)
        for (Index v = 0; v <= ends; ++v) {
          if (u == v) continue;
          const Index low = std::min(u, v), high = std::max(u, v);
          const bool is_edge =
              low == 0 || high == low + 1 || (is_closed && low == 1 && high == ends);
          const HalfEdgeId h = find_edge(mesh, outgoing, VertexId(u), VertexId(v));
          ASSERT_EQ(h.valid(), is_edge) << u << ' ' << v;
          if (!is_edge) continue;
          EXPECT_EQ(std::min<Index>(mesh.origin(h), mesh.target(h)), low);
          EXPECT_EQ(std::max<Index>(mesh.origin(h), mesh.target(h)), high);
        }
    }
}

}  // namespace
}  // namespace hodt
