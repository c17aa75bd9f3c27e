// What GDAL's programs read from a file of features: they share nothing with hodt.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "hodt/io/formats.h"

namespace hodt::test {

/// Whether the Debian package gdal-bin is there.
inline bool has_ogr() {
  static const bool found = std::system("command -v ogr2ogr ogrinfo >/dev/null") == 0;
  return found;
}

/// Whether this hodt writes files with that extension: some it leaves to GDAL.
inline bool writes(std::string_view extension) {
  return has_gdal() || (extension != ".fgb" && extension != ".shp");
}

/// What a shell command prints; throws if it fails.
inline std::string printed_by(const std::string& command) {
  std::FILE* const pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
  std::string text;
  std::array<char, 4096> bytes;
  while (const std::size_t read = std::fread(bytes.data(), 1, bytes.size(), pipe))
    text.append(bytes.data(), read);
  if (::pclose(pipe) != 0) throw std::runtime_error("failed: " + command + "\n" + text);
  return text;
}

/// "ogrinfo -so -al": the layers with their extents, fields and systems.
inline std::string ogrinfo(const std::filesystem::path& path) {
  return printed_by("ogrinfo -so -al '" + path.string() + "' 2>&1");
}

/// A feature as ogr2ogr reads it.
struct OgrFeature {
  unsigned type = 0;                             ///< of its geometry: 1001 is Point Z
  std::vector<std::array<double, 3>> positions;  ///< bit for bit; a ring repeats its first one
  std::vector<std::string> values;               ///< "\\N" is NULL
};

/// Well-known binary in hexadecimal digits, little-endian, as PostGIS has it.
class HexGeometry {
 public:
  explicit HexGeometry(const std::string& digits) {
    for (std::size_t i = 0; i + 1 < digits.size(); i += 2)
      bytes_ += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
  }
  void read(OgrFeature& feature) {
    constexpr std::uint32_t has_z = 0x80000000, has_srid = 0x20000000;
    if (take<std::uint8_t>() != 1) throw std::runtime_error("not little-endian");
    const auto type = take<std::uint32_t>();
    if (type & has_srid) take<std::uint32_t>();
    const bool z = type & has_z;
    const std::uint32_t kind = type & 0xFF;
    feature.type = kind + (z ? 1000 : 0);
    if (kind == 1) return take_positions(feature, 1, z);
    if (kind == 3 && take<std::uint32_t>() != 1) throw std::runtime_error("not one ring");
    if (kind > 3) throw std::runtime_error("geometry of several parts");
    take_positions(feature, take<std::uint32_t>(), z);
  }

 private:
  void take_positions(OgrFeature& feature, std::size_t count, bool z) {
    for (std::size_t i = 0; i < count; ++i) {
      const double x = take<double>(), y = take<double>();
      feature.positions.push_back({x, y, z ? take<double>() : 0});
    }
  }
  template <class T>
  T take() {
    T value;
    if (at_ + sizeof value > bytes_.size()) throw std::runtime_error("geometry cut off");
    std::memcpy(&value, bytes_.data() + at_, sizeof value);
    at_ += sizeof value;
    return value;
  }

  std::string bytes_;
  std::size_t at_ = 0;
};

/// Has a ring run counter-clockwise from its lexicographically least corner. Formats differ in
/// that.
inline void normalise_ring(std::vector<std::array<double, 3>>& ring) {
  ring.pop_back();
  double area = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i)
    area += (ring[i][0] - ring[0][0]) * (ring[i + 1][1] - ring[0][1]) -
            (ring[i][1] - ring[0][1]) * (ring[i + 1][0] - ring[0][0]);
  if (area < 0) std::reverse(ring.begin(), ring.end());
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  ring.push_back(ring.front());
}

/// All features of the file's only layer, sorted by their first positions: formats with an index
/// sort as they like.
inline std::vector<OgrFeature> ogr_features(const std::filesystem::path& path) {
  const std::string dump = printed_by("ogr2ogr -f PGDump /vsistdout/ '" + path.string() +
                                      "' --config PG_USE_COPY YES -lco FID=ogr_dump_id"
                                      " -nln dump 2>/dev/null");
  std::vector<OgrFeature> features;
  std::istringstream lines(dump);
  bool in_copy = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("COPY")) {
      in_copy = true;
    } else if (line == "\\.") {
      in_copy = false;
    } else if (in_copy) {
      OgrFeature feature;
      std::istringstream cells(line);
      std::string cell;
      std::getline(cells, cell, '\t');
      HexGeometry(cell).read(feature);
      while (std::getline(cells, cell, '\t')) feature.values.push_back(cell);
      if (feature.type % 1000 == 3) normalise_ring(feature.positions);
      features.push_back(feature);
    }
  }
  std::sort(features.begin(), features.end(),
            [](const auto& a, const auto& b) { return a.positions[0] < b.positions[0]; });
  return features;
}

}  // namespace hodt::test
