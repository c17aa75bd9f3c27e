#include "hodt/order/constrained/insert_edges.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <vector>

#include "../support/connectivity_problem.h"
#include "../support/convert.h"
#include "../support/shapes.h"
#include "../support/triangulation_problems.h"
#include <gtest/gtest.h>

#include "hodt/geometry/predicates.h"
#include "hodt/order/edges.h"

namespace hodt {
namespace {

using Edge = std::array<VertexId, 2>;

/// Useful edges beyond the Delaunay edges, in random order: many cross each other.
std::vector<Edge> shuffled_useful_edges(const DelaunayGraph& graph, Index k, std::uint64_t seed) {
  std::vector<Edge> edges;
  for_each_edge(graph, EdgeClass::useful, k, own_numbering(graph.xy.size()),
                [&](std::span<const EdgeRecord> piece) {
                  for (const auto& [u, v, order] : piece)
                    if (order > 0) edges.push_back({VertexId(u), VertexId(v)});
                });
  families::Random random(seed);
  random.shuffle(edges);
  return edges;
}

bool cross(const DelaunayGraph& graph, const Edge& e, const Edge& f) {
  const auto side = [&](const Edge& g, VertexId v) {
    return orient(graph.point(g[0]), graph.point(g[1]), graph.point(v));
  };
  return side(e, f[0]) * side(e, f[1]) < 0 && side(f, e[0]) * side(f, e[1]) < 0;
}

/// With the smaller end first.
Edge sorted(VertexId a, VertexId b) {
  return a < b ? Edge{a, b} : Edge{b, a};
}

std::set<Edge> edges_of(const TriangleMesh& mesh) {
  std::set<Edge> edges;
  for (Index i = 0; i < mesh.halfedge_count(); ++i) {
    edges.insert(sorted(mesh.origin(HalfEdgeId(i)), mesh.target(HalfEdgeId(i))));
  }
  return edges;
}

TEST(InsertEdges, has_every_edge_that_crosses_none_before_it) {
  for (const support::Points& points :
       {support::uniform(400, 1), support::lattice(20, 20), support::clustered(400, 2)}) {
    const Delaunay d = delaunay({points, {}});
    const DelaunayGraph graph(d);
    const auto edges = shuffled_useful_edges(graph, 6, 3);
    const Insertion insertion = insert_edges(graph, edges);
    ASSERT_EQ(connectivity_problem(insertion.mesh, Surface::disk), "");
    ASSERT_EQ(embedding_problem(graph.xy, insertion.mesh), "");
    const std::set<Edge> present = edges_of(insertion.mesh);
    std::vector<Edge> inserted;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const bool free = std::none_of(inserted.begin(), inserted.end(),
                                     [&](const Edge& e) { return cross(graph, e, edges[i]); });
      ASSERT_EQ(insertion.inserted[i], free);
      if (!free) continue;
      inserted.push_back(edges[i]);
      ASSERT_TRUE(present.contains(sorted(edges[i][0], edges[i][1])));
    }
    // Vertices at which several edges end are what one owner each could not hold.
    ASSERT_GT(inserted.size(), edges.size() / 4);
    ASSERT_LT(inserted.size(), edges.size());

    // Constrained Delaunay: across every other edge the fourth corner is outside the circle.
    std::set<Edge> locked;
    for (const auto& [a, b] : inserted) locked.insert(sorted(a, b));
    const TriangleMesh& mesh = insertion.mesh;
    for (Index i = 0; i < mesh.halfedge_count(); ++i) {
      const HalfEdgeId h(i);
      const Edge edge = sorted(mesh.origin(h), mesh.target(h));
      if (mesh.is_boundary(h) || locked.contains(edge)) continue;
      ASSERT_FALSE(in_circle(graph.point(mesh.origin(h)), graph.point(mesh.target(h)),
                             graph.point(mesh.apex(h)), graph.point(mesh.apex(mesh.twin(h)))));
    }

    // The histogram counts every triangle, and its last entry is the order.
    const auto order = static_cast<Index>(insertion.order_histogram.size() - 1);
    EXPECT_EQ(std::accumulate(insertion.order_histogram.begin(), insertion.order_histogram.end(),
                              std::size_t{0}),
              mesh.triangle_count());
    EXPECT_EQ(order_problem(graph, mesh, order), "");
    EXPECT_NE(order_problem(graph, mesh, order - 1), "");
  }
}

/// Each edge alone gives a triangulation of order 4; together they force more, but never more than
/// 2k - 2 (Gudmundsson, Haverkort and van Kreveld).
TEST(InsertEdges, can_force_a_higher_order_together) {
  constexpr Index k = 4;
  const Delaunay d = delaunay({support::uniform(20000, 4), {}});
  const DelaunayGraph graph(d);
  std::vector<Edge> edges;
  for_each_edge(graph, EdgeClass::useful, k, own_numbering(graph.xy.size()),
                [&](std::span<const EdgeRecord> piece) {
                  for (const auto& [u, v, order] : piece)
                    if (order == k) edges.push_back({VertexId(u), VertexId(v)});
                });
  const auto order = insert_edges(graph, edges).order_histogram.size() - 1;
  EXPECT_GT(order, k);
  EXPECT_LE(order, 2 * k - 2);
}

TEST(InsertEdges, of_no_edges_is_the_delaunay_triangulation) {
  const Delaunay d = delaunay({support::uniform(100, 5), {}});
  const DelaunayGraph graph(d);
  const Insertion insertion = insert_edges(graph, {});
  EXPECT_TRUE(support::same_arrays(insertion.mesh, d.mesh));
  EXPECT_EQ(insertion.order_histogram, std::vector<std::size_t>{d.mesh.triangle_count()});
}

}  // namespace
}  // namespace hodt
