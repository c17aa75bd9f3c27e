// hodt triangulate: points in, a mesh out.
// Tested by tests/app/command_test.cpp.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/constraints_input.h"
#include "app/duplicates_text.h"
#include "app/keep.h"
#include "app/layer_file.h"
#include "app/mean_angle.h"
#include "app/outputs.h"
#include "app/picture_output.h"
#include "app/points_input.h"
#include "app/raster_output.h"
#include "app/source.h"
#include "app/warning.h"
#include "app/what_changed.h"
#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/base/parallel.h"
#include "hodt/io/formats.h"
#include "hodt/io/raster_file.h"
#include "hodt/io/tin_file.h"
#include "hodt/pipeline.h"

namespace hodt::app {

namespace {

struct Arguments {
  PointsInput input;
  std::string output;
  std::string order;
  std::string objective = "min-local-minima";
  std::string method = "auto";
  std::string time_limit;
  KeepArguments keep;
  ChangesArguments changes;
  PictureArguments picture;
  ConstraintArguments constraints;
  RasterArguments raster;
  std::string threads;
  std::string json;
};

/// The same count of both triangulations, as JSON.
Json extrema_json(const Report& report, SplitCount ExtremaCount::*count) {
  if (!report.extrema_delaunay || !report.extrema_result) return nullptr;
  return {{"delaunay", to_json((*report.extrema_delaunay).*count)},
          {"result", to_json((*report.extrema_result).*count)}};
}

Json value_json(const Value& value) {
  return {{"delaunay", to_json(value.delaunay)},
          {"result", to_json(value.result)},
          {"bound", to_json(value.bound)},
          {"optimal", value.optimal}};
}

Json value_json(const Report& report) {
  if (!report.value) return nullptr;
  Json json = value_json(*report.value);
  if (report.given) json["input"] = to_json(report.given->value);
  return json;
}

/// Of the objectives that are not the first.
Json then_json(const Report& report) {
  Json list = Json::array();
  for (std::size_t i = 0; i < report.then.size(); ++i) {
    const LaterValue& later = report.then[i];
    Json value = value_json(later.value);
    value["bound_in_order"] = later.is_bound_in_order;
    if (report.given) value["input"] = to_json(report.given->then[i]);
    list.push_back({{"objective", name_of(later.objective)}, {"value", std::move(value)}});
  }
  return list;
}

/// Of a sum of angles.
Json mean_json(const Report& report) {
  const std::optional<double> count = angles_in_sum(report);
  if (!report.value || !count) return nullptr;
  return {{"delaunay", to_json(report.value->delaunay / *count)},
          {"result", to_json(report.value->result / *count)},
          {"bound", to_json(report.value->bound / *count)}};
}

/// Of a mesh that was to be improved.
Json given_json(const Report& report, const Source& source) {
  if (!source.is_tin) return nullptr;
  return {{"order", report.given ? Json(report.given->order) : Json(nullptr)},
          {"is_result", report.given && report.given->is_kept},
          {"unused_vertices", source.unused_vertices}};
}

Json report_json(const Report& report, const Order& k, const Source& source,
                 const Json& constraints) {
  return {{"points", report.points},
          {"files", std::max<std::size_t>(1, source.input.files.size())},
          {"columns", columns_json(source.input)},
          {"crs", crs_json(source.input.crs)},
          {"input", given_json(report, source)},
          {"duplicates", report.duplicates},
          {"duplicate_rule", name_of(source.input.rule)},
          {"duplicate_heights", heights_json(report.duplicate_heights)},
          {"constraints", constraints},
          {"triangles", report.triangles},
          {"k", to_json(k)},
          {"order", report.order},
          {"order_histogram", report.order_histogram},
          {"objective", name_of(report.objective)},
          {"kept", report.kept},
          {"polygons_without_points", report.empty_polygons},
          {"value", value_json(report)},
          {"then", then_json(report)},
          {"mean", mean_json(report)},
          {"local_minima", extrema_json(report, &ExtremaCount::minima)},
          {"local_maxima", extrema_json(report, &ExtremaCount::maxima)},
          {"pits", extrema_json(report, &ExtremaCount::pits)},
          {"seconds",
           {{"read", report.seconds.read},
            {"delaunay", report.seconds.delaunay},
            {"optimize", report.seconds.optimize},
            {"write", report.seconds.write}}}};
}

std::string extrema_line(std::string_view name, const Report& report,
                         SplitCount ExtremaCount::*count) {
  if (!report.extrema_delaunay || !report.extrema_result) return {};
  const SplitCount& before = (*report.extrema_delaunay).*count;
  const SplitCount& after = (*report.extrema_result).*count;
  return fmt::format("{:<13} {} -> {} (interior {} -> {}, boundary {} -> {})\n", name,
                     before.total(), after.total(), before.interior, after.interior,
                     before.boundary, after.boundary);
}

std::string summary(const Report& report, const Source& source, const std::string& constraints,
                    const Arguments& arguments) {
  std::string text = fmt::format("{:<13} {}, {}\n", "points", report.points,
                                 dropped_text(report.duplicates, report.duplicate_heights));
  text += inputs_text(source.input, 13);
  text += constraints;
  if (report.given)
    text += fmt::format("{:<13} a mesh of order {}{}{}\n", "input", report.given->order,
                        report.given->is_kept ? ", of which nothing better was found" : "",
                        source.unused_vertices > 0
                            ? fmt::format("; {} of no triangle left out",
                                          counted(source.unused_vertices, "vertex", "vertices"))
                            : "");
  text += fmt::format("{:<13} {}, of order {} at most (allowed: {})\n", "triangles",
                      report.triangles, report.order, parse_order(arguments.order).digits);
  const auto value_line = [&](const Objective& objective, double given, const Value& value) {
    return fmt::format("{:<13} {}{} -> {}, proven bound {}{}", name_of(objective),
                       report.given ? fmt::format("{} (input), ", given) : "", value.delaunay,
                       value.result, value.bound, value.optimal ? ": optimal" : "");
  };
  if (report.value) {
    text +=
        value_line(report.objective, report.given ? report.given->value : 0, *report.value) + "\n";
    if (const std::optional<double> count = angles_in_sum(report))
      text += fmt::format("{:<13} {:.4f}° -> {:.4f}°, proven bound {:.4f}°\n", "mean angle",
                          report.value->delaunay / *count, report.value->result / *count,
                          report.value->bound / *count);
    for (std::size_t i = 0; i < report.then.size(); ++i) {
      const LaterValue& later = report.then[i];
      text += value_line(later.objective, report.given ? report.given->then[i] : 0, later.value) +
              (later.is_bound_in_order || later.value.optimal ? "\n" : " (whatever is before)\n");
    }
  }
  if (arguments.keep.any())
    text += fmt::format("{:<13} {}\n", "kept", kept_text(report.kept, report.empty_polygons));
  text += extrema_line("local minima", report, &ExtremaCount::minima);
  text += extrema_line("local maxima", report, &ExtremaCount::maxima);
  text += extrema_line("pits", report, &ExtremaCount::pits);
  const Seconds& seconds = report.seconds;
  text += fmt::format("{:<13} read {:.3f}, delaunay {:.3f}, optimize {:.3f}, write {:.3f}\n",
                      "seconds", seconds.read, seconds.delaunay, seconds.optimize, seconds.write);
  return text + fmt::format("{:<13} {}\n", "written", shown(arguments.output));
}

TriangulateOptions options_of(const Arguments& arguments) {
  TriangulateOptions options;
  options.order = parse_order(arguments.order).limit;
  options.then = objectives_from_names(arguments.objective);
  options.objective = options.then.front();
  options.then.erase(options.then.begin());
  options.method = method_from_name(arguments.method);
  check_method(options.method, options.objective);
  for (const Objective& objective : options.then) check_method(options.method, objective);
  options.time_limit = parse_seconds(arguments.time_limit);
  read_keep(arguments.keep, arguments.input, options);
  return options;
}

/// All files that are read.
std::vector<std::string> inputs_of(const Arguments& arguments) {
  std::vector<std::string> files = arguments.input.files;
  for (const std::string& file : arguments.constraints.breaklines)
    files.push_back(layer_file(file).file);
  for (const std::string& file :
       {arguments.keep.places, arguments.constraints.outline, arguments.constraints.keep_edges})
    files.push_back(layer_file(file).file);
  return files;
}

int run(const Arguments& arguments) {
  // All that can be refused is refused before the work begins.
  TriangulateOptions options = options_of(arguments);
  const ThreadLimit limit(parse_threads(arguments.threads));
  check_choices(arguments.input);
  const bool is_raster = is_raster_name(arguments.output);
  const bool makes_raster = is_raster || arguments.raster.any();
  if (!is_raster) {
    check_output_extension(arguments.output);
    options.tell_orders = format_for(arguments.output, Use::write_tin).keeps.order;
  }
  if (makes_raster)
    check_raster(
        arguments.raster, is_raster ? arguments.output : "", inputs_of(arguments),
        {{arguments.output, arguments.json, arguments.changes.pits, arguments.changes.changed}});
  check_targets(arguments.input, arguments.output, arguments.json);
  check_targets(layer_file(arguments.keep.places).file, arguments.output, arguments.json);
  const std::string input = arguments.input.name();
  check_constraints(arguments.constraints, input, arguments.output, arguments.json);

  check_changes(arguments.changes, inputs_of(arguments), {{arguments.output, arguments.json}});
  const bool draws_kept = arguments.picture.any() && arguments.keep.any();
  options.tell_changes = arguments.changes.any() || draws_kept;
  check_picture(arguments.picture, inputs_of(arguments),
                {{arguments.output, arguments.json, arguments.raster.hillshade,
                  arguments.changes.pits, arguments.changes.changed}});
  options.tell_delaunay = arguments.picture.any();
  options.tell_orders |= arguments.picture.any();

  Stopwatch watch;
  TriangulateResult result;
  Outputs outputs;
  Source source;
  std::string constraints_lines;
  Json constraints;
  {
    TerminalProgress progress;
    progress.report("reading");
    source = read_source(arguments.input);
    source.input.system.add(options.keep.source, options.keep.crs);
    Joined joined = read_constraints(arguments.constraints, input, source.input.system,
                                     std::move(source.input.points), source.numbers,
                                     source.constraints.triangles);
    if (source.is_tin) add_given(source.constraints, input, joined);
    // Cells that are too many are so before the work begins, unless a part of the terrain is cut
    // out.
    const bool is_whole =
        arguments.constraints.outline.empty() && arguments.constraints.max_edge.empty();
    std::optional<Grid> grid;
    if (makes_raster && is_whole)
      grid = grid_of(arguments.raster, joined.points, source.input.crs, input);
    const double read = watch.lap();
    const Progress report = [&](std::string_view phase, double done) {
      progress.report(phase, done);
    };
    options.progress = report;
    result = triangulate_joined(input, joined, options);
    if (source.input.duplicates) result.report.duplicate_heights = source.input.duplicates;
    if (arguments.constraints.any()) {
      constraints_lines = constraints_text(joined.report, result.report.constraints);
      constraints = constraints_json(joined.report, result.report.constraints);
    }
    result.report.seconds.read = read;
    progress.report("writing");
    watch.lap();
    if (makes_raster && !grid)
      grid = grid_of(arguments.raster, result.tin.points, result.tin.crs, input);
    if (grid)
      write_rasters(result.tin, *grid, arguments.raster, is_raster ? arguments.output : "", outputs,
                    report);
    if (!is_raster) write_tin(result.tin, outputs.open(arguments.output));
    write_changes(arguments.changes, result, outputs);
    write_picture(arguments.picture, input, parse_order(arguments.order).digits, result, joined,
                  outputs);
    result.report.seconds.write = watch.lap();
    if (!is_raster) warn_of_rounding(arguments.output, result.tin);
    print_warnings(source.input);
    print_warnings(joined);
    print_warnings(options.keep);
  }
  outputs.write_json(report_json(result.report, parse_order(arguments.order), source, constraints),
                     arguments.json);
  outputs.commit(summary(result.report, source, constraints_lines, arguments));
  return kOk;
}

}  // namespace

void add_triangulate(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App& command =
      *app.add_subcommand("triangulate", "Triangulate points, with low order and few pits");
  add_points_input(command, arguments->input);
  command
      .add_option(
          "-o,--output", arguments->output,
          "Mesh to write: .ply, .obj, .vtu, .gpkg or others ('hodt formats' lists all), or\n"
          "a raster: .tif")
      ->required()
      ->type_name("OUTPUT");
  const CLI::Option* const order =
      command
          .add_option(
              "-k,--order", arguments->order,
              "Points allowed inside a circumcircle; 0 is Delaunay (default: 4, for terrain 8)")
          ->type_name("K");
  command
      .add_option("--objective", arguments->objective,
                  "What to optimise (default: min-local-minima); of a list A,B or A,B,C then B\n"
                  "among the triangulations that are as good for A, and so on; terrain is\n"
                  "min-local-minima,min-sum-abn, which drains and is near to the land")
      ->type_name("OBJ");
  command
      .add_option("--method", arguments->method,
                  "auto, greedy (for extrema), flip or exact (default: auto)")
      ->type_name("M");
  command
      .add_option("--time-limit", arguments->time_limit,
                  "Seconds that the search may take (default: 0, no limit)")
      ->type_name("S");
  add_keep(command, arguments->keep);
  add_changes(command, arguments->changes);
  add_picture(command, arguments->picture);
  add_constraints(command, arguments->constraints);
  add_raster_options(command, arguments->raster);
  add_threads(command, arguments->threads);
  command.add_option("--json", arguments->json, "Write a report as JSON; - is standard output")
      ->type_name("FILE");
  command.footer(
      "Objectives: min-local-minima, min-local-maxima, min-local-extrema, min-max-degree, none,\n"
      "and <min|max>-<sum|max|min>-MEASURE, where MEASURE is one of area, angle, small-angle,\n"
      "circumradius, enclosing-radius, inradius, length, flat-area, abn, jnd, wabn.\n"
      "Examples:\n"
      "  hodt triangulate terrain.csv -o terrain.ply\n"
      "  hodt triangulate survey.txt --columns x=3,y=2,z=4 -o survey.ply\n"
      "  hodt triangulate tile1.tif tile2.tif --stride 2 -o tiles.ply\n"
      "  hodt triangulate survey.gpkg --layer spots --z-field height -o survey.ply\n"
      "  hodt triangulate mesh.ply -o better.ply --objective min-max-angle\n"
      "  hodt triangulate survey.csv -o smooth.ply --objective terrain\n"
      "  hodt triangulate survey.csv --breaklines roads.geojson --outline area.geojson -o "
      "site.ply\n"
      "  hodt triangulate tile.laz -o dem.tif --resolution 1 --hillshade shade.tif\n"
      "  hodt triangulate terrain.xyz.gz -o terrain.obj -k 8 --json report.json\n"
      "  hodt sample valley | hodt triangulate - -o valley.ply -k 2");
  command.callback([arguments, order, &action] {
    if (order->empty()) arguments->order = fmt::to_string(usual_order(arguments->objective));
    action = [arguments] { return run(*arguments); };
  });
}

}  // namespace hodt::app
