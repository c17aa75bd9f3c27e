// Which lines at the top of a table are no points, and what they say.
// Tested by tests/io/point_dialects_test.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hodt/io/column_choice.h"
#include "hodt/io/input_text.h"
#include "hodt/io/table_sample.h"

namespace hodt {

struct TableHeader {
  std::size_t rows = 0;            ///< of the sample that are no points
  std::string_view line;           ///< the line of the names
  std::vector<std::string> names;  ///< of the columns; empty without a header
  /// The number of rows that the file says it has.
  std::optional<std::uint64_t> announced_rows;
};

/// Reads the header off the sample, which has a row: the number of rows, names of columns, be it in
/// a comment, and units. A row of values that are no numbers is no header. Throws InputError,
/// naming the line, if a line is neither a header nor a row.
TableHeader header_of(const InputText& input, const TableSample& sample,
                      const ColumnChoice& choice);

}  // namespace hodt
