// Order-m Voronoi diagrams: which m points are the nearest, all over the plane.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "hodt/order/delaunay_graph.h"

namespace hodt {

/// The order-m Voronoi diagram under the perturbation, as its dual: a mesh (a disk, with the
/// numbers of cells where a triangulation has those of points) with
///
///  - a vertex for every cell: the region of the plane whose m nearest points are the cell's
///    members;
///  - a triangle for every vertex of the diagram: the centre of the circle through the triangle's
///    three sites. Its corners are the three cells around it, counter-clockwise;
///  - an edge for every edge of the diagram, on the bisector of two sites; a boundary edge of the
///    mesh for every edge that goes to infinity.
///
/// A circle with m - 1 points inside, set I, and the sites a, b, c on it is a new vertex: it
/// separates the cells I + a, I + b and I + c. With m - 2 points inside it is an old one, between
/// I + b + c, I + c + a and I + a + b; it was new at order m - 1. docs/design/voronoi.md has more.
struct VoronoiDiagram {
  Index order = 1;  ///< m
  TriangleMesh dual;
  /// Three a triangle, counter-clockwise. At corner i of a new vertex is the cell I + site i, of an
  /// old one the cell I + the other two. So half-edge h crosses the edge of the diagram on the
  /// bisector of sites[h] and sites[next(h)].
  Buffer<VertexId> sites;
  Index old_vertices = 0;    ///< triangles [0, old_vertices) are old, the others new
  Buffer<VertexId> members;  ///< m a cell, ascending

  std::size_t cell_count() const { return dual.vertex_count(); }
  std::span<const VertexId> members_of(Index cell) const {
    return {members.data() + std::size_t{cell} * order, order};
  }
  bool is_new(TriangleId t) const { return t >= old_vertices; }
  /// The points inside the circle of t.
  Index points_inside(TriangleId t) const { return is_new(t) ? order - 1 : order - 2; }
  /// Across h, this member of the cell at its origin is exchanged for the next function's.
  VertexId leaving(HalfEdgeId h) const {
    return sites[is_new(TriangleMesh::triangle(h)) ? h : TriangleMesh::next(h)];
  }
  VertexId entering(HalfEdgeId h) const {
    return sites[is_new(TriangleMesh::triangle(h)) ? TriangleMesh::next(h) : h];
  }
};

/// The diagram of the order m. Expected O(m² n); the same bytes on any number of threads.
/// Throws ParameterError unless 1 <= m < n.
VoronoiDiagram voronoi_diagram(const DelaunayGraph& graph, Index order);

/// The pairs of points whose bisector has an edge of the diagram, the smaller first, ascending. By
/// Lemma 2 these are the (m - 1)-OD edges, as long as m - 1 points are strictly on one side of each
/// such edge (m <= n / 2 - 1 without collinear points ensures it), and but for those that pass
/// through a third point.
std::vector<std::array<VertexId, 2>> bisector_pairs(const VoronoiDiagram& diagram);

}  // namespace hodt
