// Stage 2: integers of fixed width.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>

#include "hodt/geometry/exact_determinants.h"
#include "hodt/geometry/predicate_stages.h"

namespace hodt::exact {
namespace {

/// Scales all values by the power of two that brings the largest to [2^60, 2^61). False if the
/// results are not all integers. Scaling up is always exact, so the largest must be below 2^61.
template <int N>
bool to_integers(const double (&value)[N], std::int64_t (&integer)[N]) {
  double largest = 0;
  for (const double v : value) largest = std::max(largest, std::fabs(v));
  const auto exponent = static_cast<int>(std::bit_cast<std::uint64_t>(largest) >> 52) - 1023;
  if (exponent < 60 - 1023 || exponent > 60) return false;
  const auto scale = std::bit_cast<double>(static_cast<std::uint64_t>(1023 + 60 - exponent) << 52);
  bool all = true;
  for (int i = 0; i < N; ++i) {
    const double scaled = value[i] * scale;
    integer[i] = static_cast<std::int64_t>(scaled);
    all &= static_cast<double>(integer[i]) == scaled;
  }
  return all;
}

}  // namespace

std::optional<int> orient_fixed(const Point& a, const Point& b, const Point& c) {
  const double value[] = {a.x, a.y, b.x, b.y, c.x, c.y};
  std::int64_t v[6];
  if (!to_integers(value, v)) return std::nullopt;
  return orient_sign<std::int64_t>({v[0] - v[4], v[1] - v[5]}, {v[2] - v[4], v[3] - v[5]});
}

std::optional<int> in_circle_fixed(const Point& a, const Point& b, const Point& c, const Point& d) {
  const double value[] = {a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y};
  std::int64_t v[8];
  if (!to_integers(value, v)) return std::nullopt;
  const std::int64_t ax = v[0] - v[6], ay = v[1] - v[7];
  const std::int64_t bx = v[2] - v[6], by = v[3] - v[7];
  const std::int64_t cx = v[4] - v[6], cy = v[5] - v[7];

  // Without the trailing zeros that all six have, most differences on a raster are small.
  constexpr std::uint64_t kStop = std::uint64_t{1} << 62;
  const auto bits = static_cast<std::uint64_t>(ax | ay | bx | by | cx | cy);
  const int zeros = std::countr_zero(bits | kStop);
  const auto size = [](std::int64_t i) { return static_cast<std::uint64_t>(i < 0 ? -i : i); };
  const std::uint64_t sizes = size(ax) | size(ay) | size(bx) | size(by) | size(cx) | size(cy);
  if (std::bit_width(sizes) - zeros <= 30) {
    const auto small = [zeros](std::int64_t i) { return static_cast<std::int32_t>(i >> zeros); };
    return in_circle_sign<std::int32_t>({small(ax), small(ay)}, {small(bx), small(by)},
                                        {small(cx), small(cy)});
  }
  return in_circle_sign<std::int64_t>({ax, ay}, {bx, by}, {cx, cy});
}

}  // namespace hodt::exact
