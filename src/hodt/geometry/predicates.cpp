#include "hodt/geometry/predicates.h"

#include <optional>

namespace hodt::exact {

namespace {

/// Whether p, q and o continue the corner d of a rectangle: p above or below it, q beside it, o
/// opposite.
bool is_rectangle_at(const Point& d, const Point& p, const Point& q, const Point& o) {
  return p.x == d.x && q.y == d.y && o.x == q.x && o.y == p.y;
}

}  // namespace

bool is_rectangle(const Point& a, const Point& b, const Point& c, const Point& d) {
  return is_rectangle_at(d, a, b, c) || is_rectangle_at(d, a, c, b) ||
         is_rectangle_at(d, b, a, c) || is_rectangle_at(d, b, c, a) ||
         is_rectangle_at(d, c, a, b) || is_rectangle_at(d, c, b, a);
}

int orient_after_filter(const Point& a, const Point& b, const Point& c) {
  if ((a.x == b.x && b.x == c.x) || (a.y == b.y && b.y == c.y)) return 0;
  if (const std::optional<int> sign = orient_fixed(a, b, c)) return *sign;
  return orient_big(a, b, c);
}

int in_circle_plain_after_filter(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (is_rectangle(a, b, c, d)) return 0;
  if (const std::optional<int> sign = in_circle_fixed(a, b, c, d)) return *sign;
  return in_circle_big(a, b, c, d);
}

bool in_circle_after_filter(const Point& a, const Point& b, const Point& c, const Point& d) {
  const int sign = in_circle_plain_after_filter(a, b, c, d);
  return sign != 0 ? sign > 0 : in_circle_tie(a, b, c, d);
}

bool in_circle_tie(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (d == a || d == b || d == c) return false;
  const bool a_over_b = lexicographically_less(b, a);
  const Point& ab = a_over_b ? a : b;
  const bool c_over_ab = lexicographically_less(ab, c);
  if (lexicographically_less(c_over_ab ? c : ab, d)) return false;
  if (c_over_ab) return orient(a, b, d) > 0;
  return a_over_b ? orient(d, b, c) > 0 : orient(a, d, c) > 0;
}

}  // namespace hodt::exact
