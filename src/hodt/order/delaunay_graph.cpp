#include "hodt/order/delaunay_graph.h"

#include <numeric>

#include "hodt/base/parallel.h"

namespace hodt {

void DelaunayGraph::list_neighbours() {
  constexpr std::size_t kGrain = 1 << 13;
  const std::size_t n = xy.size();
  Buffer<Index> first(n + 1);
  first[0] = 0;
  parallel_for(0, n, kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      Index degree = 0;
      hodt::for_each_neighbour(mesh, outgoing[v], [&](VertexId) { ++degree; });
      first[v + 1] = degree;
    }
  });
  std::partial_sum(first.begin(), first.end(), first.begin());
  Buffer<VertexId> neighbours(first[n]);
  parallel_for(0, n, kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      Index next = first[v];
      hodt::for_each_neighbour(mesh, outgoing[v], [&](VertexId w) { neighbours[next++] = w; });
    }
  });
  first_ = std::move(first);
  neighbours_ = std::move(neighbours);
}

}  // namespace hodt
