// The terrain `valley`: random points on an eroded landscape. Internal to this layer.
// Tested by tests/terrain/terrain_test.cpp.
#pragma once

#include <cstddef>
#include <cstdint>

#include "hodt/geometry/point_set.h"
#include "hodt/terrain/eroded_grid.h"

namespace hodt {

/// Up to here the expected number of points that coincide stays below one.
inline constexpr std::size_t kMostValleyPoints = 100'000'000;

/// The surface that `n` points are taken from: a square of side valley_side(n), beginning at
/// (spacing / 2, 0) of a grid that is as fine as the points are dense, within limits.
TriangularGrid valley_grid(std::size_t n, std::uint64_t seed);

/// The side of the square in millimetres: 10 m to a point.
std::uint32_t valley_side(std::size_t n);

/// n points, uniform in the square, all coordinates rounded to millimetres: what a survey has.
/// Requires 1 <= n <= kMostValleyPoints.
PointSet sample_valley(std::size_t n, std::uint64_t seed);

}  // namespace hodt
