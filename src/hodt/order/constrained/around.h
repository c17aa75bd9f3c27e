// What is reached around a vertex without crossing a wall.
// Tested by tests/order/constrained_order_test.cpp.
#pragma once

#include "hodt/order/delaunay_graph.h"
#include "hodt/order/search/search_policy.h"

namespace hodt {

/// Whether nothing gets from one side of the edge to the other.
inline bool is_closed(const DelaunayGraph& graph, HalfEdgeId h) {
  return graph.mesh.is_boundary(h) || graph.is_wall(h);
}

/// Whether an edge from u to v leads that way.
inline bool leads(const DelaunayGraph& graph, VertexId u, VertexId v, Towards towards) {
  return towards == Towards::all ||
         lexicographically_less(graph.point(u), graph.point(v)) == (towards == Towards::larger);
}

/// Calls f(h) for half-edges h that leave the neighbours of the origin of `from`, each in a
/// triangle that is reached from the triangle of `from` by turning around that origin, and
/// in_triangle(g) for the half-edges that leave the origin in these triangles. A neighbour may come
/// twice.
template <class InTriangle, class F>
void for_each_reached_around(const DelaunayGraph& graph, HalfEdgeId from,
                             const InTriangle& in_triangle, const F& f) {
  const TriangleMesh& mesh = graph.mesh;
  const auto pass = [&](HalfEdgeId h) {
    in_triangle(h);
    f(TriangleMesh::next(h));
  };
  HalfEdgeId h = from;
  for (;;) {
    pass(h);
    if (is_closed(graph, TriangleMesh::prev(h))) break;
    h = mesh.rotate_ccw(h);
    if (h == from) return;
  }
  f(TriangleMesh::prev(h));
  for (h = from; !is_closed(graph, h);) pass(h = mesh.rotate_cw(h));
}

}  // namespace hodt
