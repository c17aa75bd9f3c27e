// The points that are nearest to places.
#pragma once

#include <span>
#include <vector>

#include "hodt/base/ids.h"
#include "hodt/geometry/point.h"

namespace hodt {

/// For each place the nearest of the points, the first of these if several are as near, by
/// distances rounded to doubles. Fast if points that are near in the plane have near numbers.
/// Requires a point, and that all coordinates are finite.
std::vector<VertexId> nearest_points(std::span<const Point> points, std::span<const Point> places);

}  // namespace hodt
