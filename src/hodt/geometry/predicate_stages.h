// The stages behind predicates.h, one by one. For predicates.h, circle.h, tests and benchmarks.
//
// Notation of the error bounds below. u = 2^-53 is the rounding unit: a sum or difference of
// doubles is off by a factor 1 + e, |e| <= u, and never underflows; a product is off by such a
// factor and also by at most h = 2^-1075. Writing (n) for any product of n factors 1 + e or
// 1/(1 + e): (n) differs from 1 by less than (n + 1/2) u for n < 100.
#pragma once

#include <cfloat>
#include <cmath>
#include <limits>
#include <optional>

#include "hodt/geometry/point.h"

#ifdef __FAST_MATH__
#error "hodt's predicates are exact only with IEEE arithmetic: do not compile with -ffast-math"
#endif
static_assert(FLT_EVAL_METHOD == 0, "hodt's predicates need doubles that are rounded at each step");
static_assert(std::numeric_limits<double>::is_iec559);

namespace hodt::exact {

// ---- Stage 1: floating point with a bound. 0 means undecided. ----

/// The sign of orient, or 0 if rounding errors hide it.
//
// Bound. Both products are of two differences, so each is off by (3) and h. Their exact difference
// is then off by less than 3.5 u (|left| + |right|) + 3 h, and the last subtraction changes no
// sign. 4 u leaves room for the roundings of the bound itself, and DBL_MIN is far above all h's.
// An overflow anywhere ends in a bound that is infinite or NaN, and no number exceeds that.
inline int orient_filter(const Point& a, const Point& b, const Point& c) {
  constexpr double kRelative = 4 * 0x1p-53;
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double det = left - right;
  const double bound = kRelative * (std::fabs(left) + std::fabs(right)) + DBL_MIN;
  if (std::fabs(det) > bound) [[likely]]
    return det > 0 ? 1 : -1;
  return 0;
}

/// A circle as the plane through its three lifted points, rounded, with a bound on the rounding.
//
// With B = b - a, C = c - a, p - a = (x, y) and r = x² + y², the point p lies below the plane
// through the lifted a, b and c (that is, inside the circle) exactly if f(p) < 0 for
//
//   f(p) = D r + P x + Q y,   D = B × C,   P = By |C|² - |B|² Cy,   Q = |B|² Cx - Bx |C|².
//
// Bound. Expanded, f is a sum of terms like Bx Cy x² or By Cx² x. Each is computed from differences
// (1 rounding each) and goes through at most 11 roundings: By |C|² is off by (1 + 4 + 1), P by (7),
// P x by (9), the two sums of f make it (11). So f is off by less than 11.5 u S + underflow, where
//
//   S = (|Bx Cy| + |By Cx|) r + (|By| |C|² + |B|² |Cy|) |x| + (|B|² |Cx| + |Bx| |C|²) |y|
//    <= |B| |C| r + |B| |C|² |p-a| + |B|² |C| |p-a|          by Cauchy-Schwarz, three times
//    <= |B|² |C|² + (|B|² + |C|²) r                          by 2 s t <= s² + t², three times.
//
// So the bound needs no absolute values, only the squared lengths, which are at hand. It is itself
// off by at most (12): 12 u in place of 11.5 u covers that.
// Underflow adds less than 20 h (1 + |B|² + |C|² + r). Adding kTiny to |B|² and |C|² adds to the
// bound at least 12 u kTiny (|B|² + |C|² + r + kTiny), which is much more; it matters to circles
// smaller than 1e-75 only.
// Overflow: if f and the bound are finite, so is everything that went into them.
class CircleFilter {
 public:
  CircleFilter(const Point& a, const Point& b, const Point& c) : a_(a) {
    constexpr double kRelative = 12 * 0x1p-53;
    constexpr double kTiny = 0x1p-500;
    const double bx = b.x - a.x, by = b.y - a.y;
    const double cx = c.x - a.x, cy = c.y - a.y;
    const double bb = bx * bx + by * by;
    const double cc = cx * cx + cy * cy;
    d_ = bx * cy - by * cx;
    p_ = by * cc - bb * cy;
    q_ = bb * cx - bx * cc;
    bound_ = kRelative * ((bb + kTiny) * (cc + kTiny));
    bound_per_r_ = kRelative * ((bb + kTiny) + (cc + kTiny));
  }

  /// The rounded f(p) if its sign is certain, else 0.
  double certain(const Point& p) const {
    const double x = p.x - a_.x, y = p.y - a_.y;
    const double r = x * x + y * y;
    const double f = d_ * r + (p_ * x + q_ * y);
    const double size = std::fabs(f);
    return size > bound_ + bound_per_r_ * r && size <= DBL_MAX ? f : 0;
  }

 private:
  Point a_;
  double d_, p_, q_;
  double bound_, bound_per_r_;
};

/// The sign of in_circle_plain, or 0 if rounding errors hide it.
inline int in_circle_filter(const Point& a, const Point& b, const Point& c, const Point& d) {
  const double f = CircleFilter(a, b, c).certain(d);
  return (f < 0) - (f > 0);
}

// ---- Stage 2: ties of the kind that rasters are full of, and integers of fixed width. ----

/// Whether the four points are the corners of a rectangle with sides along the axes, in any order:
/// then they are on a circle.
bool is_rectangle(const Point& a, const Point& b, const Point& c, const Point& d);

/// The sign, if all coordinates are multiples of one power of two that is at least 2^-60 times the
/// largest, and the largest is below 2^61. So for all coordinates between 2^-8 and 1 of the
/// largest.
std::optional<int> orient_fixed(const Point& a, const Point& b, const Point& c);
std::optional<int> in_circle_fixed(const Point& a, const Point& b, const Point& c, const Point& d);

// ---- Stage 3: integers of any width. Always decides. ----

int orient_big(const Point& a, const Point& b, const Point& c);
int in_circle_big(const Point& a, const Point& b, const Point& c, const Point& d);

// ---- Stages 2 and 3 in turn, for what the filter left, and the perturbation. ----

int orient_after_filter(const Point& a, const Point& b, const Point& c);
int in_circle_plain_after_filter(const Point& a, const Point& b, const Point& c, const Point& d);
bool in_circle_after_filter(const Point& a, const Point& b, const Point& c, const Point& d);

/// Whether d is inside once the lifts are raised (see predicates.h).
/// Requires in_circle_plain(a, b, c, d) == 0.
bool in_circle_tie(const Point& a, const Point& b, const Point& c, const Point& d);

}  // namespace hodt::exact
