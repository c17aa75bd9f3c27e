// A point of the plane, the order that breaks every tie, and a box of points.
#pragma once

#include <algorithm>

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

}  // namespace hodt
