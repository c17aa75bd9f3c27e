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

Json to_json(const TakenColumn& column) {
  return {{"number", column.number},
          {"name", column.name.empty() ? Json(nullptr) : Json(column.name)}};
}

}  // namespace

void add_points_input(CLI::App& command, PointsInput& input) {
  command.add_option("INPUT", input.file, "Points: CSV, TSV or XYZ, also .gz; - is standard input")
      ->required();
  add_columns(command, "--columns", input.columns,
              "Columns of INPUT that hold x, y and z, by name or number (the first is 1),\n"
              "like x=2,y=3,z=height (default: found by their names, or the first three)");
}

void add_columns(CLI::App& command, const std::string& name, std::string& columns,
                 const std::string& what) {
  command.add_option(name, columns, what)->type_name("COLUMNS");
}

PointTable read_input_points(const std::string& file, const std::string& columns,
                             const std::string& option) {
  return read_point_table(file, {parse_column_choice(option, columns)});
}

void print_warnings(const std::string& file, const PointTable& table) {
  for (const std::string& warning : table.warnings) print_warning(file, warning);
}

void check_columns(const std::string& columns, const std::string& option) {
  parse_column_choice(option, columns);
}

std::string text_of(const TakenColumns& columns) {
  return fmt::format("{}, {}, {}", text_of("x", columns.x), text_of("y", columns.y),
                     columns.z ? text_of("z", *columns.z) : "no z");
}

Json to_json(const TakenColumns& columns) {
  return {{"x", to_json(columns.x)},
          {"y", to_json(columns.y)},
          {"z", columns.z ? to_json(*columns.z) : Json(nullptr)}};
}

}  // namespace hodt::app
