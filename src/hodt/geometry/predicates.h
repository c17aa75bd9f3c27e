// Exact orientation and in-circle tests for every finite double: no tolerance, no range error.
//
// REQUIRES finite coordinates, rounding to nearest, no flushing of denormals to zero.
//
// Laws. All hold exactly, for any points that meet the requirements:
//
//  (1) orient(a, b, c) == orient(b, c, a) == -orient(b, a, c).
//  (2) orient(a, b, c) == 0 if and only if a, b, c lie on a line (so also if two are equal).
//  (3) in_circle_plain and in_circle do not change when a, b, c are rotated.
//  (4) in_circle(a, b, c, d) == (in_circle_plain(a, b, c, d) > 0) unless the latter is 0.
//  (5) in_circle(a, b, c, d) is false if d equals a, b or c.
//  (6) The triangles abc and dcb, on both sides of bc: in_circle(a, b, c, d) ==
//      in_circle(d, c, b, a). If abdc is strictly convex also: in_circle(a, b, c, d) !=
//      in_circle(a, b, d, c). So of the two triangulations of a convex quadrilateral, exactly one
//      is Delaunay, also if its corners are cocircular.
//
// The perturbation behind in_circle: d is inside the circle abc if its lift z = x² + y² is below
// the plane through the lifts of a, b and c. Raise the lift of each point p by an infinitesimal
// e(p) > 0, where e(p) is infinitely larger than e(q) if p is lexicographically larger than q. With
// the barycentric coordinates d = α a + β b + γ c, the plane rises at d by α e(a) + β e(b) + γ e(c)
// and the lift of d by e(d). If they were level, the lexicographically largest of the four decides:
//
//  (7) if it is d, then d is now above: outside;
//  (8) if it is a, then d is inside if and only if α > 0, that is, orient(d, b, c) > 0; likewise
//      orient(a, d, c) > 0 for b and orient(a, b, d) > 0 for c. None of these is 0, because no line
//      meets a circle in three points.
#pragma once

#include "hodt/geometry/point.h"
#include "hodt/geometry/predicate_stages.h"

namespace hodt {

/// +1 if a, b, c turn left (counter-clockwise), -1 if they turn right, 0 if they lie on a line.
inline int orient(const Point& a, const Point& b, const Point& c) {
  const exact::Filtered f = exact::orient_rounded(a, b, c);
  if (f.certain()) [[likely]]
    return f.value > 0 ? 1 : -1;
  return exact::orient_after_filter(f, a, b, c);
}

/// Whether d is inside the circle through a, b, c: the plain definition.
/// REQUIRES orient(a, b, c) > 0. +1 strictly inside, 0 on the circle, -1 outside.
inline int in_circle_plain(const Point& a, const Point& b, const Point& c, const Point& d) {
  const exact::Filtered f = exact::CircleFilter(a, b, c)(d);
  if (f.certain()) [[likely]]
    return f.value < 0 ? 1 : -1;
  return exact::in_circle_plain_after_filter(f, a, b, c, d);
}

/// The same with the perturbation: never undecided.
/// REQUIRES orient(a, b, c) > 0.
inline bool in_circle(const Point& a, const Point& b, const Point& c, const Point& d) {
  const exact::Filtered f = exact::CircleFilter(a, b, c)(d);
  if (f.certain()) [[likely]]
    return f.value < 0;
  return exact::in_circle_after_filter(f, a, b, c, d);
}

}  // namespace hodt
