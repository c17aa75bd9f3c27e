// The structure of first-order Delaunay triangulations (Section 4 of the paper).
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "hodt/order/delaunay_graph.h"

namespace hodt {

/// Whether the Delaunay edge of h is crossed by a useful edge of order 1: then its quadrilateral is
/// convex, and either diagonal may be chosen whatever is chosen elsewhere (Lemma 5, Corollary 3).
/// All other edges are fixed: they are in every triangulation of order 1.
bool is_first_order_flippable(const DelaunayGraph& graph, HalfEdgeId h);

/// Moves those of the edges that are wanted to the front, in their order, and returns how many they
/// are. Several threads may call it at once.
using KeepWanted = std::function<std::size_t(std::span<HalfEdgeId>)>;

/// The flippable edges, one half-edge each (the smaller of the two), ascending; of these the ones
/// that are wanted, which is asked about all that nearby points leave possible, as to count circles
/// costs more. The circles of what each flip makes have been counted, each by itself. O(n).
std::vector<HalfEdgeId> first_order_edges(const DelaunayGraph& graph,
                                          const KeepWanted& keep_wanted = {});

}  // namespace hodt
