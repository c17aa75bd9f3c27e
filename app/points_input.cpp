#include "app/points_input.h"

#include "app/warning.h"
#include <fmt/format.h>

#include "hodt/io/column_choice.h"

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

}  // namespace

void add_points_input(CLI::App& command, PointsInput& input) {
  command
      .add_option("INPUT", input.file,
                  "Points: CSV, TSV, XYZ, LAS or LAZ, also .gz; - is standard input")
      ->required();
  add_columns(command, "--columns", input.columns,
              "Columns of INPUT that hold x, y and z, by name or number (the first is 1),\n"
              "like x=2,y=3,z=height (default: found by their names, or the first three)");
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

void add_columns(CLI::App& command, const std::string& name, std::string& columns,
                 const std::string& what) {
  command.add_option(name, columns, what)->type_name("COLUMNS");
}

PointTable read_input_points(const PointsInput& input) {
  PointChoice choice{parse_column_choice("--columns", input.columns)};
  if (input.chooses_las()) choice.las = parse_las_choice(input.las_class, input.las_return);
  return read_point_table(input.file, choice);
}

PointTable read_input_points(const std::string& file, const std::string& columns,
                             const std::string& option) {
  return read_point_table(file, {parse_column_choice(option, columns)});
}

void print_warnings(const std::string& file, const PointTable& table) {
  for (const std::string& warning : table.warnings) print_warning(file, warning);
}

void check_choices(const PointsInput& input) {
  check_columns(input.columns, "--columns");
  parse_las_choice(input.las_class, input.las_return);
}

void check_columns(const std::string& columns, const std::string& option) {
  parse_column_choice(option, columns);
}

std::string text_of(const TakenColumns& columns) {
  if (columns.las) return "X, Y, Z of " + text_of(*columns.las);
  return fmt::format("{}, {}, {}", text_of("x", columns.x), text_of("y", columns.y),
                     columns.z ? text_of("z", *columns.z) : "no z");
}

Json to_json(const TakenColumns& columns) {
  Json json = {{"x", to_json(columns.x)},
               {"y", to_json(columns.y)},
               {"z", columns.z ? to_json(*columns.z) : Json(nullptr)}};
  if (columns.las) json["las"] = to_json(*columns.las);
  return json;
}

}  // namespace hodt::app
