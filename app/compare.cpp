// hodt compare: how much does each criterion gain, order by order?
#include <algorithm>
#include <utility>
#include <vector>

#include "app/common.h"
#include "app/comparison.h"
#include "app/comparison_page.h"
#include "app/comparison_table.h"
#include "app/constraints_input.h"
#include "app/duplicates_text.h"
#include "app/keep.h"
#include "app/layer_file.h"
#include "app/outputs.h"
#include "app/points_input.h"
#include "app/source.h"
#include "app/warning.h"
#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/base/parallel.h"
#include "hodt/io/file_name.h"
#include "hodt/io/input_text.h"

namespace hodt::app {

namespace {

constexpr std::string_view kDefaultObjective = "min-local-minima";

/// What "all" stands for: extrema, the criteria that the paper names, and what else terrain needs.
constexpr std::string_view kAllObjectives[] = {
    "min-local-minima",    "min-local-maxima", "min-local-extrema",    "min-sum-flat-area",
    "min-max-area",        "min-max-angle",    "max-min-circumradius", "max-min-enclosing-radius",
    "min-sum-inradius",    "min-sum-length",   "min-max-circumradius", "max-min-small-angle",
    "max-sum-small-angle",
};

struct Arguments {
  PointsInput input;
  std::string orders = "0-8";
  std::vector<std::string> objectives;
  std::string truth;
  std::string truth_columns;
  KeepArguments keep;
  ConstraintArguments constraints;
  std::string time_limit;
  std::string threads;
  std::string output;
  std::string json;
};

[[noreturn]] void refuse_orders(const std::string& text) {
  throw ParameterError(
      fmt::format("--orders must be orders and ranges of them with commas between, like 0-8 or "
                  "0,1,2,4,8-12, not '{}'",
                  text));
}

Index order_in(const std::string& item, const std::string& text) {
  const auto is_digit = [](char c) { return '0' <= c && c <= '9'; };
  if (item.empty() || !std::all_of(item.begin(), item.end(), is_digit)) refuse_orders(text);
  return static_cast<Index>(parse_whole("--orders", item, 0, kNone - 1));
}

/// Sorted, each once.
std::vector<Index> parse_orders(const std::string& text) {
  constexpr std::size_t most = 1000;
  std::vector<Index> orders;
  for (const std::string& item : CLI::detail::split(text + ",", ',')) {
    const std::size_t dash = item.find('-');
    const Index first = order_in(item.substr(0, dash), text);
    const Index last = dash == item.npos ? first : order_in(item.substr(dash + 1), text);
    if (first > last) refuse_orders(text);
    if (last - first >= most - orders.size())
      throw ParameterError(fmt::format("--orders '{}' are more than {} orders", text, most));
    for (Index k = first; k <= last; ++k) orders.push_back(k);
  }
  std::sort(orders.begin(), orders.end());
  orders.erase(std::unique(orders.begin(), orders.end()), orders.end());
  return orders;
}

struct Choice {
  std::vector<Objective> objectives;  ///< one, or several in order
  bool by_all = false;                ///< left out where the points have no heights
};

std::vector<Choice> parse_objectives(std::vector<std::string> names) {
  if (names.empty()) names.emplace_back(kDefaultObjective);
  std::vector<Choice> choices;
  for (const std::string& name : names) {
    if (name == "all") {
      for (const std::string_view each : kAllObjectives)
        choices.push_back({{objective_from_name(each)}, true});
      continue;
    }
    choices.push_back({compared_objectives(name), false});
  }
  return choices;
}

/// Each once. Of those that need heights and cannot have them, the ones asked for by name are
/// refused.
std::vector<std::vector<Objective>> usable(const std::vector<Choice>& choices,
                                           const PointSet& points, const std::string& input) {
  std::vector<std::vector<Objective>> usable;
  for (const auto& [objectives, by_all] : choices) {
    const auto high = std::find_if(objectives.begin(), objectives.end(), needs_heights);
    if (high != objectives.end() && !points.has_heights()) {
      if (by_all) continue;
      throw ParameterError(fmt::format(
          "{}: the objective {} needs heights, and the points have none; add a z column or choose "
          "another, like min-max-angle",
          display_name(input), name_of(*high)));
    }
    if (std::find(usable.begin(), usable.end(), objectives) == usable.end())
      usable.push_back(objectives);
  }
  return usable;
}

void check_files(const Arguments& arguments) {
  if (!arguments.output.empty()) {
    const std::string extension = lower_extension(arguments.output);
    if (extension != ".html" && extension != ".htm")
      throw ParameterError(
          fmt::format("cannot write '{}': a report is a page, .html", arguments.output));
  }
  if (arguments.input.is_standard_input() && arguments.truth == "-")
    throw ParameterError("INPUT and --truth cannot both be standard input");
  check_targets(arguments.input, arguments.output, arguments.json);
  check_targets(arguments.truth, arguments.output, arguments.json);
  if (arguments.truth == "-" && arguments.keep.places == "-")
    throw ParameterError("--truth and --keep cannot both be standard input");
  check_targets(layer_file(arguments.keep.places).file, arguments.output, arguments.json);
  check_constraints(arguments.constraints, arguments.input.name(), arguments.output,
                    arguments.json);
}

/// What is to be kept, if an objective counts minima.
void read_keep(const Arguments& arguments, const std::vector<Choice>& choices,
               ComparisonOptions& options) {
  TriangulateOptions keep;
  read_keep(arguments.keep, arguments.input, keep);
  if (arguments.keep.any() &&
      std::none_of(choices.begin(), choices.end(),
                   [](const Choice& choice) { return counts_minima(choice.objectives.front()); }))
    throw ParameterError(
        "minima to keep are for objectives that remove minima; name one, like min-local-minima");
  for (const Choice& choice : choices)
    if (arguments.keep.any() && !counts_minima(choice.objectives.front()) &&
        std::any_of(choice.objectives.begin(), choice.objectives.end(), counts_minima))
      throw ParameterError(
          "minima to keep are for the first of objectives in order; let one that removes minima be "
          "the first");
  options.min_pit_depth = keep.min_pit_depth;
  options.keep = std::move(keep.keep);
}

PointTable read_truth(const std::string& path, const std::string& columns) {
  PointTable truth = read_input_points(path, columns, "--truth-columns");
  if (!truth.points.has_heights())
    throw InputError(
        fmt::format("{}: the truth needs heights, and the points have none; add a z "
                    "column",
                    display_name(path)));
  return truth;
}

Json optional_json(const std::optional<double>& value) {
  return value ? to_json(*value) : Json(nullptr);
}

Json pits_json(const std::optional<PitTotals>& pits) {
  if (!pits) return nullptr;
  return {{"interior_minima", pits->count},
          {"total_depth", to_json(pits->depth)},
          {"largest_depth", to_json(pits->deepest)},
          {"volume", to_json(pits->volume)}};
}

/// Of the objectives that are not the first.
Json then_json(const ObjectiveComparison& objective, std::size_t order) {
  Json list = Json::array();
  for (std::size_t i = 0; i + 1 < objective.objectives.size(); ++i) {
    const ComparisonRow row = objective.rows[order].by_later(i);
    list.push_back({{"objective", name_of(objective.objectives[i + 1])},
                    {"value", to_json(row.value.result)},
                    {"bound", to_json(row.value.bound)},
                    {"optimal", row.value.optimal},
                    {"bound_in_order", objective.rows[order].then[i].is_bound_in_order},
                    {"gap", optional_json(row.gap())},
                    {"change_percent", optional_json(row.change())}});
  }
  return list;
}

/// Of a surface on a raster of truth; null without one.
Json land_json(const std::optional<LandFit>& land) {
  if (!land) return nullptr;
  return {{"slope_error", optional_json(land->slope_error)},
          {"fill_volume", to_json(land->fill.volume)},
          {"fill_depth", to_json(land->fill.depth)},
          {"stream_agreement", optional_json(land->stream_agreement)}};
}

Json row_json(const ObjectiveComparison& objective, std::size_t order) {
  const ComparisonRow& row = objective.rows[order];
  const std::optional<Fit>& fit = row.fit;
  return {{"k", row.k},
          {"value", to_json(row.value.result)},
          {"bound", to_json(row.value.bound)},
          {"optimal", row.value.optimal},
          {"then", then_json(objective, order)},
          {"mean_angle", optional_json(row.mean_angle)},
          {"gap", optional_json(row.gap())},
          {"change_percent", optional_json(row.change())},
          {"order", row.order},
          {"smallest_angle", to_json(row.smallest_angle)},
          {"local_minima", row.local_minima ? Json(*row.local_minima) : Json(nullptr)},
          {"pits", pits_json(row.pits)},
          {"rmse", fit ? to_json(fit->rmse) : Json(nullptr)},
          {"max_error", fit ? to_json(fit->max_error) : Json(nullptr)},
          {"land", land_json(row.land)},
          {"seconds", row.seconds}};
}

Json truth_json(const Comparison& comparison) {
  if (!comparison.truth) return nullptr;
  const TruthSummary& truth = *comparison.truth;
  return {
      {"points", truth.points},
      {"outside", truth.outside},
      {"delaunay_rmse", truth.delaunay ? to_json(truth.delaunay->rmse) : Json(nullptr)},
      {"delaunay_max_error", truth.delaunay ? to_json(truth.delaunay->max_error) : Json(nullptr)},
      {"delaunay_land", land_json(truth.delaunay_land)},
      {"land_fill_volume", truth.delaunay_land ? to_json(truth.land_fill.volume) : Json(nullptr)}};
}

/// A mesh that was to be improved.
Json given_json(const Comparison& comparison, const Source& source) {
  if (!source.is_tin) return nullptr;
  return {{"order", comparison.given_order ? Json(*comparison.given_order) : Json(nullptr)},
          {"unused_vertices", source.unused_vertices}};
}

/// The values of the objectives that such a mesh has; null if there is none.
Json given_json(const ObjectiveComparison& objective) {
  if (objective.given.empty()) return nullptr;
  Json values = Json::array();
  for (const double value : objective.given) values.push_back(to_json(value));
  return values;
}

Json comparison_json(const Comparison& comparison, const Source& source, const Json& constraints) {
  const InputPoints& read = source.input;
  Json objectives = Json::array();
  for (const ObjectiveComparison& objective : comparison.objectives) {
    Json rows = Json::array(), then = Json::array();
    for (std::size_t i = 0; i < objective.rows.size(); ++i) rows.push_back(row_json(objective, i));
    for (std::size_t i = 1; i < objective.objectives.size(); ++i)
      then.push_back(name_of(objective.objectives[i]));
    objectives.push_back(
        {{"objective", name_of(objective.objective())},
         {"then", std::move(then)},
         {"input", given_json(objective)},
         {"unchanged",
          objective.why_unchanged.empty() ? Json(nullptr) : Json(objective.why_unchanged)},
         {"rows", std::move(rows)}});
  }
  return {{"points", comparison.points},
          {"files", std::max<std::size_t>(1, read.files.size())},
          {"columns", columns_json(read)},
          {"crs", crs_json(read.crs)},
          {"input", given_json(comparison, source)},
          {"duplicates", comparison.duplicates},
          {"duplicate_rule", name_of(read.rule)},
          {"duplicate_heights", heights_json(comparison.duplicate_heights)},
          {"constraints", constraints},
          {"kept", comparison.kept ? Json(*comparison.kept) : Json(nullptr)},
          {"polygons_without_points", comparison.empty_polygons},
          {"delaunay_pits", pits_json(comparison.delaunay_pits)},
          {"truth", truth_json(comparison)},
          {"orders", comparison.orders},
          {"objectives", std::move(objectives)}};
}

std::string tables_text(const Comparison& comparison, const ObjectiveComparison& objective) {
  std::string text = fmt::format("\n{}{}\n{}", objective.title(), given_text(objective),
                                 aligned(table_of(comparison, objective)));
  for (std::size_t i = 0; i + 1 < objective.objectives.size(); ++i) {
    const ObjectiveComparison later = objective.by_later(i);
    text += fmt::format("then {}{}\n{}", later.title(), given_text(later),
                        aligned(later_table(objective, i)));
  }
  return text;
}

/// The lines of a summary as one, without the name before them.
std::string as_one_line(const std::string& lines) {
  std::string text;
  for (std::string line : CLI::detail::split(lines, '\n')) {
    if (text.empty()) line = line.substr(std::min(line.size(), line.find(' ')));
    CLI::detail::trim(line);
    if (!line.empty()) text += (text.empty() ? "" : "; ") + line;
  }
  return text;
}

std::string summary(const Comparison& comparison, const InputPoints& read,
                    const std::string& constraints, const std::string& output) {
  std::string text;
  for (const Fact& fact : facts_of(comparison))
    text += fmt::format("{:<9} {}\n", fact.name, fact.text);
  text += inputs_text(read, 9) + constraints;
  if (!output.empty()) text += fmt::format("{:<9} {}\n", "written", shown(output));
  const bool many = comparison.objectives.size() > 1;
  if (many) text += "\n" + aligned(summary_table(comparison));
  for (const ObjectiveComparison& objective : comparison.objectives)
    if (!many || objective.why_unchanged.empty()) text += tables_text(comparison, objective);
  for (const ObjectiveComparison& objective : comparison.objectives)
    if (!objective.why_unchanged.empty())
      text +=
          fmt::format("\n{}: 0 % at every order. {}\n", objective.title(), objective.why_unchanged);
  return text;
}

int run(const Arguments& arguments) {
  // All that can be refused is refused before the work begins.
  ComparisonOptions options;
  options.orders = parse_orders(arguments.orders);
  const std::vector<Choice> choices = parse_objectives(arguments.objectives);
  options.time_limit = parse_seconds(arguments.time_limit);
  const ThreadLimit limit(parse_threads(arguments.threads));
  check_choices(arguments.input);
  check_columns(arguments.truth_columns, "--truth-columns");
  check_files(arguments);
  read_keep(arguments, choices, options);

  Comparison comparison;
  const std::string input = arguments.input.name();
  Source source;
  std::string constraints_lines;
  Json constraints;
  {
    TerminalProgress progress;
    progress.report("reading");
    source = read_source(arguments.input);
    const InputPoints& read = source.input;
    source.input.system.add(options.keep.source, options.keep.crs);
    Joined joined = read_constraints(arguments.constraints, input, source.input.system,
                                     std::move(source.input.points), source.numbers,
                                     source.constraints.triangles);
    if (source.is_tin) add_given(source.constraints, input, joined);
    const PointSet& points = joined.points;
    options.objectives = usable(choices, points, input);
    std::optional<PointTable> truth;
    if (!arguments.truth.empty()) {
      if (!points.has_heights())
        throw InputError(
            fmt::format("{}: --truth compares heights, and the points have none; add "
                        "a z column",
                        display_name(input)));
      truth = read_truth(arguments.truth, arguments.truth_columns);
      source.input.system.add(arguments.truth, truth->points.crs, truth->height_unit);
      options.truth_grid = truth->grid;
    }
    options.progress = [&](std::string_view phase, double done) { progress.report(phase, done); };
    naming_lines(input, joined, [&] {
      comparison = compare(points, truth ? &truth->points : nullptr, options, joined.constraints);
    });
    if (arguments.constraints.any()) {
      constraints_lines = constraints_text(joined.report, comparison.constraints, 11);
      constraints = constraints_json(joined.report, comparison.constraints);
    }
    if (read.duplicates) comparison.duplicate_heights = read.duplicates;
    print_warnings(read);
    print_warnings(joined);
    print_warnings(options.keep);
    if (truth) print_warnings(arguments.truth, *truth);
    if (truth && !comparison.truth->delaunay)
      print_warning(arguments.truth,
                    fmt::format("of its {} none is within the triangulation, so that no height is "
                                "compared; is it of the same place, and in the same units?",
                                counted(truth->points.size(), "point")));
  }
  Outputs outputs;
  if (!arguments.output.empty())
    outputs.open(arguments.output)
        .write(comparison_page(comparison, input, as_one_line(constraints_lines)));
  outputs.write_json(comparison_json(comparison, source, constraints), arguments.json);
  outputs.commit(summary(comparison, source.input, constraints_lines, arguments.output));
  return kOk;
}

std::string all_explained() {
  std::string text = "Objectives are those of hodt triangulate; all stands for";
  for (const std::string_view name : kAllObjectives) text += fmt::format("\n  {}", name);
  return text + "\n(without heights, those that need none).\n";
}

}  // namespace

void add_compare(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App& command =
      *app.add_subcommand("compare", "Say what every order gains, for one objective or many");
  add_points_input(command, arguments->input);
  command
      .add_option("--orders", arguments->orders,
                  "Orders to compare, like 0-8 or 0,1,2,4,8-12 (default: 0-8)")
      ->type_name("LIST");
  command
      .add_option("--objective", arguments->objectives,
                  "What to optimise; several with commas between, or all\n"
                  "(default: min-local-minima). Of A+B then B among the triangulations that are\n"
                  "as good for A, as triangulate has it with a comma")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("OBJ");
  command
      .add_option(
          "--truth", arguments->truth,
          "Points with known heights; each surface's errors there are told. Of a raster also\n"
          "how slopes and streams agree with its own, and what it takes to fill pits")
      ->type_name("FILE");
  add_columns(command, "--truth-columns", arguments->truth_columns,
              "Columns of the truth that hold x, y and z, as in --columns");
  add_keep(command, arguments->keep);
  add_constraints(command, arguments->constraints);
  command
      .add_option("--time-limit", arguments->time_limit,
                  "Seconds that each search may take (default: 0, no limit)")
      ->type_name("S");
  add_threads(command, arguments->threads);
  command
      .add_option("-o,--output", arguments->output,
                  "Report to write: .html, with tables and charts")
      ->type_name("REPORT");
  command.add_option("--json", arguments->json, "Write the tables as JSON; - is standard output")
      ->type_name("FILE");
  command.footer(
      all_explained() +
      "Examples:\n"
      "  hodt compare terrain.csv\n"
      "  hodt compare terrain.csv --orders 0-4,8,16 --objective min-max-angle,min-sum-length\n"
      "  hodt compare terrain.csv --objective min-local-minima+min-sum-abn,min-sum-abn\n"
      "  hodt compare survey.csv --breaklines roads.geojson --outline site.geojson\n"
      "  hodt compare mesh.obj --objective min-max-angle\n"
      "  hodt compare sample.csv --objective all --truth withheld.csv -o report.html\n"
      "  hodt compare sample.csv --objective terrain --orders 0,8,24 --truth dem.tif");
  command.callback([arguments, &action] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace hodt::app
