#include "hodt/io/point_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/base/ids.h"
#include "hodt/base/parallel.h"
#include "hodt/io/number_text.h"
#include "hodt/io/table_layout.h"

namespace hodt {

namespace {

constexpr char kWhiteSpace = TableLayout::kWhiteSpace;
constexpr std::array<const char*, 3> kAxisNames = {"x", "y", "z"};

const char* next_line(const char* p, const char* end) {
  if (p >= end) return end;
  const void* feed = std::memchr(p, '\n', static_cast<std::size_t>(end - p));
  return feed ? static_cast<const char*>(feed) + 1 : end;
}

std::string_view line_at(const char* p, const char* end) {
  std::string_view line(p, static_cast<std::size_t>(next_line(p, end) - p));
  while (line.ends_with('\n') || line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

const char* skip_blanks(const char* p) {
  while (*p == ' ' || *p == '\t') ++p;
  return p;
}

const char* skip_returns(const char* p) {
  while (*p == '\r') ++p;
  return p;
}

/// Whether the line at p holds no data: blank, or a comment.
bool is_skipped(const char* p) {
  p = skip_returns(skip_blanks(p));
  return *p == '\n' || *p == '#';
}

/// Reads rows of one layout, fast; whoever finds a row bad asks explain() for the reason.
class RowParser {
 public:
  explicit RowParser(const TableLayout& layout) : layout_(layout) {}

  /// Reads the row at p, which holds data, into values by axis. Returns the end of what it read,
  /// somewhere on the row, or nullptr if the row is bad.
  const char* parse(const char* p, double* values) const {
    std::size_t column = 0;
    bool more = true;  // p stands at the start of a field
    p = skip_indent(p);
    for (std::size_t s = 0; s < layout_.source_count(); ++s) {
      const TableLayout::Source source = layout_.sources[s];
      for (; more && column < source.column; ++column) p = skip_field(p, more);
      if (!more) return nullptr;
      p = parse_field(p, values[source.axis], more);
      if (!p) return nullptr;
      ++column;
    }
    return more && has_surplus(p) ? nullptr : p;
  }

  /// What is wrong with a row that parse() refused, with a remedy; empty if the row holds nothing
  /// but separators.
  std::string explain(std::string_view row) const {
    const std::vector<std::string> fields = split_row(row, layout_.separator);
    if (fields.empty() || (fields.size() == 1 && fields[0].empty())) return {};
    for (std::size_t s = 0; s < layout_.source_count(); ++s) {
      const TableLayout::Source source = layout_.sources[s];
      const std::string problem = source.column < fields.size()
                                      ? explain_field(fields[source.column], source.axis)
                                      : missing(source, fields.size());
      if (!problem.empty()) return problem;
    }
    if (!layout_.has_heights && fields.size() > 2) {
      return "a third value, but the first row has two; give every row a height, or none";
    }
    return "misplaced quotes; remove them";
  }

 private:
  bool blank_separated() const { return layout_.separator == kWhiteSpace; }
  /// Blanks that belong to no field; a tab can be the separator itself.
  const char* skip_indent(const char* p) const {
    if (layout_.separator != '\t') return skip_blanks(p);
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
    return *p == layout_.separator ? p + 1 : nullptr;
  }

  const char* parse_field(const char* p, double& value, bool& more) const {
    p = skip_indent(p);
    const bool quoted = *p == '"';
    if (quoted) p = skip_blanks(p + 1);
    p = parse_number(p, value);
    if (!p) return nullptr;
    if (quoted) {
      p = skip_blanks(p);
      if (*p++ != '"') return nullptr;
    }
    return leave_field(p, more);
  }

  const char* skip_field(const char* p, bool& more) const {
    bool quoted = false;
    for (; *p != '\n'; ++p) {
      if (*p == '"') quoted = !quoted;
      if (quoted) continue;
      if (blank_separated() ? (*p == ' ' || *p == '\t') : *p == layout_.separator) break;
    }
    if (*p == '\n') {
      more = false;
      return p;
    }
    return leave_field(p, more);
  }

  /// Heights in a row of a table that has none.
  bool has_surplus(const char* p) const {
    if (layout_.has_heights || layout_.columns > 2) return false;
    p = skip_indent(p);
    return *p != '\n' && *p != '\r' && *p != layout_.separator;
  }

  static std::string missing(TableLayout::Source source, std::size_t columns) {
    return fmt::format("no value for {}: the row has {} column{}, {} is column {}",
                       kAxisNames[source.axis], columns, columns == 1 ? "" : "s",
                       kAxisNames[source.axis], source.column + 1);
  }

  std::string explain_field(const std::string& field, std::size_t axis) const {
    const char* const name = kAxisNames[axis];
    if (field.empty()) {
      return fmt::format("no value for {}; fill it in or remove the row", name);
    }
    const std::string padded = field + std::string("\n") + std::string(8, '\0');
    double value = 0;
    const char* const end = parse_number(padded.c_str(), value);
    if (end && *end == '\n') return {};
    if (spells_number(field)) {
      return fmt::format("{} is {}, not a finite number; correct or remove the row", name,
                         quoted(field));
    }
    const bool comma = layout_.separator != ',' && field.find(',') != std::string::npos;
    return fmt::format("{} for {} is not a number{}", quoted(field), name,
                       comma ? "; write decimals with a point" : "; correct or remove the row");
  }

  /// The text for a message: short and printable.
  static std::string quoted(std::string_view text) {
    constexpr std::size_t longest = 24;
    std::string shown;
    for (const char c : text.substr(0, longest)) {
      const bool control = static_cast<unsigned char>(c) < 32 || c == 127;
      shown.push_back(control ? '?' : c);
    }
    // Do not cut a UTF-8 character in two.
    if (text.size() > longest) {
      while (!shown.empty() && (shown.back() & 0x80)) shown.pop_back();
      shown += "...";
    }
    return "'" + shown + "'";
  }

  TableLayout layout_;
};

/// A piece of the table that begins and ends at line ends.
struct Chunk {
  const char* begin = nullptr;
  const char* end = nullptr;
  std::size_t first_line = 0;  ///< lines before it, in its table
  std::size_t rows = 0;
  const char* bad_row = nullptr;
};

std::size_t count_line_feeds(const char* p, const char* end) {
  std::size_t count = 0;
  // Byte-wide counters, so that the compiler can compare many bytes at once.
  constexpr std::ptrdiff_t width = 64;
  while (end - p >= width) {
    unsigned char counts[width] = {};
    for (int i = 0; i < 255 && end - p >= width; ++i, p += width) {
      for (int j = 0; j < width; ++j) counts[j] += p[j] == '\n';
    }
    for (const unsigned char c : counts) count += c;
  }
  return count + static_cast<std::size_t>(std::count(p, end, '\n'));
}

std::vector<Chunk> cut(const char* begin, const char* end) {
  constexpr std::ptrdiff_t size = std::ptrdiff_t{1} << 18;
  std::vector<Chunk> chunks;
  while (begin < end) {
    const char* const stop = end - begin > size ? next_line(begin + size, end) : end;
    chunks.push_back({begin, stop, 0, 0, nullptr});
    begin = stop;
  }
  return chunks;
}

/// Fills in first_line; returns the number of lines.
std::size_t number_lines(std::vector<Chunk>& chunks) {
  parallel_for(0, chunks.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t c = first; c < last; ++c) {
      chunks[c].first_line = count_line_feeds(chunks[c].begin, chunks[c].end);
    }
  });
  std::size_t lines = 0;
  for (Chunk& chunk : chunks) lines += std::exchange(chunk.first_line, lines);
  return lines + 1;  // the last line may lack its line feed
}

/// Parses a chunk's rows to consecutive slots from first_line on; stops at a bad row.
void parse_chunk(const RowParser& parser, Chunk& chunk, PointSet& points) {
  const bool has_heights = points.has_heights();
  std::size_t slot = chunk.first_line;
  for (const char* p = chunk.begin; p < chunk.end; p = next_line(p, chunk.end)) {
    if (is_skipped(p)) continue;
    double values[3];
    const char* const stop = parser.parse(p, values);
    if (!stop) {
      if (parser.explain(line_at(p, chunk.end)).empty()) continue;
      chunk.bad_row = p;
      return;
    }
    p = stop;
    points.xy[slot] = {values[0], values[1]};
    if (has_heights) points.z[slot] = values[2];
    ++slot;
  }
  chunk.rows = slot - chunk.first_line;
}

/// Closes the gaps that skipped lines left.
void compact(const std::vector<Chunk>& chunks, PointSet& points) {
  std::size_t rows = 0;
  for (const Chunk& chunk : chunks) {
    const auto move = [&](auto& values) {
      const auto from = values.begin() + static_cast<std::ptrdiff_t>(chunk.first_line);
      std::copy(from, from + static_cast<std::ptrdiff_t>(chunk.rows),
                values.begin() + static_cast<std::ptrdiff_t>(rows));
    };
    if (rows != chunk.first_line) {
      move(points.xy);
      if (points.has_heights()) move(points.z);
    }
    rows += chunk.rows;
  }
  points.xy.resize(rows);
  if (points.has_heights()) points.z.resize(rows);
}

std::string place(const InputText& input, const char* line) {
  const auto number = 1 + count_line_feeds(input.begin(), line);
  return fmt::format("{}, line {}", input.name, number);
}

[[noreturn]] void throw_bad_row(const InputText& input, const RowParser& parser, const char* row) {
  throw InputError(
      fmt::format("{}: {}", place(input, row), parser.explain(line_at(row, input.end()))));
}

[[noreturn]] void throw_bare_returns(const InputText& input) {
  throw InputError(fmt::format(
      "{}: lines end in carriage returns without line feeds; save it with line feeds", input.name));
}

[[noreturn]] void throw_no_row(const InputText& input) {
  throw InputError(fmt::format("{} holds no data row; a row is x, y and, if known, z", input.name));
}

}  // namespace

PointSet parse_point_table(const InputText& input) {
  require_text(input);
  const char* const end = input.end();
  const char* begin = input.begin();
  while (begin < end && is_skipped(begin)) begin = next_line(begin, end);
  if (begin >= end) throw_no_row(input);
  const std::string_view first_row = line_at(begin, end);
  if (first_row.find('\r') != std::string_view::npos) throw_bare_returns(input);
  const TableLayout layout = layout_of(first_row, place(input, begin));
  if (layout.has_header) begin = next_line(begin, end);

  std::vector<Chunk> chunks = cut(begin, end);
  const std::size_t lines = number_lines(chunks);
  if (lines >= kNone) {
    throw InputError(fmt::format("{} has more rows than hodt can number ({})", input.name, kNone));
  }
  PointSet points;
  points.xy.resize(lines);
  if (layout.has_heights) points.z.resize(lines);
  const RowParser parser(layout);
  parallel_for(0, chunks.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t c = first; c < last; ++c) parse_chunk(parser, chunks[c], points);
  });
  for (const Chunk& chunk : chunks) {
    if (chunk.bad_row) throw_bad_row(input, parser, chunk.bad_row);
  }
  compact(chunks, points);
  if (points.size() == 0) throw_no_row(input);
  return points;
}

}  // namespace hodt
