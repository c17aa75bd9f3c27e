// Which separator a text table has, and which of its columns are the coordinates.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace hodt {

struct TableLayout {
  /// The separator of fields that means runs of spaces and tabs.
  static constexpr char kWhiteSpace = ' ';

  /// A column that holds a coordinate: 0 for x, 1 for y, 2 for z.
  struct Source {
    std::size_t column = 0;
    std::size_t axis = 0;
  };

  char separator = ',';
  bool has_header = false;
  bool has_heights = false;
  std::size_t columns = 0;  ///< of the first row
  /// By column; the third counts only if has_heights.
  std::array<Source, 3> sources;

  std::size_t source_count() const { return has_heights ? 3 : 2; }
};

/// Reads the layout off the table's first row. Throws InputError, naming `where`, if there are
/// fewer than two columns or the header names some coordinates without the others.
TableLayout layout_of(std::string_view first_row, const std::string& where);

/// The fields of a row, quotes and outer blanks taken off.
std::vector<std::string> split_row(std::string_view row, char separator);

/// Whether the text spells a number, finite or not.
bool spells_number(std::string_view text);

}  // namespace hodt
