// Angles given by their sine and cosine, both times any one positive number.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include "hodt/base/lanes.h"

namespace hodt {

/// The arctangent of x, |x| at most the tangent of 22.5 degrees, within a unit in the last place:
/// the polynomial that agrees with it at 12 Chebyshev nodes of x². The C library's is a call, which
/// keeps loops from becoming vector code.
HODT_INLINE double small_arctangent(double x) {
  const double z = x * x, w = z * z;
  const double even = -0x1.555555555552fp-2 +
                      w * (-0x1.2492492259b3ep-3 +
                           w * (-0x1.745cf64dcc6bdp-4 +
                                w * (-0x1.10ea1d157f6ffp-4 +
                                     w * (-0x1.9c79c07a989c6p-5 + w * -0x1.23b93fac21dacp-6))));
  const double odd =
      0x1.999999999466ap-3 +
      w * (0x1.c71c70cb775cep-4 +
           w * (0x1.3b10f0f5b1224p-4 + w * (0x1.def9ecd6a20f2p-5 + w * 0x1.3702ea64c11f2p-5)));
  return x + x * (z * (even + z * odd));
}

/// The acute angle of such a cotangent; d is the cotangent of its half. Half of what is above 45
/// degrees is 22.5 to 45 degrees, and taken from 45.
HODT_INLINE double acute_degrees(double d) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  const bool is_above_45 = d < 1 + std::numbers::sqrt2;
  const double x = (is_above_45 ? 1 - d : 1) / (is_above_45 ? 1 + d : d);
  return (is_above_45 ? 90 : 0) + 2 * kDegrees * small_arctangent(x);
}

HODT_INLINE double cotangent_of_half(double cotangent) {
  return std::sqrt(1 + cotangent * cotangent) + cotangent;
}

/// Such an angle. The same bits in loops that become vector code and elsewhere.
HODT_INLINE double degrees(double sine, double cosine) {
  const double acute = acute_degrees(cotangent_of_half(std::fabs(cosine) / sine));
  return cosine > 0 ? acute : 180 - acute;
}

/// Grows with such an angle, in a fraction of the time: the negative cotangent.
HODT_INLINE double angle_rank(double sine, double cosine) {
  const double rank = -cosine / sine;
  // If both are 0 there is no angle; it counts as 0 degrees.
  return rank == rank ? rank : -std::numeric_limits<double>::infinity();
}

/// The angle that has the rank: degrees(sine, cosine), to the bit, and however large the rank is.
inline double degrees_of_rank(double rank) {
  constexpr double kLarge = 0x1p30;  // the square of a larger one is itself and 1, rounded
  const double cotangent = std::fabs(rank);
  const double acute =
      acute_degrees(cotangent > kLarge ? 2 * cotangent : cotangent_of_half(cotangent));
  return rank < 0 ? acute : 180 - acute;
}

}  // namespace hodt
