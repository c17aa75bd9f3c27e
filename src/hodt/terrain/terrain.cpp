#include "hodt/terrain/terrain.h"

#include <array>
#include <string>

#include "hodt/base/error.h"
#include "hodt/terrain/jacksboro.h"
#include "hodt/terrain/valley.h"

namespace hodt {
namespace {

struct Terrain {
  TerrainInfo info;
  std::size_t most_points;
  PointSet (*sample)(std::size_t n, std::uint64_t seed);
};

constexpr std::array kTerrains = {
    Terrain{
        {"jacksboro", "mountains and valleys near Jacksboro, Tennessee (SRTM)", kJacksboroPoints},
        kJacksboroPoints,
        sample_jacksboro},
    Terrain{{"valley", "a made-up landscape cut by rivers, free of pits, of any size", 100'000},
            kMostValleyPoints,
            sample_valley},
};

constexpr auto kInfos = [] {
  std::array<TerrainInfo, kTerrains.size()> infos;
  for (std::size_t i = 0; i < infos.size(); ++i) infos[i] = kTerrains[i].info;
  return infos;
}();

const Terrain& terrain_named(std::string_view name) {
  std::string known;
  for (const Terrain& terrain : kTerrains) {
    if (terrain.info.name == name) return terrain;
    known += known.empty() ? "" : ", ";
    known += terrain.info.name;
  }
  throw ParameterError("no built-in terrain is called '" + std::string(name) +
                       "'; there are: " + known);
}

}  // namespace

std::span<const TerrainInfo> built_in_terrains() {
  return kInfos;
}

PointSet sample_terrain(std::string_view name, std::size_t n, std::uint64_t seed) {
  const Terrain& terrain = terrain_named(name);
  if (n > terrain.most_points) {
    throw ParameterError("terrain '" + std::string(name) + "' gives at most " +
                         std::to_string(terrain.most_points) + " points, not " + std::to_string(n));
  }
  return terrain.sample(n == 0 ? terrain.info.default_points : n, seed);
}

}  // namespace hodt
