// Meshes for formats of single precision: coordinates from an origin nearby.
// Tested by tests/io/tin_writers_test.cpp.
#pragma once

#include <array>
#include <cstddef>

#include "hodt/tin/tin.h"

namespace hodt {

/// A vertex x, y, z is stored as what it is from an origin, whose coordinates are whole numbers
/// near the middle of the mesh. Vertices without heights have z = 0.
class LocalFrame {
 public:
  /// Throws InputError if single precision cannot hold the mesh's extent.
  explicit LocalFrame(const Tin& tin);

  const std::array<double, 3>& origin() const { return origin_; }
  /// The furthest that a coordinate, rounded, is off.
  double largest_error() const { return largest_error_; }
  std::array<float, 3> operator[](std::size_t vertex) const;

 private:
  const PointSet& points_;
  std::array<double, 3> origin_{};
  double largest_error_ = 0;
};

}  // namespace hodt
