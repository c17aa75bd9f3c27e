// The hull of an edge, and its greedy triangulation: the least change that brings the edge in.
#pragma once

#include <array>
#include <vector>

#include "hodt/order/delaunay_graph.h"

namespace hodt {

/// What an edge uv takes the place of. All in order from u to v.
struct Hull {
  std::vector<TriangleId> triangles;  ///< the Delaunay triangles that the edge crosses
  /// The boundary from u to v on either side of the edge, without u and v. These are walks: where
  /// an edge that is not crossed dangles into the hull, its other end comes twice.
  std::vector<VertexId> left, right;
};

/// The hull of uv; empty if uv is a Delaunay edge. REQUIRES u != v, and that no vertex lies between
/// them. Linear in the hull and in the degree of u.
Hull hull_of_edge(const DelaunayGraph& graph, VertexId u, VertexId v);

/// The greedy triangulation of the hull of uv: as many triangles as the hull has, each
/// counter-clockwise, uv a side of two; it is the constrained Delaunay triangulation of the hull
/// with uv, and no triangle's order is above the useful order of uv (Lemma 4). First the triangles
/// on the left of uv, then those on the right. REQUIRES what hull_of_edge does. Takes m log m steps
/// for a hull of m vertices where splits are as even as in quicksort, m² at worst.
std::vector<std::array<VertexId, 3>> greedy_triangulation(const DelaunayGraph& graph, VertexId u,
                                                          VertexId v);

}  // namespace hodt
