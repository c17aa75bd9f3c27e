// Sums of doubles, and what rounding does to them.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "hodt/base/lanes.h"
#include "hodt/optimize/aggregator.h"

namespace hodt {

/// What is lost when x + y is rounded to `sum`: a double itself.
HODT_INLINE double lost_in_sum(double x, double y, double sum) {
  const double rounded_y = sum - x;
  return (x - (sum - rounded_y)) + (y - rounded_y);
}

/// The next double below if sign is 1, above if it is -1.
inline double outward(double value, double sign) {
  return std::nextafter(value, -sign * std::numeric_limits<double>::infinity());
}

/// Combines values, rounding sums so that the exact one is no better: for bounds.
inline double combine_outward(const Aggregator& aggregator, double x, double y) {
  const double combined = aggregator.combine(x, y);
  if (!aggregator.is_sum()) return combined;
  const double lost = lost_in_sum(x, y, combined), sign = aggregator.sign();
  const bool is_inward = sign * lost < 0;
  // The next double, without a call where sums mostly are, nor a branch on what is a matter of
  // chance.
  if (combined > std::numeric_limits<double>::min() && combined < 1e300) {
    const std::int64_t step = sign > 0 ? 1 : -1;
    return std::bit_cast<double>(std::bit_cast<std::int64_t>(combined) - step * is_inward);
  }
  return is_inward ? outward(combined, sign) : combined;
}

/// No exact value is better than this if one within so much of it is the best.
inline double bound_within(const Aggregator& aggregator, double value, double error) {
  if (error == 0) return value;
  return outward(value - aggregator.sign() * 1.001 * error, aggregator.sign());
}

}  // namespace hodt
