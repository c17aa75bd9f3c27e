#include "hodt/order/search/sector_levels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "hodt/base/lanes.h"

namespace hodt {

namespace {

constexpr Index kSectors = 32;

/// The directions between sectors; that after the last is the first again.
struct Directions {
  float x[kSectors + 1], y[kSectors + 1];
};
const Directions kEnds = [] {
  Directions ends;
  for (Index i = 0; i <= kSectors; ++i) {
    const double angle = 2 * std::numbers::pi * (i % kSectors) / kSectors;
    ends.x[i] = static_cast<float>(std::cos(angle));
    ends.y[i] = static_cast<float>(std::sin(angle));
  }
  return ends;
}();

// A point's coordinates are off by 8 e (e = 2^-24) of themselves, or by kTiny if nearly nothing is
// left of them; p·n by another 3 e.
constexpr float kSlack = 16 * 0x1p-24f;
constexpr float kTiny = 0x1p-50f;

HODT_INLINE float slack_of(float x, float y) {
  return kSlack * (std::fabs(x) + std::fabs(y)) + kTiny;
}

// With n = a from + b to, where a, b >= 0: p·n is between a + b times the smaller and a + b times
// the larger of p·from and p·to. So distances in all sectors are compared by these.

/// Puts two points at a time in their places: less waiting for what was just written.
template <Index N>
HODT_INLINE void add_points(const float* x, const float* y, Index first, Index last, float* levels,
                            Index k) {
  using Floats = typename Lanes<N>::Floats;
  constexpr Index kBlocks = kSectors / N;
  for (Index i = first; i < last; i += 2) {
    const bool both = i + 1 < last;
    const float px = x[i], py = y[i], qx = both ? x[i + 1] : 0, qy = both ? y[i + 1] : 0;
    const float p_slack = slack_of(px, py), q_slack = slack_of(qx, qy);
    for (Index b = 0; b < kBlocks; ++b) {
      Floats from_x, from_y, to_x, to_y;
      load(from_x, &kEnds.x[b * N]);
      load(from_y, &kEnds.y[b * N]);
      load(to_x, &kEnds.x[b * N + 1]);
      load(to_y, &kEnds.y[b * N + 1]);
      const Floats p_from = px * from_x + py * from_y, p_to = px * to_x + py * to_y;
      const Floats q_from = qx * from_x + qy * from_y, q_to = qx * to_x + qy * to_y;
      const Floats p = (p_from < p_to ? p_from : p_to) - p_slack;
      const Floats q = (q_from < q_to ? q_from : q_to) - q_slack;
      Floats large = p > q ? p : q, small = p > q ? q : p;
      float* level = levels + b * N;
      for (Index j = 0; j <= k; ++j, level += kSectors) {
        Floats before;
        load(before, level);
        store(level, Floats(before > large ? before : large));
        const Floats rest = before > large ? large : before;
        large = rest > small ? rest : small;
        small = rest > small ? small : rest;
      }
    }
  }
}
HODT_FOR_LANES(add_points)

template <Index N>
HODT_INLINE void bound_points(const float* x, const float* y, Index first, Index last,
                              const float* low, const float* high, Index k, Index* counts) {
  using Floats = typename Lanes<N>::Floats;
  using Bits = typename Lanes<N>::Bits;
  for (Index i = first; i < last; i += N) {
    Floats px, py;
    load(px, x + i);
    load(py, y + i);
    const Floats slack = kSlack * ((px < 0 ? -px : px) + (py < 0 ? -py : py)) + kTiny;
    Bits above_low = {}, above_high = {};
    for (Index s = 0; s < kSectors; ++s) {
      const Floats most = px * kEnds.x[s] + py * kEnds.y[s] + slack;
      above_low |= most >= low[s];
      above_high |= most >= high[s];
    }
    store(counts + i, Bits((static_cast<std::int32_t>(k + 1) + above_low) & ~above_high));
  }
}
HODT_FOR_LANES(bound_points)

}  // namespace

void SectorLevels::clear(Index k) {
  k_ = std::max(k, Index{1});
  const std::size_t size = std::size_t{kSectors} * (k_ + 1);
  if (levels_.size() < size) levels_ = Buffer<float>(2 * size);
  std::fill(levels_.begin(), levels_.begin() + size, 0.0f);
}

void SectorLevels::add(const float* x, const float* y, Index first, Index last) {
  add_points_in_lanes(x, y, first, last, levels_.data(), k_);
}

void SectorLevels::bound(const float* x, const float* y, Index first, Index last,
                         Index* counts) const {
  // A point beyond a line of a sector has more than the sector's distance at one of its ends.
  float low[kSectors], high[kSectors];
  const float *level = levels_.data() + std::size_t{k_} * kSectors, *before = level - kSectors;
  for (Index s = 0; s < kSectors; ++s) {
    const Index other = (s + kSectors - 1) % kSectors;
    low[s] = std::min(level[s], level[other]);
    high[s] = std::min(before[s], before[other]);
  }
  bound_points_in_lanes(x, y, first, last, &low[0], &high[0], k_, counts);
}

}  // namespace hodt
