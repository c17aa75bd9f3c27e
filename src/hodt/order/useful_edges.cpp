#include "hodt/order/useful_edges.h"

namespace hodt {

std::optional<Index> UsefulEdgeSearch::useful_order(VertexId u, VertexId v, Index limit) {
  const auto degree = [&](VertexId a) {
    std::size_t count = 0;
    graph_.for_each_neighbour(a, [&](VertexId) { ++count; });
    return count;
  };
  if (degree(v) < degree(u)) std::swap(u, v);
  if (graph_.has_edge(u, v)) return 0;
  const auto& found = from(u, limit, [&](VertexId w) { return w == v; });
  if (found.empty()) return std::nullopt;
  return found.front().order;
}

UsefulEdgeSearches::UsefulEdgeSearches(const DelaunayGraph& graph, Index limit,
                                       const Deadline& deadline)
    : deadline_(deadline), searches_([this, &graph] {
        return tree_ ? UsefulEdgeSearch(graph, *tree_) : UsefulEdgeSearch(graph);
      }) {
  if (!graph.has_walls() && (limit >= search_policy::kLeastWithTree || graph.has_hubs()))
    tree_.emplace(graph.xy);
}

}  // namespace hodt
