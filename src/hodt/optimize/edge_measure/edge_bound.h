// How good a triangulation of order k can be at best for a measure across edges.
// Tested by tests/optimize/optimize_measure_test.cpp.
#pragma once

#include "hodt/base/deadline.h"
#include "hodt/mesh/triangle_mesh.h"
#include "hodt/optimize/measure/edge_measures.h"
#include "hodt/order/delaunay_graph.h"

namespace hodt {

struct EdgeBound {
  /// No triangulation of that order is better.
  double bound;
  /// One that is good by what the triangles were charged with: where to look for a good one.
  TriangleMesh mesh;
};

/// What an edge costs between two triangles is charged to the two in parts, such that no pair is
/// charged with more than it costs. So any triangulation costs at least what its triangles are
/// charged with, and the least of that is found face by face. Where a triangle could be charged
/// with less for that, others are charged with more, in rounds, of sums. `is_thorough`: for far
/// longer. `at_hand`: the value of some triangulation of that order. The deadline ends it with what
/// is proven; throws TimeIsUp if that is nothing.
EdgeBound bound_across_edges(const DelaunayGraph& graph, const EdgeValues& values, Index order,
                             double at_hand, const Deadline& deadline, bool is_thorough);

}  // namespace hodt
