// How good a triangulation of order k can be at best for a measure across edges, vertex by vertex.
// Tested by tests/optimize/fan_bound_test.cpp.
#pragma once

#include "hodt/base/deadline.h"
#include "hodt/optimize/measure/edge_measures.h"
#include "hodt/order/delaunay_graph.h"

namespace hodt {

/// Around every vertex of a triangulation its triangles form a fan, and each edge between two of
/// them is a spoke of the fans at both of its ends. So the best fans, each chosen by itself from
/// triangles with useful edges, are a bound: of a sum half of their spokes' values. A vertex at a
/// time, in time that grows with the number of useful edges. Throws TimeIsUp if the deadline passes
/// first.
double bound_by_fans(const DelaunayGraph& graph, const EdgeValues& values, Index order,
                     const Deadline& deadline);

}  // namespace hodt
