#include "hodt/mesh/triangle_mesh.h"

#include <algorithm>
#include <set>
#include <vector>

#include "../support/connectivity_problem.h"
#include "../support/convert.h"
#include "../support/shapes.h"
#include <gtest/gtest.h>

namespace hodt {
namespace {

using support::make_mesh;

std::vector<TriangleMesh> sample_meshes() {
  std::vector<TriangleMesh> meshes;
  meshes.push_back(make_mesh(3, {{0, 1, 2}}));
  meshes.push_back(make_mesh(4, {{0, 1, 2}, {2, 1, 3}}));
  for (const int n : {5, 12, 40})
    for (const auto& family : families::all())
      meshes.push_back(delaunay(support::to_point_set(family.make(n, 2))).mesh);
  return meshes;
}

/// Neighbours by looking at every edge.
std::multiset<Index> neighbours_of(const TriangleMesh& mesh, Index v) {
  std::multiset<Index> found;
  for (Index i = 0; i < mesh.halfedge_count(); ++i) {
    const HalfEdgeId h(i);
    if (mesh.origin(h) == v) found.insert(mesh.target(h));
    if (mesh.target(h) == v && mesh.is_boundary(h)) found.insert(mesh.origin(h));
  }
  return found;
}

bool is_on_boundary(const TriangleMesh& mesh, Index v) {
  for (Index i = 0; i < mesh.halfedge_count(); ++i)
    if (mesh.is_boundary(HalfEdgeId(i)) && mesh.origin(HalfEdgeId(i)) == v) return true;
  return false;
}

TEST(TriangleMesh, the_edges_of_a_triangle) {
  for (Index t = 0; t < 5; ++t) {
    const HalfEdgeId h = TriangleMesh::halfedge(TriangleId(t));
    EXPECT_EQ(h, HalfEdgeId(3 * t));
    EXPECT_EQ(TriangleMesh::next(h), HalfEdgeId(3 * t + 1));
    EXPECT_EQ(TriangleMesh::next(TriangleMesh::next(TriangleMesh::next(h))), h);
    for (Index i = 0; i < 3; ++i) {
      const HalfEdgeId g(3 * t + i);
      EXPECT_EQ(TriangleMesh::triangle(g), TriangleId(t));
      EXPECT_EQ(TriangleMesh::prev(TriangleMesh::next(g)), g);
      EXPECT_EQ(TriangleMesh::next(TriangleMesh::prev(g)), g);
    }
  }
  const TriangleMesh mesh = make_mesh(9, {{4, 7, 2}});
  const HalfEdgeId h(1);
  EXPECT_EQ(mesh.origin(h), VertexId(7));
  EXPECT_EQ(mesh.target(h), VertexId(2));
  EXPECT_EQ(mesh.apex(h), VertexId(4));
  EXPECT_TRUE(mesh.is_boundary(h));
  EXPECT_EQ(mesh.vertex_count(), 9u);
  EXPECT_EQ(mesh.triangle_count(), 1u);
  EXPECT_EQ(mesh.halfedge_count(), 3u);
}

TEST(TriangleMesh, rotating_keeps_the_origin_and_goes_back) {
  for (const TriangleMesh& mesh : sample_meshes()) {
    for (Index i = 0; i < mesh.halfedge_count(); ++i) {
      const HalfEdgeId h(i), left = mesh.rotate_ccw(h), right = mesh.rotate_cw(h);
      ASSERT_EQ(left.valid(), !mesh.is_boundary(TriangleMesh::prev(h)));
      ASSERT_EQ(right.valid(), !mesh.is_boundary(h));
      if (left.valid()) {
        ASSERT_EQ(mesh.origin(left), mesh.origin(h));
        ASSERT_EQ(mesh.target(left), mesh.apex(h)) << "the triangle between the two is h's";
        ASSERT_EQ(mesh.rotate_cw(left), h);
      }
      if (right.valid()) {
        ASSERT_EQ(mesh.origin(right), mesh.origin(h));
        ASSERT_EQ(mesh.rotate_ccw(right), h);
      }
    }
  }
}

TEST(TriangleMesh, an_outgoing_halfedge_is_the_first_of_its_fan) {
  for (const TriangleMesh& mesh : sample_meshes()) {
    const auto outgoing = outgoing_halfedges(mesh);
    ASSERT_EQ(outgoing.size(), mesh.vertex_count());
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      ASSERT_TRUE(outgoing[v].valid());
      ASSERT_EQ(mesh.origin(outgoing[v]), VertexId(v));
      ASSERT_EQ(mesh.is_boundary(outgoing[v]), is_on_boundary(mesh, v));
    }
  }
  const auto sparse = outgoing_halfedges(make_mesh(6, {{1, 3, 4}}));
  for (const Index unused : {0, 2, 5}) EXPECT_FALSE(sparse[unused].valid());
  EXPECT_EQ(sparse[3], HalfEdgeId(1));
}

TEST(TriangleMesh, walks_around_a_vertex_pass_everything_once) {
  for (const TriangleMesh& mesh : sample_meshes()) {
    const auto outgoing = outgoing_halfedges(mesh);
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      std::vector<HalfEdgeId> edges;
      for_each_outgoing(mesh, outgoing[v], [&](HalfEdgeId h) { edges.push_back(h); });
      for (std::size_t i = 1; i < edges.size(); ++i)
        ASSERT_EQ(mesh.target(edges[i]), mesh.apex(edges[i - 1])) << "counter-clockwise";
      std::vector<HalfEdgeId> all;
      for (Index i = 0; i < mesh.halfedge_count(); ++i)
        if (mesh.origin(HalfEdgeId(i)) == v) all.push_back(HalfEdgeId(i));
      std::sort(edges.begin(), edges.end());
      ASSERT_EQ(edges, all);

      std::vector<Index> around;
      for_each_neighbour(mesh, outgoing[v], [&](VertexId w) { around.push_back(w); });
      ASSERT_EQ(std::multiset<Index>(around.begin(), around.end()), neighbours_of(mesh, v));
      ASSERT_EQ(around.size(), edges.size() + is_on_boundary(mesh, v));
      for (std::size_t i = 0; i < edges.size() && i + 1 < around.size(); ++i) {
        std::array<Index, 3> triangle{v, around[i], around[i + 1]};
        std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()),
                    triangle.end());
        const auto triangles = support::triangles_of(mesh);
        ASSERT_TRUE(std::binary_search(
            triangles.begin(), triangles.end(),
            oracle::Triangle{int(triangle[0]), int(triangle[1]), int(triangle[2])}));
      }
    }
  }
}

