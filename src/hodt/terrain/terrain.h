// The terrains that come with the library: one real, one made up.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "hodt/geometry/point_set.h"

namespace hodt {

struct TerrainInfo {
  std::string_view name;
  std::string_view description;
  std::size_t default_points = 0;
};

/// What sample_terrain knows, in the order to list it.
std::span<const TerrainInfo> built_in_terrains();

/// n points of a terrain (n = 0: its default_points) with heights, in metres; which ones depends on
/// the seed. The same arguments give the same points, to the bit, on any machine and on any number
/// of threads. Throws ParameterError for a name that is not in built_in_terrains(), and for more
/// points than the terrain has.
PointSet sample_terrain(std::string_view name, std::size_t n, std::uint64_t seed);

}  // namespace hodt
