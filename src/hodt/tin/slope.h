// How steep a triangle is, and which way it faces.
#pragma once

#include <optional>

#include "hodt/geometry/point.h"

namespace hodt {

struct Slope {
  double slope = 0;  ///< of the plane against the map, in degrees from 0 up to 90
  /// Where water runs: the direction of steepest descent in degrees from north (+y), clockwise,
  /// from 0 up to 360. Empty where the plane is level.
  std::optional<double> aspect;
};

/// A vector that stands on a plane, upwards: its horizontal part is `height` times (east, north),
/// its vertical one `width` times `up`. The factors keep apart what a product would take out of a
/// double's range.
struct Normal {
  double east, north, up;  ///< each of size 2 or less
  double width, height;
};

/// Of the plane through three places of the map, counter-clockwise, with their heights; these are
/// in units of the map.
Normal normal_of(const Point& a, const Point& b, const Point& c, double za, double zb, double zc);
Slope slope_of(const Point& a, const Point& b, const Point& c, double za, double zb, double zc);

}  // namespace hodt