// ---- flip ----

TEST(Flip, of_two_triangles) {
  // a = 0, b = 1, c = 2, d = 3, as the header draws them.
  TriangleMesh mesh = make_mesh(4, {{0, 1, 2}, {1, 0, 3}});
  const HalfEdgeId diagonal = mesh.flip(HalfEdgeId(0));
  EXPECT_EQ(diagonal, TriangleMesh::next(HalfEdgeId(0)));
  EXPECT_EQ(mesh.origin(diagonal), VertexId(3));
  EXPECT_EQ(mesh.target(diagonal), VertexId(2));
  EXPECT_EQ(support::triangles_of(mesh), (oracle::Triangles{{0, 3, 2}, {1, 2, 3}}));
  EXPECT_EQ(connectivity_problem(mesh, Surface::disk), "");
}

TEST(Flip, only_the_edge_and_its_twin_are_renamed) {
  const TriangleMesh before = delaunay({support::uniform(60, 9), {}}).mesh;
  const auto directed = [](const TriangleMesh& mesh, HalfEdgeId h) {
    return std::pair<Index, Index>(mesh.origin(h), mesh.target(h));
  };
  for (Index i = 0; i < before.halfedge_count(); ++i) {
    const HalfEdgeId h(i);
    if (before.is_boundary(h)) continue;
    const HalfEdgeId g = before.twin(h);
    TriangleMesh mesh = before;
    const Index a = mesh.origin(h), b = mesh.target(h), c = mesh.apex(h), d = mesh.apex(g);
    mesh.flip(h);
    ASSERT_EQ(directed(mesh, h), std::pair(a, d));
    ASSERT_EQ(directed(mesh, g), std::pair(b, c));
    for (Index j = 0; j < mesh.halfedge_count(); ++j) {
      const HalfEdgeId other(j);
      const bool gone = other == h || other == g || other == TriangleMesh::next(h) ||
                        other == TriangleMesh::next(g);
      if (gone) continue;
      ASSERT_EQ(directed(mesh, other), directed(before, other));
    }
    ASSERT_EQ(connectivity_problem(mesh, Surface::disk), "");
  }
}

TEST(Flip, flipping_back_gives_the_same_triangles) {
  const TriangleMesh before = delaunay({support::uniform(60, 4), {}}).mesh;
  for (Index i = 0; i < before.halfedge_count(); ++i) {
    const HalfEdgeId h(i);
    if (before.is_boundary(h)) continue;
    TriangleMesh mesh = before;
    HalfEdgeId diagonal = mesh.flip(h);
    ASSERT_NE(support::triangles_of(mesh), support::triangles_of(before));
    diagonal = mesh.flip(diagonal);
    ASSERT_EQ(support::triangles_of(mesh), support::triangles_of(before));
    ASSERT_EQ(std::min(mesh.origin(diagonal), mesh.target(diagonal)),
              std::min(before.origin(h), before.target(h)));
    // Each flip moves the pair on by a quarter and the edge by a slot: after twelve all numbers are
    // as before.
    for (int flips = 2; flips < 12; ++flips) diagonal = mesh.flip(diagonal);
    ASSERT_EQ(diagonal, h);
    ASSERT_TRUE(support::same_arrays(mesh, before));
    ASSERT_EQ(connectivity_problem(mesh, Surface::disk), "");
  }
}

/// Twice the signed area, exact enough for random points in the unit square.
double turn(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

TEST(Flip, thousands_of_random_convex_flips_keep_a_triangulation) {
  families::Random random(8);
  Delaunay d = delaunay({support::uniform(300, 5), {}});
  TriangleMesh& mesh = d.mesh;
  const auto& p = d.vertices.xy;
  int flips = 0;
  for (int round = 0; round < 20000; ++round) {
    const HalfEdgeId h(Index(random.bits() % mesh.halfedge_count()));
    if (mesh.is_boundary(h)) continue;
    const Point a = p[mesh.origin(h)], b = p[mesh.target(h)];
    const Point c = p[mesh.apex(h)], e = p[mesh.apex(mesh.twin(h))];
    const bool convex = turn(a, e, c) > 1e-12 && turn(b, c, e) > 1e-12;
    if (!convex) continue;
    mesh.flip(h);
    ++flips;
    if (flips % 100 != 0) continue;
    ASSERT_EQ(connectivity_problem(mesh, Surface::disk), "");
  }
  EXPECT_GT(flips, 2000);
  EXPECT_EQ(connectivity_problem(mesh, Surface::disk), "");
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.corners(TriangleId(t));
    ASSERT_GT(turn(p[a], p[b], p[c]), 0);
  }
}

}  // namespace
}  // namespace hodt
