// Edges as lists, one for each vertex.
// Tested by tests/order/triangles_test.cpp.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hodt/order/edges.h"
#include "hodt/order/numbering.h"

namespace hodt {

/// Vertices go by their places in the order of their numbers.
class EdgeLists {
 public:
  struct End {
    Index to, order;
  };

  /// The edges by the ids of their ends.
  EdgeLists(std::span<const EdgeRecord> edges, const Numbering& numbering);

  std::size_t size() const { return first_.size() - 1; }
  /// Those at a vertex, to both smaller and larger ones, sorted.
  std::span<const End> of(Index place) const {
    return {ends_.data() + first_[place], ends_.data() + first_[place + 1]};
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<End> ends_;
};

/// All edges of a class, with the ids of their ends.
std::vector<EdgeRecord> all_edges(const DelaunayGraph& graph, EdgeClass edge_class, Index k,
                                  const Deadline& deadline);

}  // namespace hodt
