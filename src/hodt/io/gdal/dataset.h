// A file that GDAL has opened.
// Tested by tests/io/gdal_test.cpp.
#pragma once

#include <filesystem>
#include <memory>

#include "hodt/io/gdal/api.h"

namespace hodt {

struct CloseDataset {
  void operator()(GDALDatasetH dataset) const { gdal().GDALClose(dataset); }
};
using Dataset = std::unique_ptr<void, CloseDataset>;

enum class DatasetKind { raster, vector };

/// Opens a file to read it. Throws FileError if it cannot be read, InputError, with what GDAL says,
/// if GDAL cannot.
Dataset open_dataset(const std::filesystem::path& path, DatasetKind kind);

}  // namespace hodt
