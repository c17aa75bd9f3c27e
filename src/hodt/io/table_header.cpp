#include "hodt/io/table_header.h"

#include <algorithm>
#include <charconv>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/column_names.h"
#include "hodt/io/field_kind.h"
#include "hodt/io/text_lines.h"

namespace hodt {

namespace {

using Fields = std::vector<std::string>;

bool any_of(const Fields& fields, bool (*test)(FieldKind)) {
  return std::any_of(fields.begin(), fields.end(),
                     [&](const std::string& field) { return test(kind_of(field)); });
}

bool all_differ(Fields names) {
  std::sort(names.begin(), names.end());
  return std::adjacent_find(names.begin(), names.end()) == names.end();
}

/// "X [m] Y [m]" between blanks: the names without their units.
Fields without_brackets(const Fields& fields) {
  Fields names;
  std::copy_if(fields.begin(), fields.end(), std::back_inserter(names), [](const auto& field) {
    return !((field.starts_with('[') || field.starts_with('(')) && is_unit(field));
  });
  return names;
}

/// Reads a header off a sample, from the top of the file.
class HeaderFinder {
 public:
  HeaderFinder(const InputText& input, const TableSample& sample, const ColumnChoice& choice)
      : input_(input), sample_(sample), choice_(choice) {}

  TableHeader find() && {
    take_announcement();
    take_header();
    if (!header_.names.empty()) take_row_names();
    return std::move(header_);
  }

 private:
  /// The rows that are still to be understood.
  std::span<const SampleRow> rows() const { return std::span(sample_.rows).subspan(header_.rows); }
  const Fields& first() const { return rows().front().fields; }

  [[noreturn]] void refuse(std::string_view line, const std::string& why) const {
    throw InputError(fmt::format("{}: {}", place_of(input_, line.data()), why));
  }

  /// A first line that is only the number of rows, as in PTS files.
  void take_announcement() {
    if (rows().size() < 2 || filled_count(first()) != 1 || filled_count(rows()[1].fields) < 2)
      return;
    const std::string& field = first()[0];
    std::uint64_t count = 0;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), count);
    if (error != std::errc() || end != field.data() + field.size()) return;
    header_.announced_rows = count;
    ++header_.rows;
  }

  void take_header() {
    const SampleRow& row = rows().front();
    if (is_header(row.fields)) {
      const std::size_t below = rows().size() > 1 ? rows()[1].fields.size() : row.fields.size();
      const Fields bare = without_brackets(row.fields);
      take_names(row.text, bare.size() == below ? bare : row.fields);
      ++header_.rows;
    } else if (rows().size() > 1 && filled_count(row.fields) == 1 &&
               filled_count(rows()[1].fields) > 1) {
      take_header_of_its_own(row.text);
      ++header_.rows;
    } else {
      take_header_from_comments();
    }
    if (!header_.names.empty() && !rows().empty() && is_row_of_units(first())) ++header_.rows;
  }

  bool is_header(const Fields& fields) const {
    if (names_choice(fields) || find_columns(fields).plane()) return true;
    // Values that are no numbers, like NA, must not vanish as names.
    const std::size_t others = rows().size() > 1 ? filled_count(rows()[1].fields) : 1;
    const bool narrow = filled_count(fields) == 1 && others > 1;
    return !any_of(fields, is_data) && !narrow && (all_differ(fields) || !choice_.empty());
  }

  /// Whether all columns that the user chose by name are there, and some is.
  bool names_choice(const Fields& fields) const {
    bool named = false;
    for (const std::string& column : choice_.axes) {
      if (column.empty() || is_whole(column)) continue;
      if (!column_called(column, fields)) return false;
      named = true;
    }
    return named;
  }

  void take_names(std::string_view line, const Fields& fields) {
    header_.line = line;
    header_.names = fields;
  }

  /// The names on a line whose separator may be another than the table's, if there are `count`.
  std::optional<Fields> names_on(std::string_view line, std::size_t count) const {
    for (const char separator : {sample_.separator, ';', '\t', '|', ',', kWhiteSpace}) {
      Fields names = split_row(line, separator);
      if (names.size() == count) return names;
      if (names = without_brackets(names); names.size() == count) return names;
    }
    return std::nullopt;
  }

  void take_header_of_its_own(std::string_view line) {
    const auto names = names_on(line, rows()[1].fields.size());
    if (!names || any_of(*names, is_data)) {
      refuse(line,
             fmt::format("this line has one value and the next has {}; remove it, or start it "
                         "with #",
                         filled_count(rows()[1].fields)));
    }
    take_names(line, *names);
  }

  /// A comment above the rows can name their columns: "# lat lon z".
  void take_header_from_comments() {
    for (auto comment = sample_.comments.rbegin(); comment != sample_.comments.rend(); ++comment) {
      const auto names = names_on(*comment, filled_count(first()));
      if (names && (find_columns(*names).plane() || names_choice(*names)))
        return take_names(*comment, *names);
      if (is_prose(*comment)) continue;
      refuse(*comment,
             fmt::format("these look like names of columns, but do not fit the {} columns "
                         "below; correct or remove the comment, or {}",
                         filled_count(first()), kSayColumns));
    }
  }

  /// Whether a comment is no header: it does not name x and y, or few of its words are names.
  static bool is_prose(std::string_view comment) {
    for (const char separator : {';', '\t', '|', ',', kWhiteSpace}) {
      const Fields names = split_row(comment, separator);
      const auto known = std::count_if(names.begin(), names.end(), [](const std::string& name) {
        return role_of(name) != ColumnRole::unknown;
      });
      const NamedColumns found = find_columns(names);
      if (2 * static_cast<std::size_t>(known) >= names.size() &&
          (found.plane() || found.several_planes))
        return false;
    }
    return true;
  }

  static bool is_row_of_units(const Fields& fields) {
    const auto unit_or_empty = [](const std::string& field) {
      return field.empty() || is_unit(field);
    };
    return std::all_of(fields.begin(), fields.end(), unit_or_empty);
  }

  /// R writes the names of rows, but no name above them.
  void take_row_names() {
    const std::size_t with_row_name = header_.names.size() + 1;
    for (const SampleRow& row : rows()) {
      if (filled_count(row.fields) != with_row_name) return;
    }
    if (have_row_names()) header_.names.insert(header_.names.begin(), "");
  }

  bool have_row_names() const {
    const auto is_named = [](const SampleRow& row) {
      return trimmed(row.text).starts_with('"') || kind_of(row.fields[0]) == FieldKind::word;
    };
    if (std::all_of(rows().begin(), rows().end(), is_named)) return true;
    for (std::size_t i = 0; i < rows().size(); ++i)
      if (rows()[i].fields[0] != std::to_string(i + 1)) return false;
    return rows().size() > 1;
  }

  const InputText& input_;
  const TableSample& sample_;
  const ColumnChoice& choice_;
  TableHeader header_;
};

}  // namespace

TableHeader header_of(const InputText& input, const TableSample& sample,
                      const ColumnChoice& choice) {
  return HeaderFinder(input, sample, choice).find();
}

}  // namespace hodt
