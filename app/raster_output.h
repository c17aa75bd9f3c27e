// How a mesh becomes a raster on a map, for every subcommand that writes one.
// Tested by tests/app/raster_test.cpp.
#pragma once

#include <span>
#include <string>

#include "app/outputs.h"

#include "hodt/tin/raster.h"

namespace hodt::app {

struct RasterArguments {
  std::string resolution;
  std::string like;
  std::string hillshade;

  bool any() const { return !resolution.empty() || !like.empty() || !hillshade.empty(); }
};

/// The options --resolution, --like and --hillshade.
void add_raster_options(CLI::App& command, RasterArguments& arguments);

/// All that can be said before there is a mesh; `output` is the raster of heights, empty if there
/// is to be none. Throws ParameterError unless the names are those of rasters and the cells are
/// given in one way, and if one of the files is one of the others, of those that are read, or that
/// are written; FileError if it cannot be written.
void check_raster(const RasterArguments& arguments, const std::string& output,
                  std::span<const std::string> read, std::span<const std::string> written);

/// The cells over points: those of --like, or as large as --resolution says. Throws InputError if
/// the raster is of another coordinate reference system than the points, which errors call `name`,
/// and ParameterError if there are too many.
Grid grid_of(const RasterArguments& arguments, const PointSet& points, const std::string& crs,
             const std::string& name);

/// Writes the rasters that were asked for, heights to `output` unless it is empty.
void write_rasters(const Tin& tin, const Grid& grid, const RasterArguments& arguments,
                   const std::string& output, Outputs& outputs, const Progress& progress);

}  // namespace hodt::app
