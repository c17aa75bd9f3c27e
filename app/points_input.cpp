#include "app/points_input.h"

#include <algorithm>
#include <utility>

#include "app/warning.h"
#include <fmt/format.h>

#include "hodt/io/column_choice.h"
#include "hodt/io/column_names.h"
#include "hodt/io/crs.h"

namespace hodt::app {

namespace {

std::string text_of(const char* axis, const TakenColumn& column) {
  return column.name.empty() ? fmt::format("{} = column {}", axis, column.number)
                             : fmt::format("{} = column {} '{}'", axis, column.number, column.name);
}

constexpr const char* name_of(LasChoice::Returns returns) {
  switch (returns) {
    case LasChoice::Returns::first:
      return "first";
    case LasChoice::Returns::last:
      return "last";
    case LasChoice::Returns::all:
      break;
  }
  return "all";
}

Json to_json(const LasCounts& counts) {
  Json classes = Json::array();
  for (std::size_t c = 0; c < counts.of_class.size(); ++c)
    if (counts.of_class[c] > 0)
      classes.push_back(
          {{"class", c}, {"points", counts.of_class[c]}, {"taken", counts.taken_of_class[c]}});
  return {{"points", counts.total},
          {"taken", counts.taken},
          {"all_classes", counts.all_classes},
          {"returns", name_of(counts.returns)},
          {"withheld", counts.withheld},
          {"of_other_classes", counts.other_class},
          {"of_other_returns", counts.other_return},
          {"classes", std::move(classes)}};
}

Json to_json(const TakenColumn& column) {
  return {{"number", column.number},
          {"name", column.name.empty() ? Json(nullptr) : Json(column.name)}};
}

std::string text_of(const TakenColumns& columns) {
  if (columns.las) return "X, Y, Z of " + text_of(*columns.las);
  if (!columns.source.empty()) return columns.source;
  return fmt::format("{}, {}, {}", text_of("x", columns.x), text_of("y", columns.y),
                     columns.z ? text_of("z", *columns.z) : "no z");
}

Json to_json(const TakenColumns& columns) {
  if (!columns.source.empty()) return {{"source", columns.source}};
  Json json = {{"x", to_json(columns.x)},
               {"y", to_json(columns.y)},
               {"z", columns.z ? to_json(*columns.z) : Json(nullptr)}};
  if (columns.las) json["las"] = to_json(*columns.las);
  return json;
}

Index parse_count(const std::string& option, const std::string& text) {
  constexpr Index most = 1 << 30;
  return text.empty() ? 0 : static_cast<Index>(parse_whole(option, text, 1, most));
}

PointChoice choice_of(const PointsInput& input) {
  PointChoice choice;
  choice.columns = parse_column_choice("--columns", input.columns);
  if (!input.las_class.empty() || !input.las_return.empty())
    choice.las = parse_las_choice(input.las_class, input.las_return);
  choice.layer = {input.layer, input.z_field, input.no_z, input.vertices};
  choice.raster = {parse_count("--band", input.band), parse_count("--stride", input.stride)};
  return choice;
}

DuplicateRule rule_of(const PointsInput& input) {
  return duplicate_rule("--duplicates", input.duplicates.empty() ? "lowest" : input.duplicates);
}

/// Adds the points of a further file.
void append(PointSet& points, PointSet more) {
  points.xy.insert(points.xy.end(), more.xy.begin(), more.xy.end());
  points.z.insert(points.z.end(), more.z.begin(), more.z.end());
}

/// Files that are not known to be of the same system cannot be put together without a word.
void require_one_crs(const PointsInput& input, const InputPoints& read, const std::string& file,
                     const std::string& crs) {
  const std::string& first = read.files.front().name;
  if (read.points.crs.empty() != crs.empty() && input.crs.empty())
    throw InputError(fmt::format(
        "{} is in {}, and of {} the coordinate reference system is unknown; if it is the same, say "
        "so with --crs",
        crs.empty() ? first : file, crs_title(crs.empty() ? read.points.crs : crs),
        crs.empty() ? file : first));
}

void add_file(const PointsInput& input, const std::string& file, PointTable table,
              InputPoints& read) {
  for (const std::string& warning : table.warnings)
    read.warnings.push_back({display_name(file), warning});
  read.system.add(file, table.points.crs, table.height_unit);
  if (!read.files.empty()) {
    require_one_crs(input, read, display_name(file), table.points.crs);
    // Only what it says beyond the first one can be new: of heights.
    if (input.crs.empty() && table.points.crs != read.points.crs)
      for (const std::string& warning : crs_warnings(table.points.crs))
        read.warnings.push_back({display_name(file), warning});
    if (table.points.has_heights() != read.points.has_heights())
      throw InputError(fmt::format("{} has {}heights, unlike {}; give all files heights, or none",
                                   display_name(file), table.points.has_heights() ? "" : "no ",
                                   read.files.front().name));
  }
  read.files.push_back({display_name(file), table.points.size(), std::move(table.columns)});
  if (read.files.size() == 1)
    read.points = std::move(table.points);
  else
    append(read.points, std::move(table.points));
}

/// Whether the columns are longitude and latitude by their names.
bool are_degrees(const TakenColumns& columns) {
  return columns.source.empty() && role_of(columns.x.name) == ColumnRole::longitude &&
         role_of(columns.y.name) == ColumnRole::latitude;
}

/// Where nothing is known but names of columns.
void warn_of_degrees(InputPoints& read) {
  const auto file = std::find_if(read.files.begin(), read.files.end(),
                                 [](const auto& f) { return are_degrees(f.columns); });
  if (read.crs.empty() && file != read.files.end())
    read.warnings.push_back(
        {file->name, degrees_warning("longitude and latitude, by the names of the columns")});
}

/// What holds for the points of all files.
void finish(const PointsInput& input, InputPoints& read) {
  if (!input.crs.empty()) {
    read.points.crs = parse_crs("--crs", input.crs);
    read.system.replace(input.name(), read.points.crs);
  }
  read.crs = read.points.crs;
  for (const std::string& warning : crs_warnings(read.points.crs))
    read.warnings.push_back({display_name(input.name()), warning});
  warn_of_degrees(read);
  read.rule = rule_of(input);
  if (read.rule != DuplicateRule::lowest)
    read.duplicates =
        naming(input.name(), [&] { return settle_duplicates(read.points, read.rule); });
}

void add_las_options(CLI::App& command, PointsInput& input) {
  command
      .add_option("--las-class", input.las_class,
                  "Classes of LAS and LAZ points to take, like 2 or 2,9, or all\n"
                  "(default: 2, which is ground, if there is any, and all otherwise)")
      ->type_name("CLASSES");
  command
      .add_option("--las-return", input.las_return,
                  "Returns of LAS and LAZ points to take: first, last or all (default: all)")
      ->type_name("RETURNS");
}

void add_layer_options(CLI::App& command, PointsInput& input) {
  command
      .add_option("--layer", input.layer, "Layer of a file of map features (default: the only one)")
      ->type_name("NAME");
  command
      .add_option("--z-field", input.z_field,
                  "Field of map features that holds the heights (default: z of the geometry)")
      ->type_name("FIELD");
  command.add_flag("--no-z", input.no_z, "Take x and y of map features alone");
  command.add_flag("--vertices", input.vertices,
                   "Take vertices of lines and polygons as points, too");
}

void add_raster_options(CLI::App& command, PointsInput& input) {
  command.add_option("--band", input.band, "Band of a raster, from 1 (default: the first)")
      ->type_name("B");
  command
      .add_option("--stride", input.stride,
                  "Take every N-th row and column of a raster (default: all)")
      ->type_name("N");
}

}  // namespace

bool PointsInput::chooses_points() const {
  return !columns.empty() || !layer.empty() || !z_field.empty() || no_z || vertices ||
         !band.empty() || !stride.empty() || !las_class.empty() || !las_return.empty();
}

std::string PointsInput::name() const {
  if (files.empty()) return {};
  if (files.size() == 1) return files[0];
  return fmt::format("{} and {}", files[0], counted(files.size() - 1, "more file"));
}

void add_points_input(CLI::App& command, PointsInput& input) {
  command
      .add_option("INPUT", input.files,
                  "Points: CSV, TSV, XYZ, LAS or LAZ, also .gz; GeoPackage, Shapefile and other\n"
                  "map features; GeoTIFF and other rasters. Several are taken together; - is\n"
                  "standard input")
      ->required();
  add_columns(command, "--columns", input.columns,
              "Columns of INPUT that hold x, y and z, by name or number (the first is 1),\n"
              "like x=2,y=3,z=height (default: found by their names, or the first three)");
  add_las_options(command, input);
  add_layer_options(command, input);
  add_raster_options(command, input);
  command
      .add_option("--crs", input.crs,
                  "Coordinate reference system of INPUT, like EPSG:25832 (default: what it says)")
      ->type_name("CRS");
  command
      .add_option("--duplicates", input.duplicates,
                  "Which height counts of points with equal x and y: lowest (default), highest,\n"
                  "mean, first; or error, if there may be none")
      ->type_name("RULE");
}

void add_columns(CLI::App& command, const std::string& name, std::string& columns,
                 const std::string& what) {
  command.add_option(name, columns, what)->type_name("COLUMNS");
}

void check_choices(const PointsInput& input) {
  choice_of(input);
  rule_of(input);
  if (!input.crs.empty()) parse_crs("--crs", input.crs);
  if (input.files.size() > 1 &&
      std::find(input.files.begin(), input.files.end(), kStandardInput) != input.files.end())
    throw ParameterError("standard input cannot be one of several files; name it alone");
}

void check_columns(const std::string& columns, const std::string& option) {
  parse_column_choice(option, columns);
}

void check_targets(const PointsInput& input, const std::filesystem::path& output,
                   const std::filesystem::path& json) {
  for (const std::string& file : input.files) check_targets(file, output, json);
}

InputPoints read_input_points(const PointsInput& input) {
  const PointChoice choice = choice_of(input);
  InputPoints read;
  for (const std::string& file : input.files)
    add_file(input, file, read_point_table(file, choice), read);
  finish(input, read);
  return read;
}

InputPoints input_points(const PointsInput& input, PointSet points) {
  InputPoints read;
  read.points = std::move(points);
  read.system.add(input.name(), read.points.crs);
  finish(input, read);
  return read;
}

PointTable read_input_points(const std::string& file, const std::string& columns,
                             const std::string& option) {
  return read_point_table(file, {.columns = parse_column_choice(option, columns)});
}

void print_warnings(const InputPoints& points) {
  for (const auto& [file, text] : points.warnings) print_warning(file, text);
}

void print_warnings(const std::string& file, const PointTable& table) {
  for (const std::string& warning : table.warnings) print_warning(file, warning);
}

void require_same_crs(const std::string& name, const std::string& crs, const std::string& other,
                      const std::string& other_crs) {
  if (crs.empty() || other_crs.empty() || is_same_crs(crs, other_crs)) return;
  throw InputError(fmt::format(
      "{} is in {}, and {} in {}; bring them to one coordinate reference system, with ogr2ogr "
      "-t_srs or gdalwarp -t_srs for example",
      display_name(name), crs_title(crs), display_name(other), crs_title(other_crs)));
}

std::string inputs_text(const InputPoints& points, int indent) {
  const auto line = [&](const char* name, const std::string& text) {
    return fmt::format("{:<{}} {}\n", name, indent, text);
  };
  std::string text;
  const auto& files = points.files;
  if (files.size() > 1) text += line("files", fmt::format("{}", files.size()));
  std::string last;
  for (const InputPoints::File& file : files) {
    const std::string columns = text_of(file.columns);
    if (columns == last) continue;
    const bool is_first = last.empty();
    text += line("columns", is_first ? columns : fmt::format("{}: {}", file.name, columns));
    last = columns;
  }
  if (!points.crs.empty()) text += line("crs", crs_title(points.crs));
  return text;
}

Json columns_json(const InputPoints& points) {
  const auto& files = points.files;
  if (files.empty()) return nullptr;
  if (files.size() == 1) return to_json(files[0].columns);
  Json list = Json::array();
  for (const InputPoints::File& file : files)
    list.push_back(
        {{"file", file.name}, {"points", file.points}, {"columns", to_json(file.columns)}});
  return list;
}

Json crs_json(const std::string& crs) {
  return crs.empty() ? Json(nullptr) : Json(crs);
}

}  // namespace hodt::app
