// Where the circles through two points pass a third one.
// Tested by tests/order/edges_test.cpp.
#pragma once

#include <cmath>

#include "hodt/geometry/point.h"

namespace hodt {

/// The circles through u and v, from the half-plane on the right of u -> v to the one on the left,
/// pass the points beside the line in the order of their places: the cotangents of the angles that
/// they see uv at. Rounded, by less than the error.
struct Passing {
  double place, error;

  /// REQUIRES that p is not on the line uv.
  static Passing of(const Point& u, const Point& v, const Point& p) {
    constexpr double kSlack = 64 * 0x1p-53, kTiny = 1e-290;
    const double qx = v.x - u.x, qy = v.y - u.y, qq = qx * qx + qy * qy;
    const double x = p.x - u.x, y = p.y - u.y, r = x * x + y * y;
    const double cross = qx * y - qy * x, place = (r - (qx * x + qy * y)) / cross;
    return {place, kSlack * ((qq + r) + kTiny) * (1 + std::fabs(place)) / std::fabs(cross)};
  }

  bool is_surely_before(const Passing& other) const {
    return place + error < other.place - other.error;
  }
};

}  // namespace hodt
