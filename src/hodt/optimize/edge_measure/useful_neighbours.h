// The useful edges at every vertex, in little memory.
// Tested by tests/optimize/fan_bound_test.cpp.
#pragma once

#include <cstddef>
#include <span>

#include "hodt/base/buffer.h"
#include "hodt/base/deadline.h"
#include "hodt/order/delaunay_graph.h"

namespace hodt {

/// For every vertex the other ends of its useful edges, those first that have more of them than
/// itself (of equals, a larger number): few have, whatever a vertex is a hub to. 8 bytes an edge
/// and 12 a vertex.
class UsefulNeighbours {
 public:
  /// Throws TimeIsUp if the deadline passes.
  UsefulNeighbours(const DelaunayGraph& graph, Index order, const Deadline& deadline);

  std::span<const Index> of(VertexId v) const {
    return {others_.data() + first_[v], first_[v + 1] - first_[v]};
  }
  /// Of every edge one end has the other one here.
  std::span<const Index> greater_of(VertexId v) const {
    return {others_.data() + first_[v], greater_[v]};
  }

 private:
  Buffer<std::size_t> first_;
  Buffer<Index> greater_;  // how many
  Buffer<Index> others_;
};

}  // namespace hodt
