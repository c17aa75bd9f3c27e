// hodt contours: the contour lines of a mesh.
// Tested by tests/app/contours_test.cpp.
#include "hodt/tin/contours.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "app/outputs.h"
#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/base/parallel.h"
#include "hodt/io/feature_file.h"
#include "hodt/io/tin_file.h"

namespace hodt::app {

namespace {

struct Arguments {
  std::string tin;
  std::string output;
  std::string interval;
  std::string base;
  std::string threads;
  std::string json;
};

/// Lines in space, each with its height and whether it closes.
FeatureLayer layer_of(const std::vector<ContourLine>& lines, const std::string& crs) {
  FeatureLayer layer;
  layer.crs = crs;
  layer.geometry = GeometryKind::line;
  layer.fields = {{"elevation", FieldType::real}, {"closed", FieldType::integer}};
  layer.count = lines.size();
  layer.make = [&lines](std::size_t i, LayerFeature& feature) {
    const ContourLine& line = lines[i];
    feature.xy = line.xy;
    feature.z.assign(line.xy.size(), line.level);
    feature.values = {line.level, std::int64_t{line.is_closed()}};
  };
  return layer;
}

struct Findings {
  std::size_t levels = 0, lines = 0, closed = 0;
  double lowest = 0, highest = 0;
};

Findings findings_of(const std::vector<ContourLine>& lines) {
  Findings findings;
  findings.lines = lines.size();
  if (lines.empty()) return findings;
  findings.lowest = lines.front().level;
  findings.highest = lines.back().level;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    findings.closed += lines[i].is_closed();
    findings.levels += i == 0 || lines[i].level != lines[i - 1].level;
  }
  return findings;
}

Json findings_json(const Findings& findings) {
  Json json = {{"lines", findings.lines}, {"closed", findings.closed}, {"levels", findings.levels}};
  json["lowest"] = findings.lines > 0 ? Json(findings.lowest) : Json(nullptr);
  json["highest"] = findings.lines > 0 ? Json(findings.highest) : Json(nullptr);
  return json;
}

std::string summary(const Findings& findings, const std::string& output) {
  std::string text = fmt::format("{:<8} {}, {} closed\n", "contours",
                                 counted(findings.lines, "line"), findings.closed);
  if (findings.lines > 0)
    text += fmt::format("{:<8} {} from {} to {}\n", "levels", findings.levels, findings.lowest,
                        findings.highest);
  return text + fmt::format("{:<8} {}\n", "written", shown(output));
}

int run(const Arguments& arguments) {
  const ThreadLimit limit(parse_threads(arguments.threads));
  const double interval = parse_number("--interval", arguments.interval);
  if (interval <= 0)
    throw ParameterError("--interval must be positive, not '" + arguments.interval + "'");
  const double base = arguments.base.empty() ? 0 : parse_number("--base", arguments.base);
  check_features_extension(arguments.output);
  check_targets(arguments.tin, arguments.output, arguments.json);

  Outputs outputs;
  Findings findings;
  {
    TerminalProgress progress;
    progress.report("reading");
    const Tin tin = read_tin(arguments.tin);
    progress.report("contours");
    const std::vector<ContourLine> lines = naming(arguments.tin, [&] {
      const std::vector<double> levels = contour_levels(tin, interval, base);
      return levels.empty() ? std::vector<ContourLine>()
                            : contours(tin, levels, [&](std::string_view phase, double done) {
                                progress.report(phase, done);
                              });
    });
    findings = findings_of(lines);
    progress.report("writing");
    write_features(layer_of(lines, tin.crs), outputs.open(arguments.output));
  }
  outputs.write_json(findings_json(findings), arguments.json);
  outputs.commit(summary(findings, arguments.output));
  return kOk;
}

}  // namespace

void add_contours(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App& command = *app.add_subcommand("contours", "Draw the contour lines of a mesh");
  command.add_option("TIN", arguments->tin, "Mesh: .obj or .ply, also .gz; - is standard input")
      ->required();
  command.add_option("--interval", arguments->interval, "Height from one line to the next")
      ->required()
      ->type_name("D");
  command
      .add_option("--base", arguments->base,
                  "A height that has a line, from which the others are counted (default: 0)")
      ->type_name("Z");
  command
      .add_option("-o,--output", arguments->output,
                  "Lines to write, with heights, in any vector format (see 'hodt formats')")
      ->required()
      ->type_name("OUTPUT");
  add_threads(command, arguments->threads);
  command.add_option("--json", arguments->json, "Write a report as JSON; - is standard output")
      ->type_name("FILE");
  command.footer(
      "Lines have higher ground on their left. They bound what is at a level or above it, so\n"
      "they go along the edges of flat triangles, never across. They close or end on the border.\n"
      "Examples:\n"
      "  hodt contours terrain.ply --interval 10 -o lines.gpkg\n"
      "  hodt contours bed.ply --interval 0.5 --base 0.25 -o lines.geojson --json -");
  command.callback([arguments, &action] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace hodt::app
