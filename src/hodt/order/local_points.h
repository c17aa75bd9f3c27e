// The points around a vertex u, and questions to all of them at once.
//
// The answers are proofs or guesses, never decisions: what is called sure has its rounding bounded,
// and whoever uses a guess checks it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "hodt/base/ids.h"
#include "hodt/geometry/point.h"

namespace hodt {

class LocalPoints {
 public:
  /// No points; those to come are of the size of `extent` (the length that questions are about).
  void clear(double extent);
  /// Makes room for so many; those added are at u until they are set.
  void extend(Index size);
  /// Point i is at u + offset.
  void set(Index i, const Point& offset) {
    const double x = scale_ * offset.x, y = scale_ * offset.y;
    const double largest = std::max(std::fabs(x), std::fabs(y));
    if (!(largest < kMaxSingle)) [[unlikely]]
      return set_double(i, x, y);
    x_[i] = x;
    y_[i] = y;
    r_[i] = x * x + y * y;
    const auto xf = static_cast<float>(x), yf = static_cast<float>(y);
    xf_[i] = xf;
    yf_[i] = yf;
    rf_[i] = xf * xf + yf * yf;
  }
  /// The same, but surely_inside() does not count it, and guess_firsts() does not see it.
  void set_uncounted(Index i, const Point& offset) {
    set_double(i, scale_ * offset.x, scale_ * offset.y);
  }
  Index size() const { return size_; }

  /// Whether nothing overflows. If not, split() must not be asked.
  bool usable() const { return usable_; }

  /// A number of points that are inside every circle through u and q; counting ends at `enough`.
  Index surely_inside(Index q, Index enough) const;

  /// The points s on either side of u -> q whose circle with u and q holds no other point of that
  /// side: a guess, good but for rounding. kNone (both) if a side seems to be empty.
  struct Firsts {
    Index left, right;
    Index beyond;  ///< proven: one of the two circles holds so many points or more
  };
  Firsts guess_firsts(Index q) const;

  /// Where 64 points are with regard to a circle and to a side of one of its chords.
  struct Split {
    std::uint64_t inside;    // surely inside
    std::uint64_t doubtful;  // neither surely inside nor surely outside, as b and c are
    std::uint64_t beyond;    // surely beyond the chord
  };
  /// The circle is that through u, b and c (counter-clockwise).
  enum class Beyond { right_of_b, left_of_c };
  void split(Index b, Index c, Beyond beyond, std::vector<Split>& splits) const;

 private:
  /// Squares and products of what is below do not overflow.
  static constexpr double kMaxSingle = 0x1p+55, kMaxDouble = 0x1p+200;

  void set_double(Index i, double x, double y);

  Index size_ = 0;
  double scale_ = 1;  // a power of two that brings coordinates close to 1
  bool usable_ = true;
  // Arrays filled with zeros, that is u, up to a multiple of kBlock.
  std::vector<double> x_, y_, r_;    // r = x² + y²
  std::vector<float> xf_, yf_, rf_;  // the same rounded
};

}  // namespace hodt
