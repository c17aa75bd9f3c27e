#include "hodt/io/raster_file.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/file_name.h"
#include "hodt/io/gdal/raster.h"

namespace hodt {

namespace {

/// How many rows are computed and written at once: as high as tiles are, so that each is packed
/// once, and fewer in a wide raster, so that memory holds them.
std::size_t rows_at_once(const Grid& grid) {
  constexpr std::size_t most_cells = std::size_t{1} << 26, multiple = 16;
  return std::clamp<std::size_t>(most_cells / grid.columns / multiple * multiple, multiple, 256);
}

/// Has values(row, triangles, out) computed for some rows after the other, and writes them.
template <class Value, class Values>
void write_rows(const Tin& tin, const Grid& grid, double no_data, OutputFile& file,
                const Progress& progress, const Values& values) {
  check_size(grid);
  const std::size_t rows_in_batch = rows_at_once(grid);
  file.fill_by_name([&](const std::filesystem::path& path) {
    RasterWriter writer(path, grid, tin.crs, RasterType{sizeof(Value)}, no_data, rows_in_batch);
    const CellTriangles cells(tin, grid);
    std::vector<Index> triangles;
    std::vector<Value> out;
    bool is_empty = true;
    for (std::size_t row = 0; row < grid.rows; row += rows_in_batch) {
      if (progress) progress("raster", double(row) / double(grid.rows));
      const std::size_t count = std::min(rows_in_batch, grid.rows - row) * grid.columns;
      triangles.resize(count);
      out.resize(count);
      cells.fill(row, triangles);
      is_empty = is_empty && std::all_of(triangles.begin(), triangles.end(),
                                         [](Index triangle) { return triangle == kNone; });
      values(row, triangles, out);
      writer.write(row, count / grid.columns, out.data());
    }
    if (is_empty)
      throw InputError(
          fmt::format("cannot write {}: the centre of no cell is on the mesh; choose smaller "
                      "cells, or a raster "
                      "of the same place",
                      file.path().string()));
    writer.finish();
  });
  file.outdate(".ovr .ovr.ovr .msk .msk.ovr .aux.xml");
}

}  // namespace

void write_heights(const Tin& tin, const Grid& grid, OutputFile& file, const Progress& progress) {
  write_rows<double>(
      tin, grid, std::numeric_limits<double>::quiet_NaN(), file, progress,
      [&](std::size_t row, const std::vector<Index>& triangles, std::vector<double>& heights) {
        heights_of_cells(tin, grid, row, triangles, heights);
      });
}

void write_hillshade(const Tin& tin, const Grid& grid, OutputFile& file, const Progress& progress) {
  const Hillshade hillshade(tin);
  write_rows<unsigned char>(
      tin, grid, 0, file, progress,
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
        fmt::format("cannot write a raster to {}: known are .tif, .tiff", output_name(path)));
  require_gdal();
}

}  // namespace hodt
