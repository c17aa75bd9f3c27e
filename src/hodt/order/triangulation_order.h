// The order of a triangulation that differs from the Delaunay triangulation in places.
#pragma once

#include <cstddef>
#include <vector>

#include "hodt/base/ids.h"
#include "hodt/order/delaunay_graph.h"

namespace hodt {

/// How many triangles of `mesh` have order 0, 1, ...; its last entry is not 0. Triangles in the
/// place that they have in the Delaunay triangulation have order 0, all others are counted.
/// Requires mesh.triangle_count() to be that of the Delaunay triangulation.
std::vector<std::size_t> order_histogram(const DelaunayGraph& graph, const TriangleMesh& mesh);

}  // namespace hodt
