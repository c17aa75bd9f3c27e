// How every subcommand that reads points reads them, and says what it read.
// Tested by tests/app/columns_test.cpp.
#pragma once

#include <string>

#include "app/common.h"

#include "hodt/io/point_file.h"

namespace hodt::app {

struct PointsInput {
  std::string file;
  std::string columns;  ///< of --columns
};

/// The positional INPUT, and the option --columns.
void add_points_input(CLI::App& command, PointsInput& input);

/// An option for the columns of a file of points, with its description.
void add_columns(CLI::App& command, const std::string& name, std::string& columns,
                 const std::string& what);

/// Reads the points. `option` names the option that the columns come from.
PointTable read_input_points(const std::string& file, const std::string& columns,
                             const std::string& option = "--columns");
inline PointTable read_input_points(const PointsInput& input) {
  return read_input_points(input.file, input.columns);
}

/// Says on standard error what may be wrong with the points. For the end of a run: bad input gets
/// one line.
void print_warnings(const std::string& file, const PointTable& table);

/// Throws ParameterError if the columns are no choice of columns.
void check_columns(const std::string& columns, const std::string& option = "--columns");

/// "x = column 2 'Ost', y = column 1 'Nord', no z": the columns that were taken.
std::string text_of(const TakenColumns& columns);
Json to_json(const TakenColumns& columns);

}  // namespace hodt::app
