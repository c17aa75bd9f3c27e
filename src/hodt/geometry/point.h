// A point of the plane, the order that breaks every tie, and a box of points.
// Tested by tests/hydrology/points_in_polygons_test.cpp.
#pragma once

#include <algorithm>
#include <span>

namespace hodt {

struct Point {
  double x = 0;
  double y = 0;

  friend bool operator==(const Point&, const Point&) = default;
};

/// Lexicographic order by (x, y): the order of the perturbation (see predicates.h).
inline bool lexicographically_less(const Point& a, const Point& b) {
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

/// All points with low.x <= x <= high.x and low.y <= y <= high.y.
struct Box {
  Point low;
  Point high;
};

/// The least box that contains both.
inline Box joined(const Box& a, const Box& b) {
  return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
          {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}

/// The least box that contains all the points. REQUIRES one.
inline Box box_of(std::span<const Point> points) {
  Box box{points[0], points[0]};
  for (const Point& p : points) box = joined(box, {p, p});
  return box;
}

/// Whether they have a point in common.
inline bool meet(const Box& a, const Box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

/// Whether all of b is in a.
inline bool contains(const Box& a, const Box& b) {
  return a.low.x <= b.low.x && b.high.x <= a.high.x && a.low.y <= b.low.y && b.high.y <= a.high.y;
}

}  // namespace hodt
