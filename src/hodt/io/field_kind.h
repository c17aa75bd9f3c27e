// What the text in a field of a table can be.
// Tested by tests/io/point_dialects_test.cpp.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hodt {

/// The separator of fields that means runs of spaces and tabs.
inline constexpr char kWhiteSpace = ' ';

enum class FieldKind {
  empty,
  number,        ///< also one that is too large for a double
  comma_number,  ///< with a decimal comma: 600000,25
  point_text,    ///< POINT Z (1 2 3)
  missing,       ///< NA, nan, ---
  spoilt,        ///< starts like a number, and is none: 451m, 12:30
  word,
};

FieldKind kind_of(std::string_view field);

/// Whether the field can only stand in a row of data, never in a header.
inline bool is_data(FieldKind kind) {
  return kind != FieldKind::empty && kind != FieldKind::word;
}

/// Whether the field is a number, with a decimal point or a decimal comma.
inline bool is_numeric(FieldKind kind) {
  return kind == FieldKind::number || kind == FieldKind::comma_number;
}

/// Whether the text spells a number that no double can hold.
bool is_too_large(std::string_view text);

/// Whether the text spells an integer.
bool is_whole(std::string_view text);

/// The fields of a row, quotes and outer blanks taken off. A field that is empty behind the last
/// separator counts.
std::vector<std::string> split_row(std::string_view row, char separator);

/// How many fields there are up to the last one that is not empty.
std::size_t filled_count(const std::vector<std::string>& fields);

/// The text without outer blanks.
std::string_view trimmed(std::string_view text);

/// The text with ASCII letters in lower case.
std::string lower_case(std::string_view text);

}  // namespace hodt
