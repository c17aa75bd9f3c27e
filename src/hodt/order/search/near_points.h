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
#include "hodt/order/search/place_set.h"

namespace hodt {

/// A half-plane of images p. With value = a p.x + b p.y and doubt = slack * (rounding of p), p
/// surely is in it if value + doubt < in, and surely is not if doubt - value < out.
struct ImageHalfPlane {
  float a, b, slack, in, out;
};

/// Up to 64 kWords points.
template <Index kWords>
class NearPoints {
 public:
  using Set = PlaceSet<kWords>;

  /// Only u itself, at place 0, which no half-plane holds. The nearest of the points to come is at
  /// a distance of about `nearest`. Questions have to wait until some are added.
  HODT_INLINE void clear(double nearest);
  Index size() const { return size_; }
  /// Point i, one of the next that are to be added, is at u + offset.
  HODT_INLINE void set(Index i, const Point& offset);
  /// Adds those set, so that there are `size`. False if one of them is too far away for arithmetic
  /// that is not exact.
  template <Index N>
  HODT_INLINE bool add(Index size);
  /// Those that are lexicographically larger than u.
  const Set& larger() const { return larger_; }

  /// The inside of the circle through u, i and j (counter-clockwise).
  HODT_INLINE ImageHalfPlane inside(Index i, Index j) const;
  /// What is to the left of the ray from u to i.
  HODT_INLINE ImageHalfPlane left_of(Index i) const;

  /// The points that surely are in a half-plane, and those that surely are in its complement, not
  /// on its line. Places that are not taken are never in a half-plane.
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
  // Rounding, in units e = 2^-24. The coordinates of images are off by at most 4 e of themselves,
  // and so the value of p by at most 11 e times slack (|X| + |Y|): for `inside`, where a and b are
  // differences of images, just as well as where they are images or rounded themselves. 16 leave
  // room for the rounding of the bound; kTiny is far above what underflow can do, with images of at
  // least 2^-55. They are at most 2^51, where no product overflows.
  static constexpr float kSlack = 16 * 0x1p-24f;
  static constexpr float kTiny = 0x1p-90f;
  static constexpr float kMostSquared = 0x1p+110f;
  // Of directions that differ by an angle with a sine above 2^-7 the images tell enough.
  static constexpr float kSharp = 0x1p+12f;
  static constexpr float kTinyCross = 0x1p-80f;

  ImageHalfPlane inside_closely(Index i, Index j) const;

