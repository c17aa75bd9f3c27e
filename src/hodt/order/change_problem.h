// Whether a mesh that takes the place of the Delaunay triangulation triangulates the same points.
#pragma once

#include <string>

#include "hodt/order/delaunay_graph.h"

namespace hodt {

/// What is wrong with the mesh, naming a triangle or a half-edge; empty if nothing is: then it is a
/// triangulation of the points' convex hull (or of their domain) with all of them as vertices and
/// the same walls. Trusts the Delaunay
/// triangulation and nothing else, whatever the arrays hold, but looks closely only at the
/// triangles that differ from those at the same places there.
std::string change_problem(const DelaunayGraph& graph, const TriangleMesh& mesh);

}  // namespace hodt
