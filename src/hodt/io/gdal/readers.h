// What formats.cpp reads through GDAL.
// Tested by tests/io/gdal_test.cpp.
#pragma once

#include <filesystem>
#include <string>

#include "hodt/io/features.h"
#include "hodt/io/point_table.h"

namespace hodt {

/// The points of a layer; with choice.layer.vertices the vertices of its lines and polygons, too.
PointTable read_layer_points(const std::filesystem::path& path, const PointChoice& choice);

/// The centres of a raster's cells that have a value.
PointTable read_raster_points(const std::filesystem::path& path, const PointChoice& choice);

/// Hands what a layer holds to a taker, and returns the coordinate reference system.
std::string read_layer_features(const std::filesystem::path& path, const std::string& layer,
                                const FeatureTaker& taker);

}  // namespace hodt
