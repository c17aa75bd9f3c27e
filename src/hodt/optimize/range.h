// Coordinates whose products doubles hold, and what is said where no double holds a value.
#pragma once

#include <initializer_list>
#include <limits>
#include <span>

#include "hodt/base/lanes.h"
#include "hodt/geometry/point.h"
#include "hodt/optimize/objective.h"

namespace hodt {

/// Whether the numbers are 0 or of a size such that no difference, square or product of three
/// differences overflows, or underflows.
bool is_plain(std::span<const double> numbers);
bool is_plain(std::span<const Point> points);

/// Whether a value that is not negative is neither infinite nor undefined.
HODT_INLINE bool is_finite(double value) {
  return value <= std::numeric_limits<double>::max();
}
bool are_finite(std::span<const double> values);

/// Throws InputError: what is measured at these points is too large, or too small.
[[noreturn]] void throw_out_of_range(const Objective& objective, bool is_large,
                                     std::initializer_list<Point> at);
/// The same of a total.
[[noreturn]] void throw_out_of_range(const Objective& objective);

/// What a measure of one's own returned at these points. Throws ParameterError if it is negative,
/// infinite or undefined.
double checked_own_value(double value, const Objective& objective, std::initializer_list<Point> at);

}  // namespace hodt
