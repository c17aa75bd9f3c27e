#include "hodt/order/edge_lists.h"

#include <algorithm>
#include <numeric>

#include "hodt/base/parallel.h"

namespace hodt {

EdgeLists::EdgeLists(std::span<const EdgeRecord> edges, const Numbering& numbering)
    : first_(numbering.ascending.size() + 1, 0) {
  Buffer<Index> place(numbering.ascending.size());
  for (Index i = 0; i < place.size(); ++i) place[numbering.ascending[i]] = i;
  for (const EdgeRecord& e : edges) {
    ++first_[place[e.u] + 1];
    ++first_[place[e.v] + 1];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  ends_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (const EdgeRecord& e : edges) ends_[next[place[e.v]]++] = {place[e.u], e.order};
  for (const EdgeRecord& e : edges) ends_[next[place[e.u]]++] = {place[e.v], e.order};
  parallel_for(0, size(), 1 << 10, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      std::sort(ends_.begin() + std::ptrdiff_t(first_[i]),
                ends_.begin() + std::ptrdiff_t(first_[i + 1]),
                [](const End& a, const End& b) { return a.to < b.to; });
  });
}

std::vector<EdgeRecord> all_edges(const DelaunayGraph& graph, EdgeClass edge_class, Index k,
                                  const Deadline& deadline) {
  std::vector<EdgeRecord> edges;
  const auto add = [&](std::span<const EdgeRecord> piece) {
    edges.insert(edges.end(), piece.begin(), piece.end());
  };
  for_each_edge(graph, edge_class, k, add, deadline);
  return edges;
}

}  // namespace hodt
