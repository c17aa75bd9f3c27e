#include "hodt/io/table_layout.h"

#include <algorithm>
#include <charconv>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/column_names.h"
#include "hodt/io/field_kind.h"
#include "hodt/io/point_text.h"
#include "hodt/io/table_header.h"
#include "hodt/io/text_encoding.h"
#include "hodt/io/text_lines.h"

namespace hodt {

namespace {

using Fields = std::vector<std::string>;
constexpr std::size_t kX = 0, kY = 1, kZ = 2;

bool is_text(FieldKind kind) {
  return kind == FieldKind::word || kind == FieldKind::spoilt;
}

/// The columns of the three coordinates, as far as they are known.
using AxisColumns = std::array<std::optional<std::size_t>, 3>;

/// Reads a layout off the rows below the header.
class LayoutFinder {
 public:
  LayoutFinder(const InputText& input, const TableSample& sample, const TableHeader& header,
               const ColumnChoice& choice)
      : input_(input),
        rows_(std::span(sample.rows).subspan(header.rows)),
        choice_(choice),
        header_(header.line),
        names_(header.names) {
    layout_.announced_rows = header.announced_rows;
    layout_.shape.separator = sample.separator;
    layout_.shape.has_header = !names_.empty();
  }

  TableLayout find() && {
    set_columns();
    find_sources();
    describe();
    layout_.commas_may_divide_thousands = commas_may_divide_thousands();
    layout_.body = rows_.front().text.data();
    return std::move(layout_);
  }

 private:
  const Fields& first() const { return rows_.front().fields; }

  [[noreturn]] void refuse(std::string_view line, const std::string& why) const {
    throw InputError(fmt::format("{}: {}", place_of(input_, line.data()), why));
  }

  void set_columns() {
    RowShape& shape = layout_.shape;
    const std::size_t widest = filled_count(first());
    while (names_.size() > widest && names_.back().empty() && !has_values(names_.size() - 1))
      names_.pop_back();
    shape.columns = names_.empty() || chosen_by_number() ? widest : names_.size();
    const bool has_point_text = first_point_text().has_value();
    if (shape.columns < 2 && !has_point_text) {
      refuse(rows_.front().text,
             "only one column; a row needs x and y, and z if there are heights");
    }
    shape.needed_columns = shape.columns;
    while (shape.needed_columns > 1 && holds_words(shape.needed_columns - 1))
      --shape.needed_columns;
    shape.ends_in_words = holds_words(shape.columns - 1);
  }

  bool chosen_by_number() const {
    return !choice_.empty() &&
           std::all_of(choice_.axes.begin(), choice_.axes.end(), [&](const std::string& column) {
             return column.empty() || (is_whole(column) && !column_called(column, names_));
           });
  }

  bool has_values(std::size_t column) const {
    return std::any_of(rows_.begin(), rows_.end(), [&](const SampleRow& row) {
      return column < row.fields.size() && !row.fields[column].empty();
    });
  }

  /// Whether words stand in the column, and no numbers.
  bool holds_words(std::size_t column) const {
    bool words = false;
    for (const SampleRow& row : rows_) {
      if (column >= row.fields.size()) continue;
      const FieldKind kind = kind_of(row.fields[column]);
      if (is_numeric(kind)) return false;
      words = words || is_text(kind);
    }
    return words;
  }

  std::optional<std::size_t> first_point_text() const {
    for (std::size_t i = 0; i < first().size(); ++i)
      if (kind_of(first()[i]) == FieldKind::point_text) return i;
    return std::nullopt;
  }

  void find_sources() {
    AxisColumns columns = chosen_columns();
    if (!columns[kX] && !columns[kY] && first_point_text() && !find_columns(names_).plane())
      return take_point_text(columns[kZ]);
    if (!columns[kX] || !columns[kY] || !columns[kZ]) {
      names_.empty() ? use_places(columns) : use_names(columns);
    }
    take(columns);
  }

  AxisColumns chosen_columns() const {
    AxisColumns columns;
    for (std::size_t axis = 0; axis < columns.size(); ++axis)
      if (!choice_.axes[axis].empty()) columns[axis] = chosen_column(choice_.axes[axis]);
    return columns;
  }

