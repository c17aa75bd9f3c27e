// The shapes of a mesh's triangles, in (x, y).
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "hodt/base/ids.h"
#include "hodt/geometry/point.h"

namespace hodt {

/// Of one measure over all triangles.
struct Spread {
  double min = 0;
  double median = 0;
  double mean = 0;
  double max = 0;
};

struct Quality {
  Spread smallest_angle;  ///< in degrees
  Spread largest_angle;
  /// Twice the inradius by the circumradius: 1 for an equilateral triangle, towards 0 for slivers.
  Spread radius_ratio;
  /// The longest edge by the height above it, as a multiple of an equilateral triangle's: 1 or
  /// more. Infinite where it is out of range.
  Spread aspect_ratio;

  static constexpr std::size_t kBinWidth = 10;  // degrees
  /// How many triangles have their smallest angle from 10 i up to 10 (i + 1) degrees, 60 included.
  std::array<std::size_t, 6> smallest_angles{};
  /// The largest angles likewise, from 60 + 10 i on, 180 included.
  std::array<std::size_t, 12> largest_angles{};
};

/// In degrees, at the corner a of the triangle abc, whatever its size and direction.
double angle_at(const Point& a, const Point& b, const Point& c);

/// Of triangles given in any direction, each with an inside. All is 0 if there is none. The same
/// bits on any number of threads.
Quality quality_of(std::span<const Point> points, std::span<const std::array<Index, 3>> triangles);

}  // namespace hodt
