// Up to 64 points near a vertex u, and questions to all of them at once, answered as bit masks.
//
// The answers are proofs, not decisions: a bit that is set is certainly right, a point that
// rounding leaves in doubt has no bit. Nothing is ever decided by a missing bit.
#pragma once

#include <cstdint>

#include "hodt/base/ids.h"

namespace hodt {

class Slots {
 public:
  static constexpr Index kCapacity = 64;
  using Mask = std::uint64_t;

  /// What lies certainly to the left and to the right of a ray from u.
  struct Sides {
    Mask left, right;
  };

  Index size() const { return size_; }
  void clear() { size_ = 0; }
  /// Adds the point u + (x, y). Requires size() < kCapacity.
  void add(double x, double y);

  /// Points certainly inside the circle through u, u + b and u + c. Requires b, c in
  /// counter-clockwise order as seen from u.
  Mask inside_circle(double bx, double by, double cx, double cy) const;
  /// Points certainly on either side of the line through u and u + (x, y).
  Sides sides_of_ray(double x, double y) const;

 private:
  static constexpr Index kBlock = 8;  // arrays are filled up to a multiple of this

  Index size_ = 0;
  alignas(64) double x_[kCapacity], y_[kCapacity], r_[kCapacity];  // r = x² + y²
};

}  // namespace hodt
