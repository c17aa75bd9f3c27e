#include "hodt/io/row_parser.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "hodt/io/text_encoding.h"

namespace hodt {

namespace {

/// Why a row is bad, field by field. Takes its time: there is one such row.
class Explanation {
 public:
  Explanation(std::string_view row, const RowShape& shape, char decimal)
      : row_(row), shape_(shape), decimal_(decimal), fields_(split_row(row, shape.separator)) {}

  std::string text() const {
    const std::size_t filled = filled_count(fields_);
    if (filled == 0) return {};
    if (row_.find('\r') != row_.npos)
      return "a carriage return inside the line; save the file with line feeds";
    if (filled > shape_.columns && !ends_in_remark()) return too_many(filled);
    for (std::size_t s = 0; s < shape_.source_count; ++s) {
      const RowShape::Source source = shape_.sources[s];
      const std::string problem =
          source.column < fields_.size() ? problem_of(source) : missing(source);
      if (!problem.empty()) return problem;
    }
    if (fields_.size() < shape_.needed_columns) return too_few();
    return "misplaced quotes; remove them";
  }

 private:
  bool ends_in_remark() const {
    return shape_.ends_in_words && kind_of(fields_[shape_.columns - 1]) == FieldKind::word;
  }

  std::string_view others() const { return shape_.has_header ? "header" : "first row"; }

  std::string too_many(std::size_t filled) const {
    if (!shape_.has_header && shape_.columns == 2 && filled == 3)
      return "a third value, but the first row has two; give every row a height, or none";
    const bool numbers = std::all_of(fields_.begin(), fields_.end(), [](const std::string& field) {
      return field.empty() || is_numeric(kind_of(field));
    });
    const bool decimal_commas = shape_.separator == ',' && numbers;
    return fmt::format(
        "the row has {} values and the {} has {}; {}", filled, others(), shape_.columns,
        decimal_commas ? "correct one of them, or, if commas are decimal signs, separate the "
                         "columns with semicolons"
                       : "correct one of them, or put values that contain the separator in "
                         "quotes");
  }

  std::string too_few() const {
    return fmt::format("the row has {} values and the {} has {}; correct one of them",
                       fields_.size(), others(), shape_.columns);
  }

  std::string missing(RowShape::Source source) const {
    const char* const name = kAxisNames[source.axis % kAxisNames.size()];
    return fmt::format("no value for {}: the row has {} column{}, {} is column {}", name,
                       fields_.size(), fields_.size() == 1 ? "" : "s", name, source.column + 1);
  }

  std::string problem_of(RowShape::Source source) const {
    const std::string& field = fields_[source.column];
    if (source.axis == RowShape::kPointText) return problem_of_point(field);
    const char* const name = kAxisNames[source.axis];
    switch (kind_of(field)) {
      case FieldKind::empty:
        return fmt::format("no value for {}; fill it in or remove the row", name);
      case FieldKind::number:
        return problem_of_number(field, name);
      case FieldKind::comma_number:
        return decimal_ == ',' ? std::string() : problem_of_comma(field, name);
      case FieldKind::missing:
        return fmt::format("{} is {}, not a finite number; correct or remove the row", name,
                           in_quotes(field));
      default:
        return fmt::format("{} for {} is not a number; correct or remove the row", in_quotes(field),
                           name);
    }
  }

  std::string problem_of_number(const std::string& field, const char* name) const {
    if (is_too_large(field)) {
      return fmt::format("{} is {}, not a finite number; correct or remove the row", name,
                         in_quotes(field));
    }
    if (decimal_ == ',' && field.find('.') != field.npos) {
      return fmt::format(
          "{} for {} has a decimal point, and other rows have decimal commas; write "
          "all of them alike",
          in_quotes(field), name);
    }
    return {};
  }

  std::string problem_of_comma(const std::string& field, const char* name) const {
    return fmt::format(
        "the comma in {} for {} can be a decimal sign or divide thousands; write "
        "decimals with a point, and nothing between thousands",
        in_quotes(field), name);
  }

  std::string problem_of_point(const std::string& field) const {
    if (kind_of(field) != FieldKind::point_text)
      return fmt::format("{} is no POINT; points are all that hodt reads", in_quotes(field));
    if (point_text_has_height(field) == shape_.point_text_has_height) {
      return fmt::format("{} is not a point of two to four numbers; correct or remove the row",
                         in_quotes(field));
    }
    return fmt::format("{} {} a height, unlike the first row; give every row one, or none",
                       in_quotes(field), shape_.point_text_has_height ? "lacks" : "has");
  }

  std::string_view row_;
  const RowShape& shape_;
  char decimal_;
  std::vector<std::string> fields_;
};

}  // namespace

std::string explain_row(std::string_view row, const RowShape& shape, char decimal) {
  return Explanation(row, shape, decimal).text();
}

bool has_decimal_comma(std::string_view row, const RowShape& shape) {
  const std::vector<std::string> fields = split_row(row, shape.separator);
  for (std::size_t s = 0; s < shape.source_count; ++s) {
    const std::size_t column = shape.sources[s].column;
    if (column < fields.size() && kind_of(fields[column]) == FieldKind::comma_number) return true;
  }
  return false;
}

}  // namespace hodt
