// The vertices that had better be no extrema, and the edges that would help them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hodt/base/buffer.h"
#include "hodt/base/deadline.h"
#include "hodt/base/parallel.h"
#include "hodt/optimize/heights.h"
#include "hodt/order/useful_edges.h"

namespace hodt {

/// An extremum, of the Delaunay triangulation or of another, and the useful edges that remove it.
struct Target {
  VertexId vertex;
  Extremum kind = Extremum::minimum;
  std::vector<UsefulEdge> edges;  // by order; Delaunay edges have order 0
  Index searched = 0;             // all edges up to this order are known
  bool given_up = false;          // the search for more was too long
};

class ExtremaTargets {
 public:
  /// `kept`: minima that are to stay, a flag for every vertex.
  ExtremaTargets(const DelaunayGraph& graph, const Heights& heights, const Buffer<bool>& kept,
                 Index order, const Deadline& deadline);

  /// False if it is one already.
  bool add(VertexId v, Extremum kind);
  std::size_t size() const { return targets_.size(); }
  const Target& operator[](Index i) const { return targets_[i]; }

  /// Finds for targets without edges those of the smallest orders: most need no more than these,
  /// and small orders are cheap to search. Larger orders only for those that found none, level by
  /// level, so that a deadline finds the cheap ones done.
  void find_edges();
  /// Finds all edges of these targets. Whether that brought any news.
  bool find_all_edges(const std::vector<Index>& targets);

  /// All its edges are known.
  bool is_complete(const Target& target) const { return target.searched >= order_; }
  /// No triangulation can help it.
  bool is_hopeless(const Target& target) const {
    return target.edges.empty() && is_complete(target);
  }

 private:
  void search_up_to(UsefulEdgeSearch& search, Target& target, Index order) const;
  bool needs_search(const Target& target) const { return !is_complete(target) && !target.given_up; }

  const DelaunayGraph& graph_;
  const Heights heights_;
  const Buffer<bool>& kept_;
  const Index order_;
  const Deadline& deadline_;
  VertexId lowest_{0}, highest_{0};
  Buffer<std::uint8_t> known_;  // of every vertex, what it is a target as: bits
  std::vector<Target> targets_;
  PerThread<UsefulEdgeSearch> searches_;
};

}  // namespace hodt
