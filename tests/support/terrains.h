// Real terrains, where the machine has them: HODT_DATA, or what CMake was told.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#include "hodt/geometry/point_set.h"
#include "hodt/io/point_file.h"

namespace support {

/// The folder of a terrain, if it is there.
inline std::optional<std::filesystem::path> terrain_folder(const std::string& name) {
  const char* variable = std::getenv("HODT_DATA");
  const std::filesystem::path directory = variable ? variable : HODT_DATA_DIR;
  if (directory.empty() || !std::filesystem::exists(directory / name)) return std::nullopt;
  return directory / name;
}

/// The 10,000-point sample of a terrain, if it is there.
inline std::optional<hodt::PointSet> terrain_sample(const std::string& name) {
  const auto folder = terrain_folder(name);
  if (!folder || !std::filesystem::exists(*folder / "sample10000.csv")) return std::nullopt;
  return hodt::read_points(*folder / "sample10000.csv");
}

/// For GTEST_SKIP.
inline std::string no_terrain(const std::string& name) {
  return "no terrain " + name + ": set HODT_DATA to a directory with " + name;
}

}  // namespace support
