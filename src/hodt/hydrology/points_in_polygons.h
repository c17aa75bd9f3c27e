// Which of many points are in which of many polygons.
#pragma once

#include <cstddef>
#include <span>

#include "hodt/base/buffer.h"
#include "hodt/geometry/places.h"

namespace hodt {

struct PointsInPolygons {
  /// Of each point: whether it is in a polygon.
  Buffer<bool> is_inside;
  /// Of each polygon: whether a point is in it.
  Buffer<bool> holds_point;
};

/// Decided in exact arithmetic; a point on a ring is inside (see Polygon). Fast if points that are
/// near in the plane have near numbers: a polygon then costs its corners, the points in it, and the
/// pieces that its rings have in common with runs of such points. All coordinates must be finite.
PointsInPolygons points_in_polygons(std::span<const Point> points,
                                    std::span<const Polygon> polygons);

}  // namespace hodt
