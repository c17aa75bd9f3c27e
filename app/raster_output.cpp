#include "app/raster_output.h"

#include "app/points_input.h"
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

void check_raster(const RasterArguments& arguments, const std::string& output,
                  std::span<const std::string> read, std::span<const std::string> written) {
  const std::string& shade = arguments.hillshade;
  if (output.empty() && shade.empty())
    throw ParameterError("--resolution and --like are for rasters: name one by -o or --hillshade");
  if (arguments.resolution.empty() == arguments.like.empty())
    throw ParameterError("a raster needs --resolution or --like, and not both");
  if (!arguments.resolution.empty() && parse_number("--resolution", arguments.resolution) <= 0)
    throw ParameterError("--resolution must be positive, not '" + arguments.resolution + "'");
  for (const std::string& file : {output, shade}) {
    if (file.empty()) continue;
    check_raster_output(file);
    check_targets(arguments.like, file, {});
    for (const std::string& input : read) check_targets(input, file, {});
  }
  check_other_outputs("--hillshade", shade, written);
}

Grid grid_of(const RasterArguments& arguments, const PointSet& points, const std::string& crs,
             const std::string& name) {
  if (arguments.like.empty())
    return naming(name, [&] {
      return grid_over(points.xy, parse_number("--resolution", arguments.resolution));
    });
  const GridOfFile like = read_grid(arguments.like);
  require_same_crs(name, crs, arguments.like, like.crs);
  naming(arguments.like, [&] { check_size(like.grid); });
  return like.grid;
}

void write_rasters(const Tin& tin, const Grid& grid, const RasterArguments& arguments,
                   const std::string& output, Outputs& outputs, const Progress& progress) {
  if (!tin.points.has_heights())
    throw ParameterError("a raster needs heights, and the mesh has none");
  if (!output.empty()) write_heights(tin, grid, outputs.open(output), progress);
  if (!arguments.hillshade.empty())
    write_hillshade(tin, grid, outputs.open(arguments.hillshade), progress);
}

}  // namespace hodt::app
