// Rasters that GDAL writes, and where the cells of those are that it reads.
// Tested by tests/io/raster_file_test.cpp.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>

#include "hodt/tin/raster.h"

namespace hodt {

/// By the bytes of a cell.
enum class RasterType : std::size_t { shade = 1, height = 8 };

/// A GeoTIFF with one band, packed without loss, written from row to row.
class RasterWriter {
 public:
  /// Tiles are of so many rows, a multiple of 16. Throws FileError if there cannot be such a file.
  RasterWriter(const std::filesystem::path& path, const Grid& grid, const std::string& crs,
               RasterType type, double no_data, std::size_t tile_rows);
  ~RasterWriter();
  RasterWriter(const RasterWriter&) = delete;
  RasterWriter& operator=(const RasterWriter&) = delete;

  /// Of the raster's type, row after row.
  void write(std::size_t first_row, std::size_t rows, void* cells);
  /// All is in the file. Throws FileError if it is not.
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Loads GDAL. Throws ParameterError if it is not there.
void require_gdal();

}  // namespace hodt
