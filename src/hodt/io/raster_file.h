// Rasters of a TIN: GeoTIFF, through GDAL.
// Tested by tests/io/raster_file_test.cpp.
#pragma once

#include <filesystem>
#include <string>

#include "hodt/base/progress.h"
#include "hodt/io/atomic_write.h"
#include "hodt/tin/raster.h"

namespace hodt {

/// Writes heights at the centres of cells, as doubles; NaN, declared as no data, outside of the
/// mesh, which is embedded and has heights. A centre at a vertex has its height bit by bit. All
/// cores work; memory does not grow with the number of rows. Throws FileError, InputError if no
/// centre is on the mesh, and ParameterError without GDAL or if there are more cells than a raster
/// may have.
void write_heights(const Tin& tin, const Grid& grid, OutputFile& file,
                   const Progress& progress = {});

/// Writes shades (see Hillshade) as bytes; 0, declared as no data, outside.
void write_hillshade(const Tin& tin, const Grid& grid, OutputFile& file,
                     const Progress& progress = {});

/// A raster's cells, and its coordinate reference system.
struct GridOfFile {
  Grid grid;
  std::string crs;
};

/// Of any raster that GDAL reads. Throws FileError or InputError if it cannot be read, says nothing
/// of where it is, or its rows do not run from west to east and its columns from north to south.
GridOfFile read_grid(const std::filesystem::path& path);

/// Whether the name is one of a raster that hodt writes: .tif or .tiff.
bool is_raster_name(const std::filesystem::path& path);

/// Throws ParameterError unless the name is one of a raster, and GDAL is there.
void check_raster_output(const std::filesystem::path& path);

}  // namespace hodt
