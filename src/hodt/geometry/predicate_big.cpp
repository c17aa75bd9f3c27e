// Stage 5: integers of any width. The same integers tell how large a cross product is.
// Tested by tests/geometry/predicates_test.cpp.
#include <algorithm>
#include <bit>
#include <cstdint>

#include "hodt/geometry/exact_determinants.h"
#include "hodt/geometry/predicate_stages.h"
#include "hodt/geometry/wide_real.h"

namespace hodt {
namespace exact {
namespace {

/// |value| = mantissa * 2^(exponent - 1075).
struct Parts {
  std::uint64_t mantissa;
  int exponent;
};

Parts parts(double value) {
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(value);
  const int exponent = static_cast<int>(bits >> 52 & 0x7ff);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  if (exponent == 0) return {fraction, 1};
  return {fraction | std::uint64_t{1} << 52, exponent};
}

/// Turns coordinates into integers: multiples of the last place of the smallest of them.
class Scale {
 public:
  void include(const Point& p) {
    lowest_ = std::min({lowest_, parts(p.x).exponent, parts(p.y).exponent});
  }
  BigInteger operator()(double value) const {
    const Parts p = parts(value);
    return shifted(p.mantissa, p.exponent - lowest_, value < 0);
  }
  /// p - origin.
  Vector<BigInteger> operator()(const Point& p, const Point& origin) const {
    return {(*this)(p.x) - (*this)(origin.x), (*this)(p.y) - (*this)(origin.y)};
  }
  /// What a product of two such integers stands for.
  WideReal value_of_product(const BigInteger& product) const {
    WideReal value;
    for (int i = product.size - 1; i >= std::max(product.size - 3, 0); --i)
      value = value + WideReal(static_cast<double>(product.word[i]), 64 * i);
    const WideReal unit(1, 2 * (lowest_ - 1075));
    return (product.negative ? -value : value) * unit;
  }

 private:
  int lowest_ = 2046;
};

}  // namespace

int orient_big(const Point& a, const Point& b, const Point& c) {
  Scale scale;
  for (const Point& p : {a, b, c}) scale.include(p);
  return orient_sign(scale(a, c), scale(b, c));
}

int in_circle_big(const Point& a, const Point& b, const Point& c, const Point& d) {
  Scale scale;
  for (const Point& p : {a, b, c, d}) scale.include(p);
  return in_circle_sign(scale(a, d), scale(b, d), scale(c, d));
}

}  // namespace exact

WideReal exact_cross(const Point& a, const Point& b, const Point& c) {
  exact::Scale scale;
  for (const Point& p : {a, b, c}) scale.include(p);
  return scale.value_of_product(cross(scale(b, a), scale(c, a)));
}

}  // namespace hodt
