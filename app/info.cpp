// hodt info: what is in a file of points?
// Tested by tests/app/command_test.cpp.
#include <algorithm>
#include <vector>

#include "app/duplicates_text.h"
#include "app/outputs.h"
#include "app/points_input.h"
#include <fmt/format.h>

#include "hodt/base/parallel.h"
#include "hodt/delaunay/spatial_order.h"
#include "hodt/geometry/predicates.h"

namespace hodt::app {

namespace {

struct Arguments {
  PointsInput input;
  std::string threads;
  std::string json;
};

struct Range {
  double low = 0;
  double high = 0;
};

struct Findings {
  std::size_t points = 0;
  std::size_t distinct = 0;
  std::optional<DuplicateHeights> duplicate_heights;
  Range x, y;
  std::optional<Range> z;
  bool collinear = false;
  /// What stands in the way of a triangulation, or is worth knowing.
  std::vector<std::string> hints;
};

template <class Values, class Get>
Range range_of(const Values& values, const Get& get) {
  Range range{get(values[0]), get(values[0])};
  for (const auto& value : values) {
    range.low = std::min(range.low, get(value));
    range.high = std::max(range.high, get(value));
  }
  return range;
}

bool all_collinear(const std::vector<Point>& points) {
  const Point& first = points.front();
  const auto other =
      std::find_if(points.begin(), points.end(), [&](const Point& p) { return p != first; });
  if (other == points.end()) return true;
  return std::all_of(other, points.end(),
                     [&](const Point& p) { return orient(first, *other, p) == 0; });
}

Findings examine(const InputPoints& read) {
  const PointSet& points = read.points;
  Findings findings;
  findings.points = points.size();
  const VertexSet distinct = spatial_order(points).vertices;
  findings.distinct = distinct.size();
  if (points.has_heights())
    findings.duplicate_heights = read.duplicates.value_or(distinct.duplicate_heights);
  findings.x = range_of(points.xy, [](const Point& p) { return p.x; });
  findings.y = range_of(points.xy, [](const Point& p) { return p.y; });
  if (points.has_heights()) findings.z = range_of(points.z, [](double z) { return z; });
  findings.collinear = all_collinear(points.xy);
  if (findings.distinct < 3) {
    findings.hints.push_back("fewer than three distinct points: there is no triangle");
  } else if (findings.collinear) {
    findings.hints.push_back("all points lie on a line: there is no triangle");
  }
  if (findings.distinct < findings.points) {
    findings.hints.push_back(fmt::format(
        "of points with equal x and y, {} stays",
        read.rule == DuplicateRule::mean ? "one of the mean height" : "the " + name_of(read.rule)));
    if (const std::string text = difference_text(findings.duplicate_heights); !text.empty())
      findings.hints.push_back("of points with equal x and y, " + text);
  }
  if (!findings.z) findings.hints.push_back("no heights: planar objectives and 'none' only");
  for (const auto& [file, text] : read.warnings)
    findings.hints.push_back(read.files.size() == 1 ? text : fmt::format("{}: {}", file, text));
  return findings;
}

Json to_json(const Range& range) {
  return {range.low, range.high};
}

Json findings_json(const Findings& findings, const InputPoints& read) {
  return {{"points", findings.points},
          {"distinct", findings.distinct},
          {"duplicates", findings.points - findings.distinct},
          {"duplicate_rule", name_of(read.rule)},
          {"duplicate_heights", heights_json(findings.duplicate_heights)},
          {"x", to_json(findings.x)},
          {"y", to_json(findings.y)},
          {"files", read.files.size()},
          {"columns", columns_json(read)},
          {"crs", crs_json(read.crs)},
          {"heights", findings.z.has_value()},
          {"z", findings.z ? to_json(*findings.z) : Json(nullptr)},
          {"collinear", findings.collinear},
          {"hints", findings.hints}};
}

std::string summary(const Findings& findings, const InputPoints& read) {
  const auto line = [](std::string_view name, const Range& range) {
    return fmt::format("{:<7} {} to {}\n", name, range.low, range.high);
  };
  std::string text =
      fmt::format("{:<7} {} ({} distinct, {})\n", "points", findings.points, findings.distinct,
                  counted(findings.points - findings.distinct, "duplicate"));
  text += inputs_text(read, 7);
  text += line("x", findings.x) + line("y", findings.y);
  text += findings.z ? line("z", *findings.z) : "z       none\n";
  for (const std::string& hint : findings.hints) text += fmt::format("{:<7} {}\n", "hint", hint);
  return text;
}

int run(const Arguments& arguments) {
  const ThreadLimit limit(parse_threads(arguments.threads));
  check_choices(arguments.input);
  check_targets(arguments.input, {}, arguments.json);
  Findings findings;
  InputPoints read;
  {
    TerminalProgress progress;
    progress.report("reading");
    // What may be wrong is among the hints, not on standard error.
    read = read_input_points(arguments.input);
    progress.report("counting");
    findings = examine(read);
  }
  Outputs outputs;
  outputs.write_json(findings_json(findings, read), arguments.json);
  outputs.commit(summary(findings, read));
  return kOk;
}

}  // namespace

void add_info(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App& command = *app.add_subcommand("info", "Say what is in a file of points");
  add_points_input(command, arguments->input);
  add_threads(command, arguments->threads);
  command.add_option("--json", arguments->json, "Write the findings as JSON; - is standard output")
      ->type_name("FILE");
  command.footer(
      "Examples:\n"
      "  hodt info terrain.csv\n"
      "  hodt info dem.tif\n"
      "  hodt info survey.csv --columns x=Ost,y=Nord,z=4\n"
      "  hodt info terrain.xyz.gz --json -");
  command.callback([arguments, &action] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace hodt::app
