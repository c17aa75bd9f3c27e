// The terrain `jacksboro`: 10,000 points of a real elevation model (data/README.md). Internal to
// this layer.
// Tested by tests/terrain/terrain_test.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "hodt/geometry/point_set.h"

namespace hodt {

inline constexpr std::size_t kJacksboroPoints = 10'000;

/// data/jacksboro.csv, byte for byte.
std::string_view jacksboro_csv();

/// A random subset of n points, in the order of the file.
/// Requires n <= kJacksboroPoints.
PointSet sample_jacksboro(std::size_t n, std::uint64_t seed);

}  // namespace hodt
