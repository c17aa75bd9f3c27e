#include "app/picture_output.h"

#include <filesystem>
#include <vector>

#include <fmt/format.h>

#include "hodt/io/crs.h"
#include "hodt/io/picture_file.h"
#include "hodt/io/png.h"

namespace hodt::app {

namespace {

Window parse_window(const std::string& text) {
  const auto refuse = [&] {
    throw ParameterError(
        fmt::format("--window must be XMIN,YMIN,XMAX,YMAX, the larger ones last, not '{}'", text));
  };
  std::vector<double> numbers;
  for (const std::string& number : CLI::detail::split(text + ",", ','))
    numbers.push_back(parse_number("--window", number));
  if (numbers.size() != 4) refuse();
  const Window window{{numbers[0], numbers[1]}, {numbers[2], numbers[3]}};
  if (!(window.low.x < window.high.x && window.low.y < window.high.y)) refuse();
  return window;
}

/// Minima are what pits are made of; where objectives are about maxima, these are looked at.
void choose_extrema(const Report& report, PictureOptions& options) {
  options.maxima = counts_maxima(report.objective);
  options.minima = report.objective != Objective::min_local_maxima;
  for (const LaterValue& later : report.then) {
    options.maxima |= counts_maxima(later.objective);
    options.minima |= counts_minima(later.objective);
  }
}

std::string caption_of(const TriangulateResult& result) {
  const Report& report = result.report;
  std::string caption =
      fmt::format("{}o circle of a triangle holds more than {}.",
                  result.tin.points.has_heights() ? "No height was changed, and n" : "N",
                  counted(report.order, "point"));
  const auto add_value = [&](const Objective& objective, const Value& value) {
    caption += fmt::format(" {}: {:.9g} → {:.9g}, proven bound {:.9g}.", name_of(objective),
                           value.delaunay, value.result, value.bound);
  };
  if (report.value) add_value(report.objective, *report.value);
  for (const LaterValue& later : report.then) add_value(later.objective, later.value);
  return caption;
}

/// "min-local-minima, then min-sum-abn".
std::string objectives_of(const Report& report) {
  std::vector<Objective> objectives{report.objective};
  for (const LaterValue& later : report.then) objectives.push_back(later.objective);
  return names_of(objectives, ", then ");
}

/// Minima that were to stay and did, in ascending order.
std::vector<Index> kept_minima(const TriangulateResult& result) {
  std::vector<Index> kept;
  for (const MinimumChange& minimum : result.report.changes.minima)
    if (minimum.fate == Fate::kept) kept.push_back(minimum.vertex);
  return kept;
}

std::vector<std::array<Point, 2>> pieces_of(const Joined& joined) {
  std::vector<std::array<Point, 2>> pieces;
  for (const auto& [a, b] : joined.constraints.edges)
    pieces.push_back({joined.points.xy[a], joined.points.xy[b]});
  return pieces;
}

}  // namespace

void add_picture(CLI::App& command, PictureArguments& arguments) {
  command
      .add_option("--picture", arguments.file,
                  "Draw the result beside the Delaunay triangulation: .svg or .png")
      ->type_name("FILE");
  command
      .add_option("--window", arguments.window,
                  "The part that the picture shows, XMIN,YMIN,XMAX,YMAX (default: the whole of a\n"
                  "small terrain, else where most changes)")
      ->type_name("BOX");
}

void check_picture(const PictureArguments& arguments, std::span<const std::string> read,
                   std::span<const std::string> written) {
  if (!arguments.window.empty()) {
    if (!arguments.any()) throw ParameterError("--window is for --picture, which is not given");
    parse_window(arguments.window);
  }
  if (!arguments.any()) return;
  check_picture_output(arguments.file);
  for (const std::string& input : read) check_targets(input, arguments.file, {});
  check_other_outputs("--picture", arguments.file, written);
}

void write_picture(const PictureArguments& arguments, const std::string& name,
                   const std::string& order, const TriangulateResult& result, const Joined& joined,
                   Outputs& outputs) {
  if (!arguments.any()) return;
  const CrsUnits units = crs_units(result.tin.crs);
  PictureOptions options;
  options.title = fmt::format("{}: Delaunay and order {}",
                              std::filesystem::path(name).filename().string(), order);
  options.before = joined.constraints.empty() ? "Delaunay" : "Constrained Delaunay";
  options.after = fmt::format("order {}, {}", order, objectives_of(result.report));
  options.caption = caption_of(result);
  if (!arguments.window.empty()) options.window = parse_window(arguments.window);
  choose_extrema(result.report, options);
  options.kept = kept_minima(result);
  options.lines = pieces_of(joined);
  options.unit = units.horizontal;
  options.height_unit = units.vertical;
  options.pack = png_of;
  const Tin delaunay{result.tin.points, result.report.delaunay, result.tin.crs};
  const Picture picture =
      naming(name, [&] { return comparison_picture(delaunay, result.tin, options); });
  hodt::write_picture(picture, outputs.open(arguments.file));
}

}  // namespace hodt::app
