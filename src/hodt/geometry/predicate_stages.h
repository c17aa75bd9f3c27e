// The stages behind predicates.h, one by one. For predicates.h, circle.h, tests and benchmarks.
//
// Notation of the error bounds below. u = 2^-53 is the rounding unit: a sum or difference of
// doubles is off by a factor 1 + e, |e| <= u, and never underflows; a product is off by such a
// factor and also by at most h = 2^-1075. Writing (n) for any product of n factors 1 + e or
// 1/(1 + e): (n) differs from 1 by less than (n + 1/2) u for n < 100.
// Tested by tests/geometry/predicates_test.cpp.
#pragma once

#include <cfloat>
#include <cmath>
#include <limits>

#include "hodt/geometry/point.h"

#ifdef __FAST_MATH__
#error "hodt's predicates are exact only with IEEE arithmetic: do not compile with -ffast-math"
#endif
static_assert(FLT_EVAL_METHOD == 0, "hodt's predicates need doubles that are rounded at each step");
static_assert(std::numeric_limits<double>::is_iec559);

namespace hodt::exact {

/// What a stage returns if it does not decide; else it returns a sign: +1, 0 or -1.
inline constexpr int kUndecided = 2;

// ---- Stage 1: floating point with a bound. ----

/// A rounded determinant, and a bound on how far rounding may have moved it.
struct Filtered {
  double value;
  double bound;

  /// Whether the sign of value is right. Not if anything overflowed: what is infinite or NaN stays
  /// so through sums and products, and ends up in value or in bound.
  bool certain() const {
    const double size = std::fabs(value);
    return size > bound && size <= DBL_MAX;
  }
};

/// orient as left - right.
//
// Bound. Both products are of two differences, so each is off by (3) and h. Their exact difference
// is then off by less than 3.5 u (|left| + |right|) + 3 h, and the last subtraction changes no
// sign. 4 u leaves room for the roundings of the bound itself, and DBL_MIN is far above all h's.
inline Filtered orient_rounded(const Point& a, const Point& b, const Point& c) {
  constexpr double kRelative = 4 * 0x1p-53;
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  return {left - right, kRelative * (std::fabs(left) + std::fabs(right)) + DBL_MIN};
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

  /// f(p): negative inside.
  Filtered operator()(const Point& p) const {
    const double x = p.x - a_.x, y = p.y - a_.y;
    const double r = x * x + y * y;
    return {d_ * r + (p_ * x + q_ * y), bound_ + bound_per_r_ * r};
  }

  /// The numbers behind it, for loops over many points.
  const Point& origin() const { return a_; }
  double per_r() const { return d_; }
  double per_x() const { return p_; }
  double per_y() const { return q_; }
  double bound() const { return bound_; }
  double bound_per_r() const { return bound_per_r_; }

 private:
  Point a_;
  double d_, p_, q_;
  double bound_, bound_per_r_;
};

/// What several of them, all of which have to be positive, tell together. Without branches, for
/// loops over many.
class AllPositive {
 public:
  void add(const Filtered& f) {
    const double l = f.value - f.bound, h = f.value + f.bound;
    low_ = l < low_ ? l : low_;
    high_ = h < high_ ? h : high_;
    size_ += std::fabs(f.value);
  }
  bool is_certain() const { return (low_ > 0) & is_finite(); }
  bool is_impossible() const { return (high_ < 0) & is_finite(); }

 private:
  bool is_finite() const { return size_ <= DBL_MAX; }

  double low_ = DBL_MAX, high_ = DBL_MAX;  // the least of them is between these
  double size_ = 0;                        // infinite or not a number if any of them is
};

// ---- Stage 2: ties of the kind that rasters are full of. ----

/// Whether the four points are the corners of a rectangle with sides along the axes, in any order:
/// then they are on a circle.
bool is_rectangle(const Point& a, const Point& b, const Point& c, const Point& d);

/// The sign, if f is exact: if all coordinates are multiples of one power of two, and the
/// differences are not too many units (for in_circle some thousands, for orient some ten millions).
/// REQUIRES that f is orient_rounded(a, b, c), or CircleFilter(a, b, c)(d).
int orient_lattice(Filtered f, const Point& a, const Point& b, const Point& c);
int in_circle_lattice(Filtered f, const Point& a, const Point& b, const Point& c, const Point& d);

// ---- Stage 3: integers of fixed width. ----

/// The sign, if all coordinates are multiples of one power of two that is at least 2^-60 times the
/// largest, and the largest is below 2^61. So whenever the smallest is at least 2^-8 of the
/// largest.
int orient_fixed(const Point& a, const Point& b, const Point& c);
int in_circle_fixed(const Point& a, const Point& b, const Point& c, const Point& d);

// ---- Stage 4: floating point of far more range, with a tighter bound. ----

/// The sign, if rounding leaves no doubt; for what has too wide a range for stage 3. Decides
/// nothing where a long double is no wider than a double.
int orient_long(const Point& a, const Point& b, const Point& c);
int in_circle_long(const Point& a, const Point& b, const Point& c, const Point& d);

// ---- Stage 5: integers of any width. Always decides. ----

int orient_big(const Point& a, const Point& b, const Point& c);
int in_circle_big(const Point& a, const Point& b, const Point& c, const Point& d);

// ---- Stages 2 to 5 in turn, for what the filter left, and the perturbation. ----
// f is as in stage 2.

int orient_after_filter(Filtered f, const Point& a, const Point& b, const Point& c);
int in_circle_plain_after_filter(Filtered f, const Point& a, const Point& b, const Point& c,
                                 const Point& d);
bool in_circle_after_filter(Filtered f, const Point& a, const Point& b, const Point& c,
                            const Point& d);

/// Whether d is inside once the lifts are raised (see predicates.h).
/// REQUIRES in_circle_plain(a, b, c, d) == 0; rectangle_tie also is_rectangle(a, b, c, d).
bool in_circle_tie(const Point& a, const Point& b, const Point& c, const Point& d);
bool rectangle_tie(const Point& a, const Point& b, const Point& c, const Point& d);

}  // namespace hodt::exact
