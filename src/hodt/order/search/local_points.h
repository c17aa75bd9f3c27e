// The points around a vertex u, and questions to all of them at once.
//
// The answers are proofs or guesses, never decisions: what is called sure has its rounding bounded,
// and whoever uses a guess checks it.
// Tested by tests/order/useful_edges_test.cpp.
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
  /// No points; the nearest of those to come is at a distance of about `nearest`.
  void clear(double nearest);
  /// Makes room for so many. Those added are to be set, and then finished.
  void extend(Index size);
  /// Point i is at u + offset.
  void set(Index i, const Point& offset) {
    x_[i] = scale_ * offset.x;
    y_[i] = scale_ * offset.y;
  }
  /// Computes what questions need of the points from place `first` on.
  void finish(Index first);
  /// From here on nobody counts point i, and guess_firsts() does not see it.
  void hide(Index i);
  Index size() const { return size_; }
  /// Arrays parallel to these had better have room for so many: 15 more than there are points.
  std::size_t capacity() const { return x_.size(); }
  /// The images p / |p|² of the points (a point hidden or very far away is at 0).
  const float* image_x() const { return image_x_.data(); }
  const float* image_y() const { return image_y_.data(); }

  /// Whether nothing overflows. If not, split() must not be asked.
  bool usable() const { return usable_; }

  /// A number of points that are inside every circle through u and q; counting ends at `enough`.
  Index surely_inside(Index q, Index enough) const;

  /// Whether surely more than `limit` points are on one side of u -> q and inside the circle
  /// through u, q and the first point on the other side: the one whose circle holds no other of
  /// its side.
  bool surely_beyond(Index q, Index limit) const;

  /// A guess at those first points, good but for rounding. kNone (both) if a side seems empty.
  struct Firsts {
    Index left, right;
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

  Index size_ = 0;
  double scale_ = 1;  // a power of two that brings coordinates close to 1
  bool usable_ = true;
  // Arrays filled with zeros, that is u, up to a multiple of kBlock.
  std::vector<double> x_, y_, r_;    // r = x² + y²
  std::vector<float> xf_, yf_, rf_;  // the same rounded
  std::vector<float> image_x_, image_y_;
  mutable std::vector<float> enter_, leave_;  // scratch of surely_beyond()
};

}  // namespace hodt
