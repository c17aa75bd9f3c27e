// The order of a triangulation that differs from the Delaunay triangulation in places.
// Tested by tests/order/mesh_order_test.cpp.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hodt/base/ids.h"
#include "hodt/mesh/mesh_change.h"
#include "hodt/order/delaunay_graph.h"

namespace hodt {

/// How many triangles of `mesh` have order 0, 1, ...; its last entry is not 0. Triangles in the
/// place that they have in the Delaunay triangulation have order 0, all others are counted.
/// Requires mesh.triangle_count() to be that of the Delaunay triangulation.
std::vector<std::size_t> order_histogram(const DelaunayGraph& graph, const TriangleMesh& mesh);
/// The same of a change of the Delaunay triangulation, before it is made. A mesh is counted; of
/// flips, all of which order/first_order/first_order.h counted one by one, each makes two triangles
/// of order 1. Throws std::logic_error if two flips are in one triangle.
std::vector<std::size_t> order_histogram(const DelaunayGraph& graph, const MeshChange& change);

/// The order of each triangle that the change leaves, by its place in the mesh; 0 is a triangle of
/// the Delaunay triangulation. Requires and throws what the histogram of the change does.
std::vector<Index> triangle_orders(const DelaunayGraph& graph, const MeshChange& change);
/// The histogram of these.
std::vector<std::size_t> order_histogram(std::span<const Index> orders);

}  // namespace hodt
