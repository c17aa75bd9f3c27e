// Stage 4: floating point again, of more digits and far more range.
// Tested by tests/geometry/predicates_test.cpp.
#include <cfloat>
#include <cmath>

#include "hodt/geometry/predicate_stages.h"

namespace hodt::exact {
namespace {

/// Where a long double is an IEEE number with more of both: x86-64, say, or 64-bit ARM on Linux.
constexpr bool kIsWider =
    std::numeric_limits<long double>::is_iec559 && LDBL_MANT_DIG >= 64 && LDBL_MAX_EXP >= 16384;

/// The rounding unit: 2^-64 or less.
constexpr long double kUnit = 0x1p-64L;

struct Offset {
  long double x, y;

  Offset(const Point& from, const Point& to)
      : x(static_cast<long double>(to.x) - from.x), y(static_cast<long double>(to.y) - from.y) {}
  long double square() const { return x * x + y * y; }
};

int sign_of(long double value, long double bound) {
  if (!(std::fabs(value) > bound)) return kUndecided;
  return value > 0 ? 1 : -1;
}

}  // namespace

// The differences of doubles are between 2^-1074 and 2^1025, and their products of four between
// 2^-4296 and 2^4102: nothing overflows or underflows. So rounding is all that there is to bound,
// as for the filter (see predicate_stages.h), by the absolute values of all terms as they are: what
// the filter has instead is larger by a factor that has no limit where the points are far wider
// than high.

int orient_long(const Point& a, const Point& b, const Point& c) {
  if constexpr (!kIsWider) return kUndecided;
  const Offset p(c, a), q(c, b);
  const long double left = p.x * q.y, right = p.y * q.x;
  return sign_of(left - right, 4 * kUnit * (std::fabs(left) + std::fabs(right)));
}

int in_circle_long(const Point& a, const Point& b, const Point& c, const Point& d) {
  if constexpr (!kIsWider) return kUndecided;
  const Offset p(a, b), q(a, c), s(a, d);
  const long double pp = p.square(), qq = q.square(), ss = s.square();
  // The terms of three minors, and the factors of the minors.
  const long double u1 = p.x * q.y, u2 = p.y * q.x;
  const long double v1 = p.y * qq, v2 = pp * q.y;
  const long double w1 = pp * q.x, w2 = p.x * qq;
  const long double value = (u1 - u2) * ss + ((v1 - v2) * s.x + (w1 - w2) * s.y);
  const auto size = [](long double x) { return std::fabs(x); };
  const long double sizes = (size(u1) + size(u2)) * ss +
                            ((size(v1) + size(v2)) * size(s.x) + (size(w1) + size(w2)) * size(s.y));
  return sign_of(-value, 12 * kUnit * sizes);
}

}  // namespace hodt::exact
