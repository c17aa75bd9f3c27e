#include "app/raster_output.h"

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/raster_file.h"

namespace hodt::app {

void add_raster_options(CLI::App& command, RasterArguments& arguments) {
  command
      .add_option("--resolution", arguments.resolution,
                  "Of rasters: the width of a cell; borders of cells are at multiples of it")
      ->type_name("R");
  command.add_option("--like", arguments.like, "Of rasters: the cells of this raster")
      ->type_name("RASTER");
  command
      .add_option("--hillshade", arguments.hillshade,
                  "A raster to write of the surface lit from the north-west: .tif")
      ->type_name("FILE");
}

void check_raster(const RasterArguments& arguments, const std::string& input,
                  const std::string& output) {
  if (arguments.resolution.empty() == arguments.like.empty())
    throw ParameterError("a raster needs --resolution or --like, and not both");
  if (!arguments.resolution.empty() && parse_number("--resolution", arguments.resolution) <= 0)
    throw ParameterError("--resolution must be positive, not '" + arguments.resolution + "'");
  for (const std::string& file : {output, arguments.hillshade})
    if (!file.empty()) check_raster_output(file);
  check_targets(input, output, arguments.hillshade);
  check_targets(arguments.like, output, arguments.hillshade);
}

Grid grid_of(const RasterArguments& arguments, const Tin& tin) {
  if (arguments.like.empty())
    return grid_over(tin, parse_number("--resolution", arguments.resolution));
  const GridOfFile like = read_grid(arguments.like);
  if (!tin.crs.empty() && !like.crs.empty() && !is_same_crs(tin.crs, like.crs))
    throw InputError(fmt::format("{} is in {}, but the mesh is in {}; transform one of them",
                                 display_name(arguments.like), crs_title(like.crs),
                                 crs_title(tin.crs)));
  return like.grid;
}

void write_rasters(const Tin& tin, const Grid& grid, const RasterArguments& arguments,
                   const std::string& output, Outputs& outputs) {
  if (!tin.points.has_heights())
    throw ParameterError("a raster needs heights, and the mesh has none");
  if (!output.empty()) write_heights(tin, grid, outputs.open(output));
  if (!arguments.hillshade.empty()) write_hillshade(tin, grid, outputs.open(arguments.hillshade));
}

}  // namespace hodt::app
