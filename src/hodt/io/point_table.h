// Points from text tables: CSV, TSV and white-space separated XYZ.
#pragma once

#include "hodt/geometry/point_set.h"
#include "hodt/io/input_text.h"

namespace hodt {

/// Parses a table of points. The separator (semicolon, tab, comma or white space) shows in the
/// first row. If that is a header, it says which columns are x, y and z, by name; without one, or
/// with names that say nothing, they are the first three. Blank lines and lines that start with '#'
/// are skipped. Throws InputError, naming the line (all lines count, the header too).
PointSet parse_point_table(const InputText& input);

}  // namespace hodt
