// Which of some edges cross each other.
#pragma once

#include <span>

#include "hodt/base/csr_lists.h"
#include "hodt/base/deadline.h"
#include "hodt/order/delaunay_graph.h"

namespace hodt {

/// An edge without a vertex between its ends.
struct PlainEdge {
  VertexId u, v;
};

/// For every edge the others that it crosses: that have a point in common with it which is an end
/// of neither. Costs the Delaunay triangles that each passes through, and the pairs that meet in
/// one. Throws TimeIsUp if the deadline passes.
CsrLists crossings(const DelaunayGraph& graph, std::span<const PlainEdge> edges,
                   const Deadline& deadline = {});

}  // namespace hodt
