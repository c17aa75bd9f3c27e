#include "hodt/optimize/edge_measure/useful_neighbours.h"

#include <algorithm>
#include <vector>

#include "hodt/base/parallel.h"
#include "hodt/order/edges.h"

namespace hodt {

UsefulNeighbours::UsefulNeighbours(const DelaunayGraph& graph, Index order,
                                   const Deadline& deadline)
    : first_(graph.xy.size() + 1, 0), greater_(graph.xy.size()) {
  const std::size_t n = graph.xy.size();
  // From their smaller ends, by whose numbers they come.
  std::vector<Index> larger;
  Buffer<Index> larger_count(n, 0);
  const auto add = [&](std::span<const EdgeRecord> piece) {
    for (const EdgeRecord& e : piece) {
      larger.push_back(e.v);
      ++larger_count[e.u];
      ++first_[e.u + 1], ++first_[e.v + 1];
    }
  };
  for_each_edge(graph, EdgeClass::useful, order, add, deadline);
  for (std::size_t v = 0; v < n; ++v) first_[v + 1] += first_[v];
  others_ = Buffer<Index>(first_[n]);
  Buffer<Index> filled(n, 0);
  const auto put = [&](Index u, Index v) { others_[first_[u] + filled[u]++] = v; };
  const Index* edge = larger.data();
  for (Index u = 0; u < n; ++u)
    for (Index i = 0; i < larger_count[u]; ++i, ++edge) put(u, *edge), put(*edge, u);
  const auto size = [&](Index v) { return first_[v + 1] - first_[v]; };
  parallel_for(0, n, 1 << 12, [&](std::size_t begin, std::size_t end) {
    for (auto v = Index(begin); v < end; ++v) {
      const auto is_greater = [&](Index w) {
        return size(w) != size(v) ? size(w) > size(v) : w > v;
      };
      Index* const list = others_.data() + first_[v];
      greater_[v] = Index(std::partition(list, list + size(v), is_greater) - list);
    }
  });
}

}  // namespace hodt
