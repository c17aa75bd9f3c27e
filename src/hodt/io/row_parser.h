// Reading the rows of a table, fast.
// Tested by tests/io/point_file_test.cpp.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "hodt/io/field_kind.h"
#include "hodt/io/number_text.h"
#include "hodt/io/point_text.h"
#include "hodt/io/table_layout.h"
#include "hodt/io/text_lines.h"

namespace hodt {

/// Reads rows of one shape whose decimals stand behind `Decimal`. Whoever finds a row bad asks
/// explain_row() for the reason.
template <char Decimal>
class RowParser {
 public:
  explicit RowParser(const RowShape& shape) : shape_(shape) {}

  /// Reads the row at p, which holds data, into values by axis. Returns the end of what it read,
  /// somewhere on the row, or nullptr if the row is bad.
  const char* parse(const char* p, double* values) const {
    std::size_t column = 0;
    bool more = true;  // p stands at the start of a field
    p = skip_indent(p);
    for (std::size_t s = 0; s < shape_.source_count; ++s) {
      const RowShape::Source source = shape_.sources[s];
      for (; p && more && column < source.column; ++column) p = skip_field(p, more);
      if (!p || !more) return nullptr;
      p = source.axis == RowShape::kPointText ? parse_point(p, values, more)
                                              : parse_field(p, values[source.axis], more);
      if (!p) return nullptr;
      ++column;
    }
    if (!more) return column >= shape_.needed_columns ? p : nullptr;
    return parse_rest(p, column);
  }

 private:
  bool blank_separated() const { return shape_.separator == kWhiteSpace; }
  /// Blanks that belong to no field; a tab can be the separator itself.
  const char* skip_indent(const char* p) const {
    if (shape_.separator != '\t') return skip_blanks(p);
    while (*p == ' ') ++p;
    return p;
  }

  /// Steps over the end of a field. `more` tells whether another field follows; nullptr if p is not
  /// at the end of a field.
  const char* leave_field(const char* p, bool& more) const {
    const char* const field_end = p;
    p = skip_indent(p);
    if (const char* const feed = skip_returns(p); *feed == '\n') {
      more = false;
      return feed;
    }
    more = true;
    if (blank_separated()) return p != field_end ? p : nullptr;
    return *p == shape_.separator ? p + 1 : nullptr;
  }

  /// Reads a field, in quotes or not, by parse_value(p), which returns the end of the value.
  template <class ParseValue>
  const char* parse_quoted(const char* p, bool& more, const ParseValue& parse_value) const {
    p = skip_indent(p);
    const bool quoted = *p == '"';
    if (quoted) p = skip_blanks(p + 1);
    p = parse_value(p);
    if (!p) return nullptr;
    if (quoted) {
      p = skip_blanks(p);
      if (*p++ != '"') return nullptr;
    }
    return leave_field(p, more);
  }

  const char* parse_field(const char* p, double& value, bool& more) const {
    return parse_quoted(p, more, [&](const char* q) { return parse_number<Decimal>(q, value); });
  }

  const char* parse_point(const char* p, double* values, bool& more) const {
    double point[3] = {};
    bool has_height = false;
    p = parse_quoted(p, more,
                     [&](const char* q) { return parse_point_text(q, point, has_height); });
    if (!p || has_height != shape_.point_text_has_height) return nullptr;
    values[0] = point[0];
    values[1] = point[1];
    if (shape_.height_from_point_text) values[2] = point[2];
    return p;
  }

  /// Steps over any field; nullptr if quotes in it do not match.
  const char* skip_field(const char* p, bool& more) const {
    p = skip_indent(p);
    if (*p == '"') {
      bool quoted = false;
      for (; *p != '\n' && (quoted || !ends_field(*p)); ++p) quoted ^= *p == '"';
      if (quoted) return nullptr;
    } else {
      while (*p != '\n' && !ends_field(*p)) ++p;
    }
    if (*p == '\n') {
      more = false;
      return p;
    }
    return leave_field(p, more);
  }
  bool ends_field(char c) const {
    return blank_separated() ? c == ' ' || c == '\t' : c == shape_.separator;
  }

  /// Checks that the fields behind the coordinates are as many as they should be: no more than the
  /// table has columns, but for separators at the end; no fewer, but for remarks left out.
  const char* parse_rest(const char* p, std::size_t column) const {
    bool more = true;
    std::size_t filled = column;
    for (; more; ++column) {
      p = skip_indent(p);
      const bool empty = *p == shape_.separator || *skip_returns(p) == '\n';
      if (!empty) filled = column + 1;
      // A remark may contain the separator.
      if (column + 1 == shape_.columns && shape_.ends_in_words && starts_word(*p)) return p;
      if (filled > shape_.columns) return nullptr;
      p = skip_field(p, more);
      if (!p) return nullptr;
    }
    return column >= shape_.needed_columns ? p : nullptr;
  }

  static bool starts_word(char c) {
    const char lower = static_cast<char>(c | 0x20);
    return ('a' <= lower && lower <= 'z') || static_cast<unsigned char>(c) >= 0x80;
  }

  RowShape shape_;
};

/// What is wrong with a row that RowParser<Decimal> refused, with a remedy; empty if the row holds
/// nothing but separators.
std::string explain_row(std::string_view row, const RowShape& shape, char decimal);

/// Whether a coordinate on the row has a decimal comma.
bool has_decimal_comma(std::string_view row, const RowShape& shape);

}  // namespace hodt
