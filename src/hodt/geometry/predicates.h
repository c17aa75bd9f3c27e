// Exact orientation and in-circle tests for every finite double.
#pragma once

#include "hodt/geometry/point.h"

namespace hodt {

/// +1 if a, b, c turn left (counter-clockwise), -1 if they turn right, 0 if they lie on a line.
int orient(const Point& a, const Point& b, const Point& c);

/// Whether d is inside the circle through a, b, c: the plain definition.
/// Requires orient(a, b, c) > 0. +1 strictly inside, 0 on the circle, -1 outside.
int in_circle_plain(const Point& a, const Point& b, const Point& c, const Point& d);

/// The same with the perturbation: never 0 for four distinct points.
bool in_circle(const Point& a, const Point& b, const Point& c, const Point& d);

}  // namespace hodt
