#include "hodt/io/table_sample.h"

#include <algorithm>
#include <optional>

#include "hodt/io/field_kind.h"
#include "hodt/io/text_lines.h"

namespace hodt {

namespace {

constexpr std::size_t kMostRows = 100;

/// The rarer a character is inside numbers and names, the surer it separates.
constexpr char kSeparators[] = {';', '\t', '|', ',', kWhiteSpace};

/// A line of separators only holds no data.
bool is_hollow(std::string_view line) {
  return line.find_first_not_of(";,|\t \"\r") == line.npos;
}

std::string_view without_marks(std::string_view comment) {
  const std::size_t start = comment.find_first_not_of("#%!>/ \t");
  return start == comment.npos ? std::string_view() : trimmed(comment.substr(start));
}

/// What spreadsheets write on the first line: "sep=;".
std::optional<char> told_separator(std::string_view line) {
  const std::size_t quote = line.starts_with('"') ? 1 : 0;
  if (lower_case(line.substr(quote, 4)) != "sep=") return std::nullopt;
  if (line.size() <= quote + 4) return std::nullopt;
  return line[quote + 4];
}

/// Two numbers that another separator divides: "25 200000".
bool is_split_number(std::string_view field) {
  return field.find_first_of(" \t;|,") != field.npos &&
         field.find_first_not_of("0123456789+-. \t;|,") == field.npos &&
         !is_numeric(kind_of(field));
}

/// Whether the separator makes a row of numbers of the line, among other things.
bool divides(char separator, std::string_view line) {
  std::size_t numbers = 0;
  for (const std::string& field : split_row(line, separator)) {
    const FieldKind kind = kind_of(field);
    if (is_numeric(kind)) ++numbers;
    if (kind == FieldKind::point_text) numbers += 2;
    if (is_split_number(field)) return false;
  }
  return numbers >= 2;
}

char first_present(std::string_view line) {
  for (const char separator : kSeparators)
    if (separator == kWhiteSpace || filled_count(split_row(line, separator)) > 1) return separator;
  return kWhiteSpace;
}

char find_separator(const std::vector<SampleRow>& rows) {
  char best = first_present(rows.front().text);
  std::size_t most = 0;
  for (const char separator : kSeparators) {
    const auto divided =
        static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), [&](const SampleRow& row) {
          return divides(separator, row.text);
        }));
    if (divided > most) best = separator;
    most = std::max(most, divided);
  }
  return best;
}

}  // namespace

TableSample sample_of(const InputText& input) {
  TableSample sample;
  std::optional<char> told;
  const char* p = input.begin();
  for (; p < input.end() && sample.rows.size() < kMostRows; p = next_line(p, input.end())) {
    const std::string_view line = line_at(p, input.end());
    if (p == input.begin() && (told = told_separator(line))) continue;
    if (is_comment(skip_blanks(p))) {
      if (sample.rows.empty()) sample.comments.push_back(without_marks(line));
    } else if (!is_hollow(line)) {
      sample.rows.push_back({line, {}});
    }
  }
  if (sample.rows.empty()) return sample;
  sample.separator = told ? *told : find_separator(sample.rows);
  for (SampleRow& row : sample.rows) row.fields = split_row(row.text, sample.separator);
  return sample;
}

}  // namespace hodt
