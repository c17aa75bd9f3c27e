// Which part of a terrain to show.
// Tested by tests/picture/picture_test.cpp.
#pragma once

#include <span>

#include "hodt/geometry/point.h"

namespace hodt {

/// An axis-parallel rectangle.
struct Window {
  Point low, high;

  double width() const { return high.x - low.x; }
  double height() const { return high.y - low.y; }
  Point middle() const { return {low.x + width() / 2, low.y + height() / 2}; }
  bool contains(const Point& p) const {
    return low.x <= p.x && p.x <= high.x && low.y <= p.y && p.y <= high.y;
  }
  bool meets(const Window& other) const {
    return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y &&
           other.low.y <= high.y;
  }
  void include(const Point& p);
};

/// Requires points not empty.
Window bounding_box(std::span<const Point> points);

/// The square window of side `side` with most of the `targets` well inside, away from the outline
/// of `points` as far as the side leaves room; without targets, the middle. Does not depend on the
/// order of either.
/// Requires points not empty.
Window best_window(std::span<const Point> points, std::span<const Point> targets, double side);

}  // namespace hodt
