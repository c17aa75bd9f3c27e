// Which separator a text table has, and which of its columns are the coordinates.
// Tested by tests/io/point_dialects_test.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hodt/io/column_choice.h"
#include "hodt/io/input_text.h"
#include "hodt/io/las/las_reader.h"
#include "hodt/io/table_sample.h"

namespace hodt {

/// What every row has to look like.
struct RowShape {
  /// The axis of a column that holds x, y and maybe z as text: POINT Z (1 2 3).
  static constexpr std::size_t kPointText = 3;

  /// A column that holds a coordinate: 0 for x, 1 for y, 2 for z.
  struct Source {
    std::size_t column = 0;
    std::size_t axis = 0;
  };

  char separator = ',';
  bool has_heights = false;
  bool point_text_has_height = false;
  bool height_from_point_text = false;
  bool has_header = false;
  bool ends_in_words = false;      ///< the last column holds words, which may contain the separator
  std::size_t columns = 0;         ///< no row has more
  std::size_t needed_columns = 0;  ///< no row has fewer
  std::array<Source, 3> sources;   ///< by column
  std::size_t source_count = 0;
};

/// A column that was taken for a coordinate.
struct TakenColumn {
  std::size_t number = 0;  ///< from 1
  std::string name;        ///< empty if it has none
};

struct TakenColumns {
  TakenColumn x, y;
  std::optional<TakenColumn> z;
  std::optional<LasCounts> las;  ///< of a LAS file: which of its points
  /// Of what is no table, where the coordinates are from instead: "x, y and z of layer 'spots'".
  std::string source = {};
};

/// How sure it is which columns are the coordinates.
enum class ColumnsKnown {
  told,      ///< by names, or by the user
  by_place,  ///< the first ones, for want of names
};

struct TableLayout {
  RowShape shape;
  const char* body = nullptr;  ///< behind the header
  ColumnsKnown known = ColumnsKnown::told;
  bool commas_may_divide_thousands = false;  ///< if there are decimal commas at all
  bool unknown_names = false;                ///< there is a header whose names say nothing
  TakenColumns taken;
  /// The number of rows that the file says it has.
  std::optional<std::uint64_t> announced_rows;
  std::vector<std::string> warnings;
};

/// Reads the layout off the sample, which has a row. Throws InputError, naming the line, if it does
/// not say which columns are x and y.
TableLayout layout_of(const InputText& input, const TableSample& sample,
                      const ColumnChoice& choice);

[[noreturn]] void throw_no_row(const InputText& input);

}  // namespace hodt
