// A point of the plane, and the order that breaks every tie.
#pragma once

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

}  // namespace hodt
