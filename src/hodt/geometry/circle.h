// A circle that is fixed once and then asked about many points.
#pragma once

#include "hodt/geometry/point.h"
#include "hodt/geometry/predicates.h"

namespace hodt {

/// The circle through a, b and c, as its plane in lifted space: a question costs a handful of
/// flops, and more only where rounding could change the answer. Same answers as in_circle.
class Circle {
 public:
  /// REQUIRES orient(a, b, c) > 0.
  Circle(const Point& a, const Point& b, const Point& c) : filter_(a, b, c), a_(a), b_(b), c_(c) {}

  /// in_circle(a, b, c, p): whether p is inside, with the perturbation. False for a, b and c.
  bool contains(const Point& p) const {
    const exact::Filtered f = filter_(p);
    if (f.certain()) [[likely]]
      return f.value < 0;
    return exact::in_circle_after_filter(f, a_, b_, c_, p);
  }

  /// in_circle_plain(a, b, c, p): +1 strictly inside, 0 on the circle, -1 outside.
  int side_plain(const Point& p) const {
    const exact::Filtered f = filter_(p);
    if (f.certain()) [[likely]]
      return f.value < 0 ? 1 : -1;
    return exact::in_circle_plain_after_filter(f, a_, b_, c_, p);
  }

  /// Its plane, for loops over many points.
  const exact::CircleFilter& filter() const { return filter_; }

 private:
  exact::CircleFilter filter_;
  Point a_, b_, c_;
};

}  // namespace hodt
