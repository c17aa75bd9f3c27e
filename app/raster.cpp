// hodt raster: a mesh sampled at the centres of cells.
// Tested by tests/app/raster_test.cpp.
#include <string>

#include "app/raster_output.h"
#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/base/parallel.h"
#include "hodt/io/tin_file.h"
#include "hodt/tin/embedding.h"

namespace hodt::app {

namespace {

struct Arguments {
  std::string tin;
  std::string output;
  RasterArguments raster;
  std::string threads;
};

/// The mesh, of which every place has one height.
Tin read_surface(const std::string& file) {
  Tin tin = read_tin(file);
  const Embedding embedding = check_embedding(tin.points.xy, tin.triangles);
  if (!embedding.embedded)
    throw InputError(fmt::format("{}: there is no raster of such a mesh: {}", display_name(file),
                                 embedding.problem));
  return tin;
}

int run(const Arguments& arguments) {
  const ThreadLimit limit(parse_threads(arguments.threads));
  check_raster(arguments.raster, arguments.output, {{arguments.tin}}, {{arguments.output}});
  Outputs outputs;
  Grid grid;
  {
    TerminalProgress progress;
    progress.report("reading");
    const Tin tin = read_surface(arguments.tin);
    grid = grid_of(arguments.raster, tin.points, tin.crs, arguments.tin);
    progress.report("writing");
    naming(arguments.tin, [&] {
      write_rasters(tin, grid, arguments.raster, arguments.output, outputs,
                    [&](std::string_view phase, double done) { progress.report(phase, done); });
    });
  }
  std::string text = fmt::format("{:<8} {} columns, {} rows of cells of {} by {}\n", "raster",
                                 grid.columns, grid.rows, grid.width, grid.height);
  text += fmt::format("{:<8} {}\n", "written", shown(arguments.output));
  if (!arguments.raster.hillshade.empty())
    text += fmt::format("{:<8} {}\n", "written", shown(arguments.raster.hillshade));
  outputs.commit(text);
  return kOk;
}

}  // namespace

void add_raster(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App& command = *app.add_subcommand("raster", "Sample a mesh on a raster");
  command.add_option("TIN", arguments->tin, "Mesh: .obj or .ply, also .gz; - is standard input")
      ->required();
  command
      .add_option("-o,--output", arguments->output,
                  "Raster to write: .tif (GeoTIFF), heights as doubles")
      ->required()
      ->type_name("OUTPUT");
  add_raster_options(command, arguments->raster);
  add_threads(command, arguments->threads);
  command.footer(
      "A cell has the height of the surface at its centre: at a vertex exactly the vertex's.\n"
      "Cells whose centres are outside of the mesh have no data.\n"
      "Examples:\n"
      "  hodt raster terrain.ply --resolution 10 -o dem.tif\n"
      "  hodt raster terrain.ply --like dem.tif -o tin.tif --hillshade shade.tif");
  command.callback([arguments, &action] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace hodt::app
