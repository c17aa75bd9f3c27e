// Edges released where they force too high an order together.
// Tested by tests/optimize/remove_extrema_test.cpp.
#pragma once

#include "hodt/optimize/extrema/extrema_triangulation.h"
#include "hodt/order/delaunay_graph.h"

namespace hodt {

/// Useful edges that do not cross can force a higher order together (Gudmundsson, Haverkort and van
/// Kreveld), which is rare. Releases the locked edge nearest to each triangle of more than `order`
/// points, until there is no such triangle. Throws TimeIsUp if the deadline passes, and leaves a
/// triangulation of no use then.
void release_where_order_is_too_high(const DelaunayGraph& graph, Index order,
                                     const Deadline& deadline, ExtremaTriangulation& triangulation);

}  // namespace hodt
