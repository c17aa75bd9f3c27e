// The first rows of a table, on which its layout is read off. What they say is checked on every
// row.
// Tested by tests/io/point_dialects_test.cpp.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "hodt/io/input_text.h"

namespace hodt {

struct SampleRow {
  std::string_view text;            ///< the line in the input
  std::vector<std::string> fields;  ///< see split_row()
};

struct TableSample {
  char separator = ',';
  std::vector<std::string_view> comments;  ///< before the first row, without the marks
  std::vector<SampleRow> rows;
};

/// Reads the first rows and finds the separator: that which makes rows of numbers of most of them,
/// unless a line "sep=;" says it.
TableSample sample_of(const InputText& input);

}  // namespace hodt
