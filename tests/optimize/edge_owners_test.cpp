#include "hodt/optimize/extrema/edge_owners.h"

#include <algorithm>
#include <vector>

#include "families.h"
#include <gtest/gtest.h>

namespace hodt {
namespace {

std::size_t owned(const Buffer<Index>& partners, const std::vector<PlainEdge>& edges) {
  std::size_t count = 0;
  for (const auto& [u, v] : edges) count += (partners[u] == v) + (partners[v] == u);
  return count;
}

/// Edges that all can have an owner: as many owners as edges in each part of the graph.
TEST(EdgeOwners, every_edge_has_one_where_that_is_possible) {
  families::Random random(3);
  for (int round = 0; round < 300; ++round) {
    // A tree with one more edge, or a few such.
    const int n = random.integer(3, 30);
    std::vector<PlainEdge> edges;
    for (int v = 1; v < n; ++v)
      edges.push_back({VertexId(Index(random.integer(0, v - 1))), VertexId(Index(v))});
    const auto is_edge = [&](Index a, Index b) {
      return std::any_of(edges.begin(), edges.end(), [&](const PlainEdge& e) {
        return (e.u == a && e.v == b) || (e.u == b && e.v == a);
      });
    };
    const auto a = Index(random.integer(0, n - 1)), b = Index(random.integer(0, n - 1));
    if (a != b && !is_edge(a, b)) edges.push_back({VertexId(a), VertexId(b)});
    for (std::size_t i = edges.size() - 1; i > 0; --i)
      std::swap(edges[i], edges[random.bits() % (i + 1)]);
    const Buffer<Index> partners = edge_owners(std::size_t(n), edges);
    ASSERT_EQ(owned(partners, edges), edges.size());
    ASSERT_EQ(std::size_t(std::count_if(partners.begin(), partners.end(),
                                        [](Index p) { return p != kNone; })),
              edges.size());
  }
}

TEST(EdgeOwners, too_many_edges_go_without) {
  std::vector<PlainEdge> edges;  // all six between four vertices
  for (Index u = 0; u < 4; ++u)
    for (Index v = u + 1; v < 4; ++v) edges.push_back({VertexId(u), VertexId(v)});
  EXPECT_EQ(owned(edge_owners(4, edges), edges), 4u);
}

}  // namespace
}  // namespace hodt
