// Whether places can be on the map of some points at all, or are in another coordinate system.
#pragma once

#include <span>

#include "hodt/base/buffer.h"
#include "hodt/geometry/places.h"

namespace hodt {

/// Throws InputError, naming the part of the source that is wrong, if a place is farther from the
/// points' box than that is wide or high, if a polygon lies outside the box, if a ring has fewer
/// than three corners, or if a coordinate is not finite. Requires a point.
void check_places(const Places& places, std::span<const Point> points);

/// Throws InputError if there are polygons, and none of them holds a point.
void check_polygons_hold_points(const Places& places, const Buffer<bool>& holds_point);

}  // namespace hodt
