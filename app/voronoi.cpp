// hodt voronoi: the cells of the order-m Voronoi diagram.
#include "hodt/order/voronoi/voronoi.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include "app/outputs.h"
#include "app/points_input.h"
#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/base/parallel.h"
#include "hodt/io/geojson.h"
#include "hodt/order/voronoi/voronoi_polygons.h"

namespace hodt::app {

namespace {

struct Arguments {
  PointsInput input;
  std::string output;
  std::string order;
  std::string box;
  std::string threads;
};

[[noreturn]] void refuse_box(const std::string& text) {
  throw ParameterError(fmt::format(
      "--box must be four numbers, xmin,ymin,xmax,ymax, with xmin < xmax and ymin < ymax, not '{}'",
      text));
}

Box parse_box(const std::string& text) {
  Box box;
  const char* at = text.data();
  const char* const end = at + text.size();
  for (double* value : {&box.low.x, &box.low.y, &box.high.x, &box.high.y}) {
    if (value != &box.low.x && (at == end || *at++ != ',')) refuse_box(text);
    const auto [rest, error] = std::from_chars(at, end, *value);
    if (error != std::errc() || !std::isfinite(*value)) refuse_box(text);
    at = rest;
  }
  if (at != end || !(box.low.x < box.high.x && box.low.y < box.high.y)) refuse_box(text);
  return box;
}

/// Writes the cells that have an area in the box; returns their number.
std::size_t write_cells(const VoronoiDiagram& diagram, const VertexSet& vertices, const Box& box,
                        const std::string& crs, OutputFile& file) {
  const VoronoiPolygons polygons(vertices.xy, diagram, box);
  return write_geojson(file, crs, diagram.cell_count(), [&](std::size_t i, PolygonFeature& cell) {
    polygons.polygon_of(static_cast<Index>(i), cell.ring);
    cell.points.clear();
    for (const VertexId v : diagram.members_of(static_cast<Index>(i)))
      cell.points.push_back(vertices.row[v]);
    std::sort(cell.points.begin(), cell.points.end());
  });
}

int run(const Arguments& arguments) {
  const Order order = parse_order(arguments.order, "-m", 1);
  std::optional<Box> box;
  if (!arguments.box.empty()) box = parse_box(arguments.box);
  const ThreadLimit limit(parse_threads(arguments.threads));
  check_choices(arguments.input);
  check_targets(arguments.input, arguments.output, {});
  const std::string input = arguments.input.name();

  std::string summary;
  Outputs outputs;
  {
    TerminalProgress progress;
    progress.report("reading");
    const InputPoints read = read_input_points(arguments.input);
    const PointSet& points = read.points;
    progress.report("Voronoi diagram");
    const Delaunay triangulation = naming(input, [&] { return delaunay(points); });
    const std::size_t distinct = triangulation.vertices.size();
    if (order.limit >= distinct)
      throw ParameterError(
          fmt::format("{}: -m must be less than the number of distinct points, {}, not '{}'",
                      display_name(input), distinct, arguments.order));
    const VoronoiDiagram diagram = voronoi_diagram(DelaunayGraph(triangulation), order.limit);
    constexpr double margin = 0.1;
    if (!box) box = enlarged_bounding_box(triangulation.vertices.xy, margin);
    progress.report("writing");
    const std::size_t written = write_cells(diagram, triangulation.vertices, *box, points.crs,
                                            outputs.open(arguments.output));
    summary = fmt::format("{:<8} {}, {} dropped\n", "points", points.size(),
                          counted(points.size() - distinct, "duplicate"));
    summary += inputs_text(read, 8);
    summary += fmt::format("{:<8} {} of order {}, {} with an area in the box\n", "cells",
                           diagram.cell_count(), order.digits, written);
    summary += fmt::format("{:<8} {}\n", "written", shown(arguments.output));
    print_warnings(read);
  }
  outputs.commit(summary);
  return kOk;
}

}  // namespace

void add_voronoi(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App& command =
      *app.add_subcommand("voronoi", "Divide the plane by which m points are nearest");
  add_points_input(command, arguments->input);
  command.add_option("-m,--order", arguments->order, "How many nearest points; 1 is Voronoi")
      ->required()
      ->type_name("M");
  command
      .add_option("-o,--output", arguments->output,
                  "GeoJSON to write: a polygon for each cell, its points (data rows of the input,\n"
                  "from 0) as the property \"points\"; - is standard output")
      ->required()
      ->type_name("OUT");
  command
      .add_option("--box", arguments->box,
                  "Clip to xmin,ymin,xmax,ymax (default: around the points, with 10 % margin)")
      ->type_name("BOX");
  add_threads(command, arguments->threads);
  command.footer(
      "Examples:\n"
      "  hodt voronoi wells.csv -m 1 -o cells.geojson\n"
      "  hodt voronoi wells.csv -m 3 -o three-nearest.geojson --box 0,0,1000,800\n"
      "  hodt sample valley -n 1000 | hodt voronoi - -m 8 -o -");
  command.callback([arguments, &action] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace hodt::app
