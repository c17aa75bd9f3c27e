// Stage 3: integers of fixed width.
// Tested by tests/geometry/predicates_test.cpp.
#include <algorithm>
#include <bit>
#include <cstdint>

#include "hodt/geometry/exact_determinants.h"
#include "hodt/geometry/predicate_stages.h"

namespace hodt::exact {
namespace {

/// Scales all values by the power of two that brings the largest to [2^60, 2^61). False if the
/// results are not all integers. Scaling up is always exact, so the largest must be below 2^61.
template <int N>
bool to_integers(const double (&value)[N], std::int64_t (&integer)[N]) {
  std::uint64_t largest = 0;  // magnitudes compare like their bits
  for (const double v : value) largest = std::max(largest, std::bit_cast<std::uint64_t>(v) << 1);
  const int exponent = static_cast<int>(largest >> 53) - 1023;
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

int orient_fixed(const Point& a, const Point& b, const Point& c) {
  const double value[] = {a.x, a.y, b.x, b.y, c.x, c.y};
  std::int64_t v[6];
  if (!to_integers(value, v)) return kUndecided;
  return orient_sign<std::int64_t>({v[0] - v[4], v[1] - v[5]}, {v[2] - v[4], v[3] - v[5]});
}

int in_circle_fixed(const Point& a, const Point& b, const Point& c, const Point& d) {
  const double value[] = {a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y};
  std::int64_t v[8];
  if (!to_integers(value, v)) return kUndecided;
  const std::int64_t ax = v[0] - v[6], ay = v[1] - v[7];
  const std::int64_t bx = v[2] - v[6], by = v[3] - v[7];
  const std::int64_t cx = v[4] - v[6], cy = v[5] - v[7];
  return in_circle_sign<std::int64_t>({ax, ay}, {bx, by}, {cx, cy});
}

}  // namespace hodt::exact
