// A few points around a vertex u, and questions to all of them at once, answered by sets.
//
// Inverted at u, the circles through u are lines and their insides half-planes; so are the sides of
// a ray from u. Every question is about a half-plane, then, and costs a few operations on rounded
// images. What is called sure has their rounding bounded.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "hodt/base/ids.h"
#include "hodt/base/lanes.h"
#include "hodt/geometry/point.h"
#include "hodt/order/place_set.h"

namespace hodt {

/// The images p with a p.x + b p.y + c < 0, up to the slack.
struct ImageHalfPlane {
  float a, b, c, slack;
};

/// Up to 64 kWords points.
template <Index kWords>
class NearPoints {
 public:
  using Set = PlaceSet<kWords>;

  /// Only u itself, at place 0, which no half-plane holds. The nearest of the points to come is at
  /// a distance of about `nearest`.
  HODT_INLINE void clear(double nearest);
  Index size() const { return size_; }
  /// Point i, one of the next that are to be added, is at u + offset.
  HODT_INLINE void set(Index i, const Point& offset);
  /// Adds those set, so that there are `size`. False if one of them is too far away for arithmetic
  /// that is not exact.
  template <Index N>
  HODT_INLINE bool add(Index size);
  /// Whether the point is lexicographically larger than u.
  bool is_larger(Index i) const { return larger_.has(i); }

  /// The inside of the circle through u, i and j (counter-clockwise).
  HODT_INLINE ImageHalfPlane inside(Index i, Index j) const;
  /// What is to the left of the ray from u to i.
  HODT_INLINE ImageHalfPlane left_of(Index i) const;

  /// The points that surely are in a half-plane, and those that surely are in its complement, not
  /// on its line. Places that are not taken are never in one.
  struct Split {
    Set in, out;
  };
  template <Index N, std::size_t Count>
  HODT_INLINE std::array<Split, Count> split(const std::array<ImageHalfPlane, Count>& planes) const;
  template <Index N>
  HODT_INLINE Split split(const ImageHalfPlane& plane) const {
    return split<N>(std::array{plane})[0];
  }

 private:
  // Rounding, in units e = 2^-24. The coordinates of images are off by little more than 4 e of
  // themselves, a and b by e of the larger of them, the sum by 3 e of |a X| + |b Y|: less than 9 e
  // max(|a|, |b|) (|X| + |Y|) in all. 16 leave room for the rounding of the bound; kTiny is far
  // above what underflow can do, with images of at least 2^-55.
  static constexpr float kSlack = 16 * 0x1p-24f;
  static constexpr float kTiny = 0x1p-90f;
  static constexpr double kMostSquared = 0x1p+110;

  Index size_ = 1;
  Set larger_;
  double scale_ = 1;  // a power of two that brings offsets close to 1
  // Of places not taken, 0: the image of what is infinitely far away.
  alignas(64) std::array<float, Set::kMost> image_x_{}, image_y_{}, rounding_{};
  std::array<double, Set::kMost> x_{}, y_{}, r_{};  // r = x² + y²
};

template <Index kWords>
HODT_INLINE void NearPoints<kWords>::clear(double nearest) {
  for (auto* array : {&image_x_, &image_y_, &rounding_}) std::fill_n(array->data(), size_, 0.0f);
  size_ = 1;
  larger_ = {};
  scale_ = std::ldexp(1.0, -std::clamp(std::ilogb(nearest), -1020, 1000));
}

template <Index kWords>
HODT_INLINE void NearPoints<kWords>::set(Index i, const Point& offset) {
  x_[i] = scale_ * offset.x;
  y_[i] = scale_ * offset.y;
  // Not after scaling, which may lose what is tiny beside the rest.
  const bool is_right = offset.x > 0, is_above = offset.x == 0 && offset.y > 0;
  if (is_right | is_above) larger_ |= Set::only(i);
}

template <Index kWords>
template <Index N>
HODT_INLINE bool NearPoints<kWords>::add(Index size) {
  bool is_near = true;
  for (Index i = size_; i < size; ++i) {
    const double r = x_[i] * x_[i] + y_[i] * y_[i];
    is_near &= r < kMostSquared;
    r_[i] = r;
    const auto x = static_cast<float>(x_[i]), y = static_cast<float>(y_[i]);
    const float inverse = 1 / static_cast<float>(r);
    image_x_[i] = x * inverse;
    image_y_[i] = y * inverse;
    rounding_[i] = kSlack * (std::fabs(image_x_[i]) + std::fabs(image_y_[i])) + kTiny;
  }
  size_ = size;
  return is_near;
}

template <Index kWords>
HODT_INLINE ImageHalfPlane NearPoints<kWords>::inside(Index i, Index j) const {
  // The line through the images is p·n = 1 with n = (ri qj - rj qi) / (qi x qj), turned by a right
  // angle. If the sine of the angle at u is above 2^-20, double precision loses less than half of
  // its digits. If not, nothing is known.
  const double xi = x_[i], yi = y_[i], ri = r_[i], xj = x_[j], yj = y_[j], rj = r_[j];
  const double cross = xi * yj - yi * xj;
  if (!(cross > 0 && cross * cross > 0x1p-40 * (ri * rj))) [[unlikely]]
    return {0, 0, 1, 0x1p+100f};
  const double inverse = 1 / cross;
  const auto a = static_cast<float>((rj * yi - ri * yj) * inverse);
  const auto b = static_cast<float>((ri * xj - rj * xi) * inverse);
  return {a, b, 1, std::max(std::fabs(a), std::fabs(b))};
}

template <Index kWords>
HODT_INLINE ImageHalfPlane NearPoints<kWords>::left_of(Index i) const {
  const float x = image_x_[i], y = image_y_[i];
  return {y, -x, 0, std::max(std::fabs(x), std::fabs(y))};
}

template <Index kWords>
template <Index N, std::size_t Count>
HODT_INLINE auto NearPoints<kWords>::split(const std::array<ImageHalfPlane, Count>& planes) const
    -> std::array<Split, Count> {
  using Floats = typename Lanes<N>::Floats;
  std::array<Split, Count> splits{};
  for (Index w = 0; w < kWords && 64 * w < size_; ++w) {
    std::array<std::uint64_t, Count> in{}, out{};
    // Backwards, so that bits move on by as many places each time.
    const Index first = 64 * w, blocks = (std::min(size_ - first, Index{64}) + N - 1) / N;
    for (Index block = blocks; block-- > 0;) {
      const Index i = first + block * N;
      Floats x, y, rounding;
      load(x, &image_x_[i]);
      load(y, &image_y_[i]);
      load(rounding, &rounding_[i]);
      for (std::size_t p = 0; p < Count; ++p) {
        const ImageHalfPlane& plane = planes[p];
        const Floats value = plane.c + (plane.a * x + plane.b * y), slack = plane.slack * rounding;
        in[p] = in[p] << N | signs(value + slack);
        out[p] = out[p] << N | signs(slack - value);
      }
    }
    for (std::size_t p = 0; p < Count; ++p) {
      splits[p].in.word(w) = in[p];
      splits[p].out.word(w) = out[p];
    }
  }
  return splits;
}

}  // namespace hodt
