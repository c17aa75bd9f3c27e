#include "hodt/io/esri_grid.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/number_text.h"
#include "hodt/io/text_encoding.h"
#include "hodt/io/text_lines.h"

namespace hodt {

namespace {

bool is_space(char c) {
  return c == ' ' || ('\t' <= c && c <= '\r');
}

const char* skip_spaces(const char* p, const char* end) {
  while (p != end && is_space(*p)) ++p;
  return p;
}

std::string_view word_at(const char* p, const char* end) {
  const char* last = p;
  while (last != end && !is_space(*last)) ++last;
  return {p, static_cast<std::size_t>(last - p)};
}

std::string lower(std::string_view word) {
  std::string text(word);
  for (char& c : text)
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

struct Header {
  std::uint64_t columns = 0, rows = 0;
  const char* values = nullptr;  ///< where they begin
};

/// Reads pairs of a name and a value, as long as they are those of a header.
Header header_of(const InputText& input) {
  Header header;
  const char* p = skip_spaces(input.begin(), input.end());
  while (p != input.end()) {
    const std::string_view word = word_at(p, input.end());
    constexpr std::string_view names[] = {"ncols",     "nrows",       "xllcorner", "xllcenter",
                                          "yllcorner", "yllcenter",   "cellsize",  "dx",
                                          "dy",        "nodata_value"};
    const std::string name = lower(word);
    if (std::find(std::begin(names), std::end(names), name) == std::end(names)) break;
    const std::string_view value =
        word_at(skip_spaces(word.data() + word.size(), input.end()), input.end());
    std::uint32_t count = 0;
    const bool is_whole = std::from_chars(value.data(), value.data() + value.size(), count).ptr ==
                          value.data() + value.size();
    if (name == "ncols" && is_whole) header.columns = count;
    if (name == "nrows" && is_whole) header.rows = count;
    p = skip_spaces(value.data() + value.size(), input.end());
  }
  header.values = p;
  return header;
}

/// NaN as programs write it, and as GDAL reads it.
bool is_nan(std::string_view word) {
  const std::string text = lower(word);
  return text == "nan" || text == "-nan" || text == "-1.#ind" || text == "1.#qnan" ||
         text == "-1.#qnan";
}

/// Whether it is a number from its begin to its end, as GDAL reads numbers: without Fortran's
/// exponents, decimals behind a point or a comma.
bool is_number(std::string_view word) {
  double value = 0;
  const char* const end = word.data() + word.size();
  if (parse_number(word.data(), value) == end)
    return word.find_first_of("dD") == std::string_view::npos;
  return word.find(',') != std::string_view::npos && parse_number<','>(word.data(), value) == end &&
         word.find_first_of("dD") == std::string_view::npos;
}

[[noreturn]] void refuse(const InputText& input, const char* line, const std::string& why) {
  throw InputError(fmt::format("{}: {}", place_of(input, line), why));
}

/// How many values the line has. Throws InputError for one that is none.
std::uint64_t count_values(const InputText& input, const char* line, const char* end) {
  std::uint64_t count = 0;
  for (const char* p = skip_spaces(line, end); p != end; p = skip_spaces(p, end)) {
    const std::string_view word = word_at(p, end);
    if (!is_number(word) && !is_nan(word))
      refuse(input, p,
             fmt::format("{} is no number; give cells without a height the NODATA_value",
                         in_quotes(word)));
    ++count;
    p += word.size();
  }
  return count;
}

}  // namespace

void check_esri_grid(const InputText& input) {
  const Header header = header_of(input);
  if (header.columns == 0 || header.rows == 0) return;
  std::uint64_t values = 0, lines = 0, odd_lines = 0, values_of_odd = 0;
  const char* odd = nullptr;  // the first line that is no row by itself
  const char* last = header.values;
  for (const char* line = header.values; line != input.end(); line = next_line(line, input.end())) {
    const std::uint64_t count = count_values(input, line, next_line(line, input.end()));
    if (count == 0) continue;
    ++lines;
    values += count;
    last = line;
    if (count == header.columns || odd_lines++ > 0) continue;
    odd = line;
    values_of_odd = count;
  }
  const bool is_complete = values == header.columns * header.rows;
  if (is_complete && (odd == nullptr || lines != header.rows)) return;
  const std::string all = fmt::format("in all there are {} for {} rows of {} columns", values,
                                      header.rows, header.columns);
  const bool has_rows =
      lines == header.rows || odd_lines <= lines / 2;  // else rows go on from line to line
  if (odd == nullptr || !has_rows) refuse(input, last, "with this last line of values, " + all);
  refuse(input, odd,
         fmt::format("{} value{}, where a row has {}; {}", values_of_odd,
                     values_of_odd == 1 ? "" : "s", header.columns, all));
}

}  // namespace hodt
