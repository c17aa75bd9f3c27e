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
  std::string las_class, las_return;

  bool chooses_las() const { return !las_class.empty() || !las_return.empty(); }
};

/// The positional INPUT, and the options --columns, --las-class and --las-return.
void add_points_input(CLI::App& command, PointsInput& input);

/// An option for the columns of a file of points, with its description.
void add_columns(CLI::App& command, const std::string& name, std::string& columns,
                 const std::string& what);

/// Reads the points.
PointTable read_input_points(const PointsInput& input);

/// The same of a file of which only the columns can be chosen, by the option of that name.
PointTable read_input_points(const std::string& file, const std::string& columns,
                             const std::string& option);

/// Says on standard error what may be wrong with the points. For the end of a run: bad input gets
/// one line.
void print_warnings(const std::string& file, const PointTable& table);

/// Throws ParameterError if an option is no choice of what it is for.
void check_choices(const PointsInput& input);
void check_columns(const std::string& columns, const std::string& option);

/// "x = column 2 'Ost', y = column 1 'Nord', no z": the columns that were taken; of LAS, which
/// points.
std::string text_of(const TakenColumns& columns);
Json to_json(const TakenColumns& columns);

}  // namespace hodt::app
