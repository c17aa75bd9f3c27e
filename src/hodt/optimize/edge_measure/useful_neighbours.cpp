#include "hodt/optimize/edge_measure/useful_neighbours.h"

#include <algorithm>
#include <deque>
#include <numeric>

#include "hodt/base/parallel.h"
#include "hodt/order/edges.h"

namespace hodt {

UsefulNeighbours::UsefulNeighbours(const DelaunayGraph& graph, Index order,
                                   const Deadline& deadline)
    : first_(graph.xy.size() + 1, 0), greater_(graph.xy.size(), 0) {
  const std::size_t n = graph.xy.size();
  // Edges from their smaller ends, by whose numbers they come. At first these are counted in the
  // place of what is greater.
  std::deque<Index> larger;  // takes no more memory for a while, as a vector would
  const auto add = [&](std::span<const EdgeRecord> piece) {
    for (const EdgeRecord& e : piece) {
      larger.push_back(e.v);
      ++greater_[e.u];
      ++first_[e.u], ++first_[e.v];
    }
  };
  for_each_edge(graph, EdgeClass::useful, order, add, deadline);
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  others_ = Buffer<Index>(first_[n]);
  // From the last edge back, so that each list begins where it should in the end.
  const auto put = [&](Index u, Index v) { others_[--first_[u]] = v; };
  auto edge = larger.rbegin();
  for (auto u = Index(n); u-- > 0;)
    for (Index i = 0; i < greater_[u]; ++i, ++edge) put(u, *edge), put(*edge, u);
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
