// The vertices that had better be no extrema, and the edges that would help them.
// Tested by tests/optimize/remove_extrema_test.cpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hodt/base/buffer.h"
#include "hodt/base/deadline.h"
#include "hodt/base/parallel.h"
#include "hodt/geometry/heights.h"
#include "hodt/order/useful_edges.h"

namespace hodt {

/// An extremum, of the Delaunay triangulation or of another, and the useful edges that remove it.
struct Target {
  VertexId vertex;
  Extremum kind = Extremum::minimum;
  std::vector<UsefulEdge> edges;  // by order; Delaunay edges have order 0
  std::size_t offered = 16;       // so many of them, the first, are up for choice
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
  /// Offers more edges of these targets, and finds all if those known are offered. Whether there
  /// was more to do. Few targets need more than the first: what crosses what, of thousands of
  /// edges, would take long.
  bool offer_more_edges(const std::vector<Index>& targets);

  std::span<const UsefulEdge> offered(const Target& target) const {
    return {target.edges.data(), std::min(target.offered, target.edges.size())};
  }
  /// All its edges are offered.
  bool is_complete(const Target& target) const {
    return is_searched(target) && target.offered >= target.edges.size();
  }
  /// How many have no edge that removes them: these stay, whatever is chosen.
  std::size_t hopeless() const;

 private:
  void search_up_to(UsefulEdgeSearch& search, Target& target, Index order) const;
  void search_all_up_to(UsefulEdgeSearch& search, Target& target, Index order) const;
  bool is_searched(const Target& target) const { return target.searched >= order_; }
  bool needs_search(const Target& target) const { return !is_searched(target) && !target.given_up; }

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
