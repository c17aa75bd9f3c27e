#include "hodt/optimize/range.h"

#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/base/lanes.h"
#include "hodt/base/parallel.h"

namespace hodt {

namespace {

std::string text_of(std::initializer_list<Point> points) {
  std::string text;
  for (const Point& p : points)
    text += fmt::format("{}({}, {})", text.empty() ? "" : " ", p.x, p.y);
  return text;
}

HODT_INLINE bool is_out(double x) {
  const double size = std::fabs(x);
  return (size > 0x1p100) | ((size < 0x1p-98) & (size != 0));
}
HODT_INLINE bool is_out(const Point& p) {
  return is_out(p.x) | is_out(p.y);
}

template <class T>
bool is_none_out(std::span<const T> all) {
  std::atomic<bool> is_any_out = false;
  parallel_for(0, all.size(), 1 << 15, [&](std::size_t first, std::size_t last) {
    const bool is_any = run_in_lanes([&]<Index>() HODT_INLINE_LAMBDA {
      std::int64_t out = 0;
      for (std::size_t i = first; i < last; ++i) out |= is_out(all[i]) ? -1 : 0;
      return out != 0;
    });
    if (is_any) is_any_out = true;
  });
  return !is_any_out;
}

}  // namespace

bool is_plain(std::span<const double> numbers) {
  return is_none_out(numbers);
}

bool is_plain(std::span<const Point> points) {
  return is_none_out(points);
}

bool are_finite(std::span<const double> values) {
  return run_in_lanes([&]<Index>() HODT_INLINE_LAMBDA {
    std::int64_t others = 0;
    for (const double value : values) others |= is_finite(value) ? 0 : -1;
    return others == 0;
  });
}

void throw_out_of_range(const Objective& objective, bool is_large,
                        std::initializer_list<Point> at) {
  throw InputError(fmt::format(
      "{}: what is measured at {} is too {} for a double; {} all coordinates by one number so that "
      "they come near 1",
      name_of(objective), text_of(at), is_large ? "large" : "small",
      is_large ? "divide" : "multiply"));
}

void throw_out_of_range(const Objective& objective) {
  throw InputError(fmt::format(
      "{}: the value is too large for a double; divide all coordinates by one number so "
      "that they come near 1",
      name_of(objective)));
}

double checked_own_value(double value, const Objective& objective,
                         std::initializer_list<Point> at) {
  if (value >= 0 && value <= std::numeric_limits<double>::max()) return value + 0.0;  // never -0
  throw ParameterError(
      fmt::format("{}: the measure returned {} at {}; its values must be finite and not negative",
                  name_of(objective), value, text_of(at)));
}

}  // namespace hodt
