// Numbers with the precision of doubles and exponents of any size, for what is measured of points
// whose squares and products doubles cannot hold.
#pragma once

#include <algorithm>
#include <cmath>
#include <compare>

#include "hodt/geometry/point.h"

namespace hodt {

/// Every operation rounds like that of doubles; none overflows or underflows.
class WideReal {
 public:
  WideReal(double value = 0) : WideReal(value, 0) {}  // NOLINT: a double is such a number
  /// mantissa * 2^exponent.
  WideReal(double mantissa, int exponent) {
    int own = 0;
    mantissa_ = std::frexp(mantissa, &own);
    exponent_ = mantissa == 0 ? kOfZero : own + exponent;
  }

  friend WideReal operator*(const WideReal& a, const WideReal& b) {
    return {a.mantissa_ * b.mantissa_, a.exponent_ + b.exponent_};
  }
  friend WideReal operator/(const WideReal& a, const WideReal& b) {
    return {a.mantissa_ / b.mantissa_, a.exponent_ - b.exponent_};
  }
  friend WideReal operator+(const WideReal& a, const WideReal& b) {
    if (a.exponent_ < b.exponent_) return b + a;
    constexpr int kNothing = 200;  // less than half of the last place
    const int shift = std::min(a.exponent_ - b.exponent_, kNothing);
    return {a.mantissa_ + std::ldexp(b.mantissa_, -shift), a.exponent_};
  }
  WideReal operator-() const { return {-mantissa_, exponent_}; }
  friend WideReal operator-(const WideReal& a, const WideReal& b) { return a + -b; }
  friend WideReal sqrt(const WideReal& a) {
    const bool is_odd = a.exponent_ % 2 != 0;
    return {std::sqrt(is_odd ? 2 * a.mantissa_ : a.mantissa_),
            (a.exponent_ - (is_odd ? 1 : 0)) / 2};
  }
  friend WideReal fabs(const WideReal& a) { return {std::fabs(a.mantissa_), a.exponent_}; }

  friend bool operator==(const WideReal&, const WideReal&) = default;
  friend std::partial_ordering operator<=>(const WideReal& a, const WideReal& b) {
    return (a - b).mantissa_ <=> 0;
  }

  /// Whether a double can say it as precisely.
  bool is_in_range() const { return mantissa_ == 0 || (exponent_ > -1022 && exponent_ <= 1024); }
  bool is_large() const { return exponent_ > 0; }
  /// Infinite or zero, or less precise, if it is out of a double's range.
  double to_double() const { return std::ldexp(mantissa_, std::clamp(exponent_, -2000, 2000)); }

 private:
  // Of zero, low enough for products and quotients of it to be below everything else.
  static constexpr int kOfZero = -(1 << 20);

  double mantissa_ = 0;  // 0, or between 0.5 and 1
  int exponent_ = kOfZero;
};

/// (b - a) x (c - a), its last place aside, however thin the triangle is.
WideReal exact_cross(const Point& a, const Point& b, const Point& c);

}  // namespace hodt
