// k-OD triangles where there are walls.
// Tested by tests/order/constrained_order_test.cpp.
#pragma once

#include <array>
#include <vector>

#include "hodt/order/circle_counter.h"
#include "hodt/order/edge_lists.h"

namespace hodt {

/// The sides that k-OD triangles can have: k-OD edges, and several of them in a line, as other
/// vertices may lie on a side. (Of a triangle of order k each piece of a side has an order of k or
/// less: it is in a smaller circle, inside that of the triangle. What it reaches there, the
/// triangle does.)
std::vector<EdgeRecord> sides_of_open_triangles(const DelaunayGraph& graph, Index k,
                                                const Numbering& numbering,
                                                const Deadline& deadline);

/// The number of vertices inside the circle that are reached from the triangle, counter-clockwise,
/// or limit + 1 if there are more, and if a wall enters the triangle or it is outside of the
/// domain. REQUIRES sides of that kind.
Index order_if_open(CircleCounter& counter, const DelaunayGraph& graph,
                    const std::array<VertexId, 3>& corners, Index limit);

}  // namespace hodt
