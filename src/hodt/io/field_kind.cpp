#include "hodt/io/field_kind.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "hodt/io/number_text.h"

namespace hodt {

namespace {

/// What programs write where there is no value.
constexpr std::string_view kMissing[] = {
    "na",      "n/a",  "nan",      "-nan",      "null",   "none",    "nil",
    "inf",     "-inf", "+inf",     "#n/a",      "#na",    "-",       "--",
    "---",     "?",    "infinity", "-infinity", ".",      "..",      "nodata",
    "no data", "void", "-1.#ind",  "1.#qnan",   "1.#inf", "#value!", "#wert!"};

/// What parse_number makes of all of the text: its end, or nullptr.
template <char Decimal>
bool spells(std::string_view text) {
  std::string padded(text);
  padded += '\n';
  padded.append(8, '\0');
  double ignored = 0;
  return parse_number<Decimal>(padded.data(), ignored) == padded.data() + text.size();
}

bool starts_like_a_number(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  if (text.starts_with('.') || text.starts_with(',')) text.remove_prefix(1);
  return !text.empty() && number_text::is_digit(text.front());
}

bool is_point_text(std::string_view text) {
  std::string start = lower_case(text.substr(0, 32));
  if (start.starts_with("srid=")) start.erase(0, start.find(';') + 1);
  if (!start.starts_with("point")) return false;
  const std::size_t rest = start.find_first_not_of(" zm", 5);
  if (rest == start.npos) return false;
  return start[rest] == '(' ? text.ends_with(')') : start.substr(rest) == "empty";
}

/// One quoted or plain field from the front of the row; takes it off, but not its separator.
std::string take_field(std::string_view& row, char separator) {
  const auto ends_field = [&](char c) {
    return separator == kWhiteSpace ? c == ' ' || c == '\t' : c == separator;
  };
  std::string field;
  const std::size_t start = row.find_first_not_of(separator == '\t' ? " " : " \t");
  const bool quotes = start != row.npos && row[start] == '"';
  bool quoted = false;
  std::size_t i = 0;
  for (; i < row.size() && (quoted || !ends_field(row[i])); ++i) {
    if (quotes && row[i] == '"') {
      quoted = !quoted;
    } else {
      field.push_back(row[i]);
    }
  }
  row.remove_prefix(i);
  return std::string(trimmed(field));
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

bool is_whole(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  return !text.empty() && std::all_of(text.begin(), text.end(), number_text::is_digit);
}

bool is_too_large(std::string_view text) {
  // parse_number() refuses it, but its digits and its exponent are fine.
  const std::size_t exponent = text.find_first_of("eEdD");
  return !spells<'.'>(text) && exponent != text.npos && spells<'.'>(text.substr(0, exponent)) &&
         is_whole(text.substr(exponent + 1));
}

FieldKind kind_of(std::string_view field) {
  if (field.empty()) return FieldKind::empty;
  if (spells<'.'>(field)) return FieldKind::number;
  if (spells<','>(field)) return FieldKind::comma_number;
  if (is_too_large(field)) return FieldKind::number;
  if (is_point_text(field)) return FieldKind::point_text;
  if (field.find_first_not_of('*') == field.npos) return FieldKind::missing;  // Fortran's overflow
  const std::string lower = lower_case(field);
  if (std::find(std::begin(kMissing), std::end(kMissing), lower) != std::end(kMissing))
    return FieldKind::missing;
  return starts_like_a_number(field) ? FieldKind::spoilt : FieldKind::word;
}

std::vector<std::string> split_row(std::string_view row, char separator) {
  std::vector<std::string> fields;
  if (separator == kWhiteSpace) {
    for (row = trimmed(row); !row.empty(); row = trimmed(row))
      fields.push_back(take_field(row, separator));
    return fields;
  }
  for (;;) {
    fields.push_back(take_field(row, separator));
    if (row.empty()) return fields;
    row.remove_prefix(1);
  }
}

std::size_t filled_count(const std::vector<std::string>& fields) {
  const auto last = std::find_if(fields.rbegin(), fields.rend(),
                                 [](const std::string& field) { return !field.empty(); });
  return static_cast<std::size_t>(fields.rend() - last);
}

}  // namespace hodt
