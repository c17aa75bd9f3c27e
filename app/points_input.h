// How every subcommand that reads points reads them, and says what it read.
// Tested by tests/app/columns_test.cpp.
// Tested by tests/app/inputs_test.cpp.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/common.h"
#include "app/common_system.h"

#include "hodt/delaunay/duplicates.h"
#include "hodt/io/point_file.h"

namespace hodt::app {

struct PointsInput {
  std::vector<std::string> files;
  std::string columns;  ///< of --columns
  std::string las_class, las_return;
  std::string layer, z_field;  ///< of files of map features
  bool no_z = false, vertices = false;
  std::string band, stride;  ///< of rasters
  std::string crs, duplicates;

  /// Whether an option chooses among the points of a file.
  bool chooses_points() const;
  /// What errors call it: "a.csv", "a.csv and 2 more files".
  std::string name() const;
  bool is_standard_input() const { return files.size() == 1 && files[0] == kStandardInput; }
};

/// The positional INPUT, and the options that say how it is to be read.
void add_points_input(CLI::App& command, PointsInput& input);

/// An option for the columns of a file of points, with its description.
void add_columns(CLI::App& command, const std::string& name, std::string& columns,
                 const std::string& what);

/// Throws ParameterError for what can be refused before a file is read.
void check_choices(const PointsInput& input);
/// Throws ParameterError if the columns are no choice of columns.
void check_columns(const std::string& columns, const std::string& option);

/// check_targets() with each file of the input.
void check_targets(const PointsInput& input, const std::filesystem::path& output,
                   const std::filesystem::path& json);

/// The points of all files of an input, file by file, with the heights of duplicates settled.
struct InputPoints {
  struct File {
    std::string name;
    std::size_t points = 0;
    TakenColumns columns;
  };
  PointSet points;
  std::string crs;      ///< of the points, which may have been moved away
  CommonSystem system;  ///< what the files say of it, for what is read beside them
  std::vector<File> files;
  struct Warning {
    std::string file, text;
  };
  std::vector<Warning> warnings;
  DuplicateRule rule = DuplicateRule::lowest;
  /// Empty if the lowest height counts: the triangulation tells these.
  std::optional<DuplicateHeights> duplicates;
};

/// Reads the points. Throws what read_point_table() does, and InputError if the files are of
/// different coordinate reference systems or not all have heights.
InputPoints read_input_points(const PointsInput& input);

/// The same of points that are there: of a mesh.
InputPoints input_points(const PointsInput& input, PointSet points);

/// Reads a file of which only the columns can be chosen, by the option of that name.
PointTable read_input_points(const std::string& file, const std::string& columns,
                             const std::string& option);

/// Says on standard error what may be wrong with the points. For the end of a run: bad input gets
/// one line.
void print_warnings(const InputPoints& points);
void print_warnings(const std::string& file, const PointTable& table);

/// Throws InputError, naming both, if both are known and they differ.
void require_same_crs(const std::string& name, const std::string& crs, const std::string& other,
                      const std::string& other_crs);

/// Lines of a report: the columns that were taken ("x = column 2 'Ost', y = column 1 'Nord', no
/// z"; of LAS, which points), how many files there are if they are several, and the coordinate
/// reference system if it is known.
std::string inputs_text(const InputPoints& points, int indent);

/// The columns of the file; of several files a list, with their names and numbers of points.
Json columns_json(const InputPoints& points);
/// Null if unknown.
Json crs_json(const std::string& crs);

}  // namespace hodt::app
