#include "hodt/order/constrained/insert_edges.h"

#include <utility>

#include "hodt/order/constrained/constrained_triangulation.h"
#include "hodt/order/triangulation_order.h"

namespace hodt {

Insertion insert_edges(const DelaunayGraph& graph, std::span<const std::array<VertexId, 2>> edges) {
  ConstrainedTriangulation triangulation(graph);
  Insertion insertion;
  for (const auto& [a, b] : edges) insertion.inserted.push_back(triangulation.lock_for_good(a, b));
  insertion.mesh = std::move(triangulation).take_mesh();
  insertion.order_histogram = order_histogram(graph, insertion.mesh);
  return insertion;
}

}  // namespace hodt
