// Angles given by their sine and cosine, both times any one positive number.
#pragma once

#include <cmath>
#include <numbers>

#include "hodt/base/lanes.h"

namespace hodt {

/// The tangent of half an angle of 0 to 180 degrees: grows with the angle. Not a number if both are
/// 0.
HODT_INLINE double half_tangent(double sine, double cosine) {
  const double cotangent = cosine / sine, root = std::sqrt(1 + cotangent * cotangent);
  return cotangent > 0 ? 1 / (root + cotangent) : root - cotangent;
}

/// Such an angle. In half the time of an arctangent of two arguments.
inline double degrees(double sine, double cosine) {
  return 360 / std::numbers::pi * std::atan(half_tangent(sine, cosine));
}

}  // namespace hodt