  std::size_t chosen_column(const std::string& column) const {
    if (const auto named = column_called(column, names_)) return *named;
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(column.data(), column.data() + column.size(), number);
    const bool is_number = error == std::errc() && end == column.data() + column.size();
    if (is_number && 0 < number && number <= layout_.shape.columns) return number - 1;
    if (is_number || names_.empty()) {
      throw ParameterError(fmt::format("{}: there is no column {}; the table has {} columns{}",
                                       input_.name, in_quotes(column), layout_.shape.columns,
                                       names_.empty() ? " and no header" : ""));
    }
    throw ParameterError(fmt::format("{}: there is no column {}; the columns are {}", input_.name,
                                     in_quotes(column), listed(names_)));
  }

  void use_names(AxisColumns& columns) {
    const bool plane_chosen = columns[kX] && columns[kY];
    const NamedColumns found = find_columns(names_);
    if (!plane_chosen && !found.plane()) {
      const bool few = names_.size() <= 3 && choice_.empty();
      if (few && only_number_columns(names_)) return use_unknown_names(columns);
      refuse_names(
          found.plane_problem.empty()
              ? fmt::format("the names {} do not say which columns are x and y", listed(names_))
              : found.plane_problem);
    }
    if (!found.height_problem.empty() && !columns[kZ]) refuse_names(found.height_problem);
    if (!columns[kX]) columns[kX] = found.x;
    if (!columns[kY]) columns[kY] = found.y;
    if (!columns[kZ]) columns[kZ] = found.z;
    if (!columns[kZ]) warn_of_no_height(columns);
  }

  [[noreturn]] void refuse_names(const std::string& problem) const {
    refuse(header_, fmt::format("{}; {}", problem, kSayColumns));
  }

  /// Two or three columns with names that only number them are x, y and z in their order, like a
  /// table without a header, unless the values speak against it.
  void use_unknown_names(AxisColumns& columns) {
    layout_.unknown_names = true;
    take_first(columns);
    layout_.warnings.push_back(
        fmt::format("the names {} only number the columns, which were taken for x, y{} in their "
                    "order",
                    listed(names_), names_.size() > 2 ? ", z" : ""));
  }

  void take_first(AxisColumns& columns) {
    layout_.known = ColumnsKnown::by_place;
    columns[kX] = 0;
    columns[kY] = 1;
    if (layout_.shape.columns > 2) columns[kZ] = 2;
  }

  void warn_of_no_height(const AxisColumns& columns) {
    Fields candidates;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (i == columns[kX] || i == columns[kY] || i >= first().size()) continue;
      if (role_of(names_[i]) == ColumnRole::unknown && is_numeric(kind_of(first()[i])))
        candidates.push_back(names_[i]);
    }
    if (candidates.empty()) return;
    layout_.warnings.push_back(
        fmt::format("no name says which column holds the heights, so there are none; if it is one "
                    "of {}, say so, as in --columns z={}",
                    listed(candidates), readable(candidates[0])));
  }

  void use_places(AxisColumns& columns) {
    if (columns[kX] && columns[kY]) return;  // without z: no heights
    const std::string_view line = rows_.front().text;
    if (!choice_.empty()) {
      refuse(line,
             "there is no header to find the other columns by; give x and y, and z if there "
             "are heights, each a number");
    }
    refuse_words();
    refuse_decimal_commas();
    take_first(columns);
  }

  /// Where words are, one of the first columns can well be a point's number.
  void refuse_words() const {
    for (const SampleRow& row : rows_) {
      const bool is_first = &row == &rows_.front();
      for (std::size_t i = is_first ? 0 : 3; i < row.fields.size(); ++i) {
        if (!is_text(kind_of(row.fields[i]))) continue;
        refuse(row.text,
               fmt::format("{} in column {} is no number, and there is no header that names "
                           "the columns; {}",
                           in_quotes(row.fields[i]), i + 1, kSayColumns));
      }
    }
  }

  /// "600000,25,200000,5" are two numbers or four.
  void refuse_decimal_commas() const {
    const std::size_t columns = layout_.shape.columns;
    if (layout_.shape.separator != ',' || columns < 4 || columns % 2 != 0) return;
    for (const SampleRow& row : rows_)
      for (const std::string& field : row.fields)
        if (!is_whole(field)) return;
    refuse(
        rows_.front().text,
        fmt::format("{} whole numbers without a header: if the commas are decimal signs, separate "
                    "the columns with semicolons; if not, {}",
                    columns, kSayColumns));
  }

