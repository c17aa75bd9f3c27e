#include "hodt/io/raster_file.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/file_name.h"
#include "hodt/io/gdal/raster.h"
#include "hodt/io/input_text.h"

namespace hodt {

namespace {

/// A whole number of tiles, so that each is packed once.
constexpr std::size_t kRowsAtOnce = 256;

/// Has values(row, triangles, out) computed for some rows after the other, and writes them.
template <class Value, class Values>
void write_rows(const Tin& tin, const Grid& grid, double no_data, OutputFile& file,
                const Values& values) {
  file.fill_by_name([&](const std::filesystem::path& path) {
    RasterWriter writer(path, grid, tin.crs, RasterType{sizeof(Value)}, no_data);
    const CellTriangles cells(tin, grid);
    std::vector<Index> triangles;
    std::vector<Value> out;
    for (std::size_t row = 0; row < grid.rows; row += kRowsAtOnce) {
      const std::size_t count = std::min(kRowsAtOnce, grid.rows - row) * grid.columns;
      triangles.resize(count);
      out.resize(count);
      cells.fill(row, triangles);
      values(row, triangles, out);
      writer.write(row, count / grid.columns, out.data());
    }
    writer.finish();
  });
}

}  // namespace

void write_heights(const Tin& tin, const Grid& grid, OutputFile& file) {
  write_rows<double>(
      tin, grid, std::numeric_limits<double>::quiet_NaN(), file,
      [&](std::size_t row, const std::vector<Index>& triangles, std::vector<double>& heights) {
        heights_of_cells(tin, grid, row, triangles, heights);
      });
}

void write_hillshade(const Tin& tin, const Grid& grid, OutputFile& file) {
  const Hillshade hillshade(tin);
  write_rows<unsigned char>(
      tin, grid, 0, file,
      [&](std::size_t, const std::vector<Index>& triangles, std::vector<unsigned char>& shades) {
        hillshade.shades_of_cells(triangles, shades);
      });
}

bool is_raster_name(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  return extension == ".tif" || extension == ".tiff";
}

void check_raster_output(const std::filesystem::path& path) {
  if (!is_raster_name(path))
    throw ParameterError(
        fmt::format("cannot write a raster to {}: known are .tif, .tiff", display_name(path)));
  require_gdal();
}

}  // namespace hodt
