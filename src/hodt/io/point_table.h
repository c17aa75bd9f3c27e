// Points from text tables: CSV, TSV and white-space separated XYZ.
// Tested by tests/io/point_file_test.cpp.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hodt/geometry/point_set.h"
#include "hodt/io/input_text.h"
#include "hodt/io/point_choice.h"
#include "hodt/io/table_layout.h"
#include "hodt/tin/raster.h"

namespace hodt {

/// What heights are counted in.
struct HeightUnit {
  double metres = 0;  ///< 0: unknown
  std::string name = {};
};

/// Points, and how they were read.
struct PointTable {
  PointSet points;
  TakenColumns columns;
  /// What may be wrong with the points although they could be read, each a sentence.
  std::vector<std::string> warnings;
  /// The raster that has the points for centres of its cells, row after row, if it lies along the
  /// axes and all its rows and columns were taken.
  std::optional<Grid> grid = {};
  /// What the file says of it beside its coordinate reference system.
  HeightUnit height_unit = {};
};

/// Parses a table of points. docs/points.md says which tables are understood; what is not, is
/// refused. Throws InputError, naming the line (all lines count, the header too), or ParameterError
/// if a chosen column is not there.
PointTable parse_point_table(InputText input, const ColumnChoice& choice = {});

}  // namespace hodt
