// Triangulations of order k whose largest vertex degree is small.
#pragma once

#include "hodt/base/deadline.h"
#include "hodt/optimize/measure_problem.h"
#include "hodt/order/delaunay_graph.h"

namespace hodt {

/// Order 1 (instead of Theorem 6): for one degree D after another, from a lower bound upward,
/// either the diagonals are chosen so that no vertex has more, or that is proven impossible. Only
/// quadrilaterals at vertices that could have more than D matter; they fall into small parts, each
/// searched with propagation, to the end nearly always. Then the result is optimal; where the
/// search is given up, the bound stays at what was proven. Above order 1: flips from there, and the
/// larger of the average degree and of the fixed edges at a vertex as bound.
MeasuredSolution minimize_degree(const DelaunayGraph& graph, Index order, const Deadline& deadline);

}  // namespace hodt
