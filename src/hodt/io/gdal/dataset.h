// A file that GDAL has opened.
// Tested by tests/io/gdal_test.cpp.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "hodt/io/gdal/api.h"
#include "hodt/tin/raster.h"

namespace hodt {

struct CloseDataset {
  void operator()(GDALDatasetH dataset) const { gdal().GDALClose(dataset); }
};
using Dataset = std::unique_ptr<void, CloseDataset>;

enum class DatasetKind { raster, vector };

/// Opens a file to read it. Throws FileError if it cannot be read, InputError, with what GDAL says,
/// if GDAL cannot.
Dataset open_dataset(const std::filesystem::path& path, DatasetKind kind);

/// From the cells of a raster to the map: x = g[0] + column * g[1] + row * g[2], y likewise.
using Affine = std::array<double, 6>;

/// Throws InputError, with the name, if the raster says nothing of it or its cells have no size.
Affine affine_of(GDALDatasetH dataset, const std::string& name);

/// The cells, if their columns go east and their rows south.
std::optional<Grid> grid_of(GDALDatasetH dataset, const Affine& g);

}  // namespace hodt
