// Directions from a point.
// Tested by tests/order/constrained_delaunay_test.cpp.
#pragma once

#include "hodt/geometry/predicates.h"

namespace hodt {

/// Whether p and q are in the same direction from a third point: on one line with it, on one side.
/// REQUIRES that neither is that point.
inline bool is_same_direction(const Point& from, const Point& p, const Point& q) {
  return orient(from, p, q) == 0 &&
         lexicographically_less(from, p) == lexicographically_less(from, q);
}

}  // namespace hodt