  Index size_ = 1;
  Set larger_;
  double scale_ = 1;  // a power of two that brings offsets close to 1
  // Of places not taken, 0: the image of what is infinitely far away.
  alignas(64) std::array<float, Set::kMost> image_x_{}, image_y_{}, rounding_{};
  std::array<double, Set::kMost> x_{}, y_{};  // offsets, scaled
};

template <Index kWords>
HODT_INLINE void NearPoints<kWords>::clear(double nearest) {
  size_ = 1;
  larger_ = {};
  scale_ = std::ldexp(1.0, -std::clamp(std::ilogb(nearest), -1023, 1000));
}

template <Index kWords>
HODT_INLINE void NearPoints<kWords>::set(Index i, const Point& offset) {
  x_[i] = scale_ * offset.x;
  y_[i] = scale_ * offset.y;
  // Not after scaling, which may lose what is tiny beside the rest.
  const bool is_larger = (offset.x > 0) | ((offset.x == 0) & (offset.y > 0));
  larger_.word(i / 64) |= std::uint64_t{is_larger} << i % 64;
}

template <Index kWords>
template <Index N>
HODT_INLINE bool NearPoints<kWords>::add(Index size) {
  // As many as there are double lanes; up to where split's blocks end.
  constexpr Index kLanes = N / 2;
  using Doubles [[gnu::vector_size(kLanes * sizeof(double))]] = double;
  using Floats = typename Lanes<kLanes>::Floats;
  using Bits = typename Lanes<kLanes>::Bits;
  Bits number, is_far = {};
  for (Index i = 0; i < kLanes; ++i) number[i] = static_cast<std::int32_t>(i);
  for (Index i = size_ / kLanes * kLanes; i < (size + N - 1) / N * N; i += kLanes) {
    Doubles x, y;
    load(x, &x_[i]);
    load(y, &y_[i]);
    const Doubles r = x * x + y * y;
    const Floats r_single = __builtin_convertvector(r, Floats), inverse = 1 / r_single;
    Floats image_x = __builtin_convertvector(x, Floats) * inverse;
    Floats image_y = __builtin_convertvector(y, Floats) * inverse;
    Floats rounding =
        kSlack * ((image_x < 0 ? -image_x : image_x) + (image_y < 0 ? -image_y : image_y)) + kTiny;
    const Bits place = number + static_cast<std::int32_t>(i);
    const Bits is_taken = (place > 0) & (place < static_cast<std::int32_t>(size));
    is_far |= is_taken & ~(r_single < kMostSquared);
    image_x = is_taken ? image_x : Floats{};
    image_y = is_taken ? image_y : Floats{};
    rounding = is_taken ? rounding : Floats{};
    store(&image_x_[i], image_x);
    store(&image_y_[i], image_y);
    store(&rounding_[i], rounding);
  }
  size_ = size;
  std::int32_t far[kLanes];
  store(&far[0], is_far);
  return fold<kLanes>(&far[0], [](const auto& a, const auto& b, auto& c) { c = a | b; }) == 0;
}

template <Index kWords>
HODT_INLINE ImageHalfPlane NearPoints<kWords>::inside(Index i, Index j) const {
  // The line through the images P and Q is P x Q - p x (Q - P) = 0, and positive at 0.
  const float xi = image_x_[i], yi = image_y_[i], xj = image_x_[j], yj = image_y_[j];
  const float cross = xi * yj - yi * xj;
  // 1 / kSlack times `rounding` is the size of an image. The error of the cross product is at most
  // 11 e times both sizes, and that of the value at p 11 e times its size and the sum of the two.
  const float slack = (rounding_[i] + rounding_[j]) * (1 / kSlack);
  const float doubt = rounding_[i] * rounding_[j] * (1 / kSlack);
  if (cross > kSharp * doubt + kTinyCross) [[likely]]
    return {yi - yj, xj - xi, slack, -cross - doubt, cross - doubt};
  return inside_closely(i, j);
}

/// In double precision, for points in nearly the same direction.
template <Index kWords>
ImageHalfPlane NearPoints<kWords>::inside_closely(Index i, Index j) const {
  // The line through the images is p·n = 1 with n = (ri qj - rj qi) / (qi x qj), turned by a right
  // angle. If the sine of the angle at u is above 2^-20, double precision loses less than half of
  // its digits. If not, nothing is known.
  const double xi = x_[i], yi = y_[i], xj = x_[j], yj = y_[j];
  const double ri = xi * xi + yi * yi, rj = xj * xj + yj * yj, cross = xi * yj - yi * xj;
  if (!(cross > 0 && cross * cross > 0x1p-40 * (ri * rj))) return {0, 0, 0, -1, -1};
  const double inverse = 1 / cross;
  const auto a = static_cast<float>((rj * yi - ri * yj) * inverse);
  const auto b = static_cast<float>((ri * xj - rj * xi) * inverse);
  return {a, b, std::max(std::fabs(a), std::fabs(b)), -1, 1};
}

template <Index kWords>
HODT_INLINE ImageHalfPlane NearPoints<kWords>::left_of(Index i) const {
  const float x = image_x_[i], y = image_y_[i];
  return {y, -x, std::max(std::fabs(x), std::fabs(y)), 0, 0};
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
        const Floats value = plane.a * x + plane.b * y, slack = plane.slack * rounding;
        in[p] = in[p] << N | below(value + slack, plane.in);
        out[p] = out[p] << N | below(slack - value, plane.out);
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
