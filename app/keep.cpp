#include "app/keep.h"

#include "app/layer_file.h"
#include "app/warning.h"
#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/places_file.h"

namespace hodt::app {

void add_keep(CLI::App& command, KeepArguments& arguments) {
  command
      .add_option(
          "--keep", arguments.places,
          "Real pits: points or polygons (GeoJSON, GeoPackage, Shapefile, ...) whose minima\n"
          "stay, in the coordinate system of INPUT; what is in a polygon's hole is not in it")
      ->type_name("FILE");
  command
      .add_option("--min-pit-depth", arguments.min_pit_depth,
                  "Only shallower pits are removed (default: all)")
      ->type_name("D");
}

void read_keep(const KeepArguments& arguments, const PointsInput& input,
               TriangulateOptions& options) {
  options.min_pit_depth = parse_non_negative("--min-pit-depth", "a depth", arguments.min_pit_depth);
  if (arguments.places.empty()) return;
  if (input.is_standard_input() && arguments.places == "-")
    throw ParameterError("INPUT and --keep cannot both be standard input");
  const auto [file, layer] = layer_file(arguments.places);
  options.keep = read_places(file, layer);
}

void print_warnings(const Places& keep) {
  for (const std::string& warning : keep.warnings) print_warning(keep.source, warning);
}

std::string kept_text(std::size_t kept, std::size_t empty_polygons) {
  std::string text = counted(kept, "local minimum", "local minima");
  if (empty_polygons > 0)
    text += fmt::format("; no point is in {}", counted(empty_polygons, "polygon"));
  return text;
}

}  // namespace hodt::app
