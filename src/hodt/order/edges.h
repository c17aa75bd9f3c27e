// All edges of a class, with their orders, as a stream.
#pragma once

#include <functional>
#include <span>

#include "hodt/base/deadline.h"
#include "hodt/order/delaunay_graph.h"
#include "hodt/order/numbering.h"

namespace hodt {

enum class EdgeClass {
  useful,    ///< in some triangulation of order k; by useful order
  kod,       ///< with a circle through its ends that holds at most k points; by the fewest. With
             ///< walls: that holds at most k points which are reached from the edge
  fixed,     ///< useful, and crossed by no other useful edge: in every triangulation of order k;
             ///< all of useful order 0
  delaunay,  ///< useful order 0, whatever k is
};

/// An edge by the numbers of its ends.
struct EdgeRecord {
  Index u, v;
  Index order;
  friend bool operator==(const EdgeRecord&, const EdgeRecord&) = default;
};

/// Passes all edges of the class and of order at most k to the sink, in pieces; a piece can be
/// empty. Vertices go by their ids, u is lexicographically smaller than v, and the edges come
/// sorted by u and then v. Memory does not grow with their number (but for `fixed`: a byte a
/// half-edge). The same pieces on any number of threads. Of a graph with listed neighbours it is
/// faster. Throws TimeIsUp if the deadline passes.
void for_each_edge(const DelaunayGraph& graph, EdgeClass edge_class, Index k,
                   const std::function<void(std::span<const EdgeRecord>)>& sink,
                   const Deadline& deadline = {});

/// The same with vertices by their numbers, u < v, sorted by these. Useful edges take longer, as
/// they are found from both ends.
void for_each_edge(const DelaunayGraph& graph, EdgeClass edge_class, Index k,
                   const Numbering& numbering,
                   const std::function<void(std::span<const EdgeRecord>)>& sink);

}  // namespace hodt
