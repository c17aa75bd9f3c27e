// The stages in turn, cheapest first.
#include "hodt/geometry/predicates.h"

namespace hodt::exact {

int orient_after_filter(Filtered f, const Point& a, const Point& b, const Point& c) {
  if (const int sign = orient_lattice(f, a, b, c); sign != kUndecided) return sign;
  if (const int sign = orient_fixed(a, b, c); sign != kUndecided) return sign;
  if (const int sign = orient_long(a, b, c); sign != kUndecided) return sign;
  return orient_big(a, b, c);
}

namespace {

/// What is left once rectangles are out of the way.
int in_circle_plain_not_rectangle(Filtered f, const Point& a, const Point& b, const Point& c,
                                  const Point& d) {
  if (const int sign = in_circle_lattice(f, a, b, c, d); sign != kUndecided) return sign;
  if (const int sign = in_circle_fixed(a, b, c, d); sign != kUndecided) return sign;
  if (const int sign = in_circle_long(a, b, c, d); sign != kUndecided) return sign;
  return in_circle_big(a, b, c, d);
}

}  // namespace

int in_circle_plain_after_filter(Filtered f, const Point& a, const Point& b, const Point& c,
                                 const Point& d) {
  return is_rectangle(a, b, c, d) ? 0 : in_circle_plain_not_rectangle(f, a, b, c, d);
}

bool in_circle_after_filter(Filtered f, const Point& a, const Point& b, const Point& c,
                            const Point& d) {
  if (is_rectangle(a, b, c, d)) return rectangle_tie(a, b, c, d);
  const int sign = in_circle_plain_not_rectangle(f, a, b, c, d);
  return sign != 0 ? sign > 0 : in_circle_tie(a, b, c, d);
}

}  // namespace hodt::exact