  void take(const AxisColumns& columns) {
    RowShape& shape = layout_.shape;
    for (std::size_t axis = 0; axis < columns.size(); ++axis) {
      if (!columns[axis]) continue;
      for (std::size_t other = 0; other < axis; ++other) {
        if (columns[other] != columns[axis]) continue;
        throw ParameterError(fmt::format("{}: {} and {} are both column {}; each needs its own",
                                         input_.name, kAxisNames[other], kAxisNames[axis],
                                         *columns[axis] + 1));
      }
      shape.sources[shape.source_count++] = {*columns[axis], axis};
    }
    shape.has_heights = columns[kZ].has_value();
  }

  void take_point_text(std::optional<std::size_t> height) {
    RowShape& shape = layout_.shape;
    const std::size_t column = *first_point_text();
    shape.sources[shape.source_count++] = {column, RowShape::kPointText};
    shape.point_text_has_height = point_text_has_height(first()[column]);
    if (!height && !shape.point_text_has_height) {
      const NamedColumns found = find_columns(names_);
      height = found.z;
    }
    if (height) shape.sources[shape.source_count++] = {*height, kZ};
    shape.height_from_point_text = !height && shape.point_text_has_height;
    shape.has_heights = height || shape.height_from_point_text;
  }

  void describe() {
    RowShape& shape = layout_.shape;
    const auto column = [&](std::size_t index) {
      const std::string name = index < names_.size() ? readable(names_[index]) : "";
      return TakenColumn{index + 1, name};
    };
    for (std::size_t s = 0; s < shape.source_count; ++s) {
      const RowShape::Source source = shape.sources[s];
      const bool text = source.axis == RowShape::kPointText;
      if (source.axis == kX || text) layout_.taken.x = column(source.column);
      if (source.axis == kY || text) layout_.taken.y = column(source.column);
      if (source.axis == kZ || (text && shape.height_from_point_text))
        layout_.taken.z = column(source.column);
    }
    std::sort(shape.sources.begin(), shape.sources.begin() + shape.source_count,
              [](const auto& a, const auto& b) { return a.column < b.column; });
    const std::size_t last = shape.sources[shape.source_count - 1].column;
    shape.needed_columns = std::max(shape.needed_columns, last + 1);
    if (last + 1 == shape.columns) shape.ends_in_words = false;
  }

  /// Whether 600,000 can be six hundred thousand: so all numbers from 1000 on are written, and some
  /// smaller ones without a comma.
  bool commas_may_divide_thousands() const {
    bool divided = false, undivided = false;
    for (const SampleRow& row : rows_) {
      for (std::size_t s = 0; s < layout_.shape.source_count; ++s) {
        const std::size_t column = layout_.shape.sources[s].column;
        if (column >= row.fields.size()) continue;
        std::string_view digits = row.fields[column];
        if (digits.starts_with('-')) digits.remove_prefix(1);
        const std::size_t comma = digits.find(',');
        if (!is_whole(digits.substr(0, comma)) || comma == 0 || digits.substr(0, comma).size() > 3)
          return false;
        if (comma != digits.npos && (digits.size() != comma + 4 || digits.starts_with('0')))
          return false;
        (comma == digits.npos ? undivided : divided) = true;
      }
    }
    return divided && undivided;
  }

  const InputText& input_;
  std::span<const SampleRow> rows_;
  const ColumnChoice& choice_;
  std::string_view header_;
  Fields names_;
  TableLayout layout_;
};

}  // namespace

void throw_no_row(const InputText& input) {
  throw InputError(fmt::format("{} holds no data row; a row is x, y and, if known, z", input.name));
}

TableLayout layout_of(const InputText& input, const TableSample& sample,
                      const ColumnChoice& choice) {
  const TableHeader header = header_of(input, sample, choice);
  if (header.rows == sample.rows.size()) throw_no_row(input);
  return LayoutFinder(input, sample, header, choice).find();
}

}  // namespace hodt
