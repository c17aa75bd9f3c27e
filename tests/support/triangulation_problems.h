// Whether a mesh is the triangulation that it should be, layer by layer: an embedding, of order k,
// Delaunay.
//
// Each function returns what is wrong, naming a triangle, vertex or half-edge; empty if nothing is.
// Each requires of the mesh that connectivity_problem (connectivity_problem.h) finds nothing.
#pragma once

#include <span>
#include <string>

#include "hodt/order/delaunay_graph.h"

namespace hodt {

/// Nothing wrong proves that the mesh is a triangulation of the points' convex hull with all of
/// them as vertices. Looks only at the triangles' and the boundary's turns: O(n).
std::string embedding_problem(std::span<const Point> points, const TriangleMesh& mesh);

/// Nothing wrong means that every triangle has order k at most, each by a count of its circle.
/// Requires a mesh on the vertices of the graph.
std::string order_problem(const DelaunayGraph& graph, const TriangleMesh& mesh, Index k);

/// Nothing wrong means that every inner edge is locally Delaunay; of a mesh without an embedding
/// problem, that proves that it is the Delaunay triangulation. O(n).
std::string delaunay_problem(std::span<const Point> points, const TriangleMesh& mesh);

}  // namespace hodt
