// Which part of a terrain to show. Internal to this layer.
// Tested by tests/picture/picture_test.cpp.
#pragma once

#include <span>

#include "hodt/geometry/point.h"

namespace hodt {

/// An axis-parallel square.
struct Window {
  Point south_west;
  double side = 0;

  bool contains(const Point& p) const {
    return south_west.x <= p.x && p.x <= south_west.x + side && south_west.y <= p.y &&
           p.y <= south_west.y + side;
  }
};

/// The window of side `side` with most of the `targets` well inside, away from the outline of
/// `points` as far as the side leaves room; without targets, the middle. Does not depend on the
/// order of either.
/// Requires points not empty.
Window best_window(std::span<const Point> points, std::span<const Point> targets, double side);

}  // namespace hodt
