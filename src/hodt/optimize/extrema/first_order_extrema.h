// Theorem 4: the fewest local extrema that a triangulation of order 1 can have.
#pragma once

#include <span>

#include "hodt/optimize/extrema/extrema_solution.h"
#include "hodt/order/delaunay_graph.h"

namespace hodt {

/// Minimises local minima and maxima together over all triangulations of order 1. Exact. O(n).
ExtremaSolution minimize_first_order_extrema(const DelaunayGraph& graph, std::span<const double> z);

}  // namespace hodt
