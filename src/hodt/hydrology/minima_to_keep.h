// Which local minima are real, and stay.
#pragma once

#include <span>
#include <vector>

#include "hodt/base/buffer.h"
#include "hodt/order/delaunay_graph.h"

namespace hodt {

/// A flag for every vertex: the local minima of the Delaunay triangulation that are at least
/// `min_depth` deep (see pit_depths.h; 0: none for its depth), that one of the outlines contains,
/// or that the vertex nearest to one of the places drains to.
Buffer<bool> minima_to_keep(const DelaunayGraph& graph, std::span<const double> z, double min_depth,
                            std::span<const Point> places,
                            std::span<const std::vector<Point>> outlines);

}  // namespace hodt
