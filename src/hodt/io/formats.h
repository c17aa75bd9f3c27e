// Every format of files that hodt reads or writes: a line each in formats.cpp, with what it
// carries. Tested by tests/io/formats_test.cpp.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hodt/geometry/point_set.h"
#include "hodt/io/atomic_write.h"
#include "hodt/io/feature_layer.h"
#include "hodt/io/features.h"
#include "hodt/io/point_table.h"
#include "hodt/tin/tin.h"

namespace hodt {

/// What a mesh keeps when hodt writes it.
struct Keeps {
  bool heights = false;  ///< every bit of them, and of x and y
  bool crs = false;      ///< the coordinate reference system
  bool order = false;    ///< the order of each triangle
};

/// A format. What it cannot do is nullptr. The functions throw what those of point_file.h,
/// places_file.h, line_file.h, tin_file.h and feature_file.h do, which are what users call.
struct Format {
  std::string_view name;
  /// Of file names: in lower case, separated by spaces.
  std::string_view extensions;
  /// Whether it may be packed with gzip, and the name end in .gz. Meshes are never written so.
  bool can_be_packed = false;
  PointTable (*read_points)(const std::filesystem::path&, const PointChoice&) = nullptr;
  /// Of the layer of that name; empty: the only one. Returns the coordinate reference system.
  std::string (*read_features)(const std::filesystem::path&, const std::string& layer,
                               const FeatureTaker&) = nullptr;
  Tin (*read_tin)(const std::filesystem::path&) = nullptr;
  void (*write_points)(const PointSet&, OutputFile&) = nullptr;
  void (*write_tin)(const Tin&, OutputFile&) = nullptr;
  void (*write_features)(const FeatureLayer&, OutputFile&) = nullptr;
  Keeps keeps = {};
};

std::span<const Format> formats();

/// Each by itself: ".tif" and ".tiff".
std::vector<std::string_view> extensions_of(const Format& format);

/// Whether hodt was built with the formats that need GDAL. If not, using one throws ParameterError.
bool has_gdal();

enum class Use { read_points, read_features, read_tin, write_points, write_tin, write_features };

bool can(const Format& format, Use use);

/// The format that the name tells, of those that can be used so; nullptr if there is none.
const Format* find_format(const std::filesystem::path& path, Use use);

/// The same, or ParameterError with the known extensions.
const Format& format_for(const std::filesystem::path& path, Use use);

}  // namespace hodt
