// How small the largest degree of a triangulation of order k can be at best.
// Tested by tests/optimize/minimize_degree_test.cpp.
#pragma once

#include "hodt/base/deadline.h"
#include "hodt/order/delaunay_graph.h"

namespace hodt {

/// No triangulation of the order has a smaller largest degree. The triangles at a vertex are valid,
/// and go once around it (at the hull, from side to side): the fewest that do are a bound for its
/// degree, alone. `known`: some bound. Throws TimeIsUp if the deadline passes before there can be a
/// better one; then ends with what is proven.
Index degree_bound(const DelaunayGraph& graph, Index order, Index known,
                   const Deadline& deadline = {});

}  // namespace hodt
