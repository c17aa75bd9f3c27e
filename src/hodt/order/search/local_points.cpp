#include "hodt/order/search/local_points.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "hodt/base/clones.h"
#include "hodt/base/lanes.h"

namespace hodt {

namespace {

constexpr Index kBlock = 64;

/// Loops go on to a multiple of 16, through points at u.
constexpr Index whole_lanes(Index size) {
  return (size + 15) / 16 * 16;
}

// ---- Single precision: how many points are inside every circle through u and q? ----
//
// The circles through u = 0 and q are r - p·q = t (q × p), one for each t; p is inside if
// n - t c < 0 with n = r - p·q and c = q × p. That is linear in t: what is inside for two values is
// inside for all between; and what is inside at the first (last) value and lies to the right
// (left) of u -> q is so for all before (after). So the circles fall into six intervals, and the
// smallest count of any of them is a bound.
//
// Rounding, in units e = 2^-24, for |p|, |q| < 2^55: the coordinates are off by (1), products by
// (3); |q x p|, |q·p| <= (rq + r) / 2. c is off by 4 e |q||p|, n by 5 e (r + |q||p|), n - t c for
// |t| < 3 by another (1) of each: less than 6 e r + 24 e (rq + r) / 2 <= 18 e (rq + r). 32 leave
// room for the rounding of the bound; kTiny is far above what underflow can do (2^-150 times 2^57).
constexpr float kSlack = 32 * 0x1p-24f;
constexpr float kTiny = 0x1p-60f;

/// Six counters of 10 bits in two words.
struct Counts {
  std::uint32_t low, high;
};
constexpr Index kMostCounted = 960;  // so that none overflows

HODT_CLONES Counts count_inside(const float* x, const float* y, const float* r, Index size,
                                float qx, float qy, float rq) {
  std::uint32_t low = 0, high = 0;
  for (Index i = 0; i < size; ++i) {
    const float slack = kSlack * (rq + r[i]);
    const float c = qx * y[i] - qy * x[i];
    const float n = r[i] - (qx * x[i] + qy * y[i]) + slack;
    // Values that no lattice has many ties at.
    const float a = 2.2f * c, b = 0.7f * c, d = 0.04f * c;
    const bool right = c + slack<0, left = c - slack> 0;
    const bool in1 = n + a < 0, in2 = n + b < 0, in3 = n - d < 0, in4 = n - b < 0, in5 = n - a < 0;
    low += (right & in1) ? 1u : 0u;
    low += (in1 & in2) ? 1u << 10 : 0u;
    low += (in2 & in3) ? 1u << 20 : 0u;
    high += (in3 & in4) ? 1u : 0u;
    high += (in4 & in5) ? 1u << 10 : 0u;
    high += (in5 & left) ? 1u << 20 : 0u;
  }
  return {low, high};
}

// ---- Single precision: a guess at the first points. ----
//
// n / c is the t of the circle through p. Its bits, as an integer of the same order, give way at
// the low end to the index: so the smallest tells who it is.

struct FirstKeys {
  std::int32_t left = std::numeric_limits<std::int32_t>::max();
  std::int32_t right = std::numeric_limits<std::int32_t>::min();
};

HODT_CLONES FirstKeys first_keys(const float* x, const float* y, const float* r, Index size,
                                 std::int32_t index_bits, float qx, float qy) {
  constexpr std::int32_t kMagnitude = 0x7FFFFFFF;
  FirstKeys keys;
  std::int32_t best = keys.left, worst = keys.right;
  for (Index i = 0; i < size; ++i) {
    const float c = qx * y[i] - qy * x[i];
    const float n = r[i] - (qx * x[i] + qy * y[i]);
    std::int32_t key = std::bit_cast<std::int32_t>(n / c);
    key ^= (key >> 31) & kMagnitude;
    key = (key & ~index_bits) | static_cast<std::int32_t>(i);
    const std::int32_t on_left = c > 0 ? -1 : 0, on_right = c < 0 ? -1 : 0;
    best = std::min(best, (key & on_left) | (kMagnitude & ~on_left));
    worst = std::max(worst, (key & on_right) | (~kMagnitude & ~on_right));
  }
  return {best, worst};
}

// ---- Single precision: how many points are beyond, at the least? ----
//
// Points on the left enter the circles at their t, those on the right leave them. The true t of
// the first on the left is at most the smallest (t + error) of any on the left. So points on the
// right with a larger (t - error) are inside its circle, and likewise with the sides exchanged. Any
// part of the points gives a bound.

/// `enter` and `leave` are scratch, as large as the others.
template <Index N>
HODT_INLINE Index count_beyond(const float* x, const float* y, const float* r, Index size, float qx,
                               float qy, float rq, float* enter, float* leave) {
  using Floats = typename Lanes<N>::Floats;
  using Bits = typename Lanes<N>::Bits;
  const Floats never = Floats{} + std::numeric_limits<float>::infinity();
  Floats first = never, last = -never;
  for (Index i = 0; i < size; i += N) {
    Floats px, py, pr;
    load(px, x + i);
    load(py, y + i);
    load(pr, r + i);
    const Floats slack = kSlack * (rq + pr);
    const Floats c = qx * py - qy * px;
    const Floats n = pr - (qx * px + qy * py);
    const Floats inverse = 1 / c, t = n * inverse;
    const Floats scale = (1 + (t < 0 ? -t : t)) * inverse;
    const Floats error = 2 * slack * (scale < 0 ? -scale : scale);
    const Floats enters = c > slack ? t + error : never;
    const Floats leaves = -c > slack ? t - error : -never;
    first = enters < first ? enters : first;
    last = leaves > last ? leaves : last;
    store(enter + i, enters);
    store(leave + i, leaves);
  }
  float firsts[N], lasts[N];
  store(&firsts[0], first);
  store(&lasts[0], last);
  const float first_enter =
      fold<N>(&firsts[0], [](const auto& a, const auto& b, auto& c) { c = a < b ? a : b; });
  const float last_leave =
      fold<N>(&lasts[0], [](const auto& a, const auto& b, auto& c) { c = a > b ? a : b; });
  // Those on the left, and 2^16 times those on the right. (More than 2^16 on the left are more than
  // any limit that the right can exceed.)
  Bits counts = {};
  for (Index i = 0; i < size; i += N) {
    Floats enters, leaves;
    load(enters, enter + i);
    load(leaves, leave + i);
    counts -= enters < last_leave;
    counts -= (leaves > first_enter) << 16;
  }
  std::int32_t parts[N];
  store(&parts[0], counts);
  const auto count = static_cast<std::uint32_t>(
      fold<N>(&parts[0], [](const auto& a, const auto& b, auto& c) { c = a + b; }));
  return std::max(count & 0xFFFF, count >> 16);
}
HODT_FOR_LANES(count_beyond)

// ---- Double precision: inside, outside or in doubt. ----

// As in predicate_stages.h, with u as the origin: 12 units are enough, 32 leave room for
// underflow's kTiny and for the line.
constexpr double kDoubleSlack = 32 * 0x1p-53;
constexpr double kDoubleTiny = 0x1p-500;

constexpr std::array<std::uint64_t, 64> kBits = [] {
  std::array<std::uint64_t, 64> bits{};
  for (std::size_t i = 0; i < bits.size(); ++i) bits[i] = std::uint64_t{1} << i;
  return bits;
}();

/// A circle as a plane in lifted space, and a line, each with a bound on its rounding.
struct Plane {
  double d, p, q, bound, bound_per_r;
  double line_x, line_y, line_bound;
};

HODT_CLONES LocalPoints::Split split_word(const double* x, const double* y, const double* r,
                                          Index size, const Plane& plane) {
  const Plane f = plane;  // a copy, so that nothing is read again after a write
  std::uint64_t inside = 0, possible = 0, beyond = 0;
  for (Index i = 0; i < size; ++i) {
    const double value = f.d * r[i] + (f.p * x[i] + f.q * y[i]);
    const double bound = f.bound + f.bound_per_r * r[i];
    const double side = f.line_x * x[i] + f.line_y * y[i];
    inside |= value < -bound ? kBits[i] : 0;
    possible |= value <= bound ? kBits[i] : 0;
    beyond |= side < -(f.line_bound + kDoubleSlack * r[i]) ? kBits[i] : 0;
  }
  return {inside, possible & ~inside, beyond};
}

/// The arrays of LocalPoints.
struct Arrays {
  const double *x, *y;
  double* r;
  float *xf, *yf, *rf, *image_x, *image_y;
};

/// Returns the largest r.
HODT_CLONES double derive(const Arrays& arrays, Index first, Index last) {
  const Arrays a = arrays;
  double largest = 0;
  for (Index i = first; i < last; ++i) {
    const double x = a.x[i], y = a.y[i], r = x * x + y * y;
    a.r[i] = r;
    largest = largest > r ? largest : r;
    const auto xf = static_cast<float>(x), yf = static_cast<float>(y);
    const float rf = xf * xf + yf * yf, inverse = 1 / rf;
    a.xf[i] = xf;
    a.yf[i] = yf;
    a.rf[i] = rf;
    a.image_x[i] = xf * inverse;
    a.image_y[i] = yf * inverse;
  }
  return largest;
}

}  // namespace

void LocalPoints::clear(double nearest) {
  size_ = 0;
  usable_ = true;
  // Even the smallest of all numbers is brought to 2^-54, whose inverse square is no trouble.
  scale_ = std::ldexp(1.0, -std::clamp(std::ilogb(nearest), -1020, 1000));
}

void LocalPoints::extend(Index size) {
  const std::size_t begin = (size_ + kBlock - 1) / kBlock * kBlock;
  const std::size_t end = (size + kBlock - 1) / kBlock * kBlock;
  size_ = size;
  if (begin == end) return;
  const auto clear_from_begin = [&](auto& array) {
    if (array.size() < end + kBlock) array.resize(2 * end);
    std::fill(array.begin() + std::ptrdiff_t(begin), array.begin() + std::ptrdiff_t(end), 0);
  };
  for (auto* array : {&x_, &y_, &r_}) clear_from_begin(*array);
  for (auto* array : {&xf_, &yf_, &rf_, &image_x_, &image_y_}) clear_from_begin(*array);
  enter_.resize(xf_.size());
  leave_.resize(xf_.size());
}

void LocalPoints::finish(Index first) {
  const double largest = derive({x_.data(), y_.data(), r_.data(), xf_.data(), yf_.data(),
                                 rf_.data(), image_x_.data(), image_y_.data()},
                                first, size_);
  if (largest < kMaxSingle * kMaxSingle) [[likely]]
    return;
  for (Index i = first; i < size_; ++i) {
    if (!(r_[i] < kMaxSingle * kMaxSingle)) hide(i);
    if (!(r_[i] < kMaxDouble * kMaxDouble)) usable_ = false;
  }
}

/// In single precision it is at u then, which is never inside.
void LocalPoints::hide(Index i) {
  for (auto* array : {&xf_, &yf_, &rf_, &image_x_, &image_y_}) (*array)[i] = 0;
}

Index LocalPoints::surely_inside(Index q, Index enough) const {
  const float qx = xf_[q], qy = yf_[q], rq = rf_[q] + kTiny;
  Index counts[6] = {0, 0, 0, 0, 0, 0};
  for (Index first = 0;; first += kMostCounted) {
    const Index size = std::min(kMostCounted, whole_lanes(size_ - first));
    const auto [low, high] = count_inside(&xf_[first], &yf_[first], &rf_[first], size, qx, qy, rq);
    counts[0] += low & 1023;
    counts[1] += low >> 10 & 1023;
    counts[2] += low >> 20;
    counts[3] += high & 1023;
    counts[4] += high >> 10 & 1023;
    counts[5] += high >> 20;
    const Index least =
        std::min({counts[0], counts[1], counts[2], counts[3], counts[4], counts[5]});
    if (least >= enough || first + kMostCounted >= size_) return least;
  }
}

bool LocalPoints::surely_beyond(Index q, Index limit) const {
  const float qx = xf_[q], qy = yf_[q], rq = rf_[q] + kTiny;
  const auto more_among = [&](Index size) {
    return count_beyond_in_lanes(xf_.data(), yf_.data(), rf_.data(), size, qx, qy, rq,
                                 enter_.data(), leave_.data()) > limit;
  };
  // Mostly a few points around u are enough.
  constexpr Index kFew = 32;
  const Index size = whole_lanes(size_);
  return (size > kFew && more_among(kFew)) || more_among(size);
}

LocalPoints::Firsts LocalPoints::guess_firsts(Index q) const {
  const float qx = xf_[q], qy = yf_[q];
  const Index size = whole_lanes(size_);
  const auto index_bits = static_cast<std::int32_t>(std::bit_ceil(size) - 1);
  constexpr FirstKeys none;
  const FirstKeys keys = first_keys(xf_.data(), yf_.data(), rf_.data(), size, index_bits, qx, qy);
  if (keys.left == none.left || keys.right == none.right) return {kNone, kNone};
  const auto left = static_cast<Index>(keys.left & index_bits);
  const auto right = static_cast<Index>(keys.right & index_bits);
  return {left, right};
}

void LocalPoints::split(Index b, Index c, Beyond beyond, std::vector<Split>& splits) const {
  const double bx = x_[b], by = y_[b], cx = x_[c], cy = y_[c];
  const double bb = r_[b], cc = r_[c];
  // Right of u -> b, or left of u -> c: negative values of the line.
  const bool right = beyond == Beyond::right_of_b;
  const Plane plane{
      .d = bx * cy - by * cx,
      .p = by * cc - bb * cy,
      .q = bb * cx - bx * cc,
      .bound = kDoubleSlack * ((bb + kDoubleTiny) * (cc + kDoubleTiny)),
      .bound_per_r = kDoubleSlack * ((bb + kDoubleTiny) + (cc + kDoubleTiny)),
      .line_x = right ? -by : cy,
      .line_y = right ? bx : -cx,
      .line_bound = kDoubleSlack * ((right ? bb : cc) + kDoubleTiny),
  };
  splits.resize((size_ + 63) / 64);
  for (std::size_t i = 0; i < splits.size(); ++i)
    splits[i] = split_word(&x_[64 * i], &y_[64 * i], &r_[64 * i],
                           std::min<Index>(64, (size_ - Index(64 * i) + 7) / 8 * 8), plane);
  if (size_ % 64 != 0) splits.back().doubtful &= (std::uint64_t{1} << size_ % 64) - 1;
}

}  // namespace hodt
