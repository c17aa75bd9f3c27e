// Several chosen edges at once in a triangulation, and the order that comes of it.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "hodt/order/delaunay_graph.h"

namespace hodt {

struct Insertion {
  /// The constrained Delaunay triangulation with the edges inserted.
  TriangleMesh mesh;
  /// Which of the edges asked for are in it. The others cross one that was inserted before.
  std::vector<bool> inserted;
  /// How many triangles have order 0, 1, ..., all counted again. Useful edges do not combine
  /// freely: together they can force an order above each one's useful order.
  std::vector<std::size_t> order_histogram;
};

/// Inserts the edges in turn. Time for each as for its hull. REQUIRES of each that its ends differ
/// and that no vertex lies between them.
Insertion insert_edges(const DelaunayGraph& graph, std::span<const std::array<VertexId, 2>> edges);

}  // namespace hodt
