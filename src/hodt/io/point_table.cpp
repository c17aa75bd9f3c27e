#include "hodt/io/point_table.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/base/ids.h"
#include "hodt/base/parallel.h"
#include "hodt/io/file_kind.h"
#include "hodt/io/point_doubts.h"
#include "hodt/io/row_parser.h"
#include "hodt/io/table_sample.h"
#include "hodt/io/text_encoding.h"
#include "hodt/io/text_lines.h"

namespace hodt {

namespace {

/// A piece of the table that begins and ends at line ends.
struct Chunk {
  const char* begin = nullptr;
  const char* end = nullptr;
  std::size_t first_line = 0;  ///< lines before it, in its table
  std::size_t rows = 0;
  const char* bad_row = nullptr;
};

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
template <char Decimal>
void parse_chunk(const RowShape& shape, Chunk& chunk, PointSet& points) {
  const RowParser<Decimal> parser(shape);
  const bool has_heights = points.has_heights();
  std::size_t slot = chunk.first_line;
  for (const char* p = chunk.begin; p < chunk.end; p = next_line(p, chunk.end)) {
    if (is_skipped(p)) continue;
    double values[3];
    const char* const stop = parser.parse(p, values);
    if (!stop) {
      if (explain_row(line_at(p, chunk.end), shape, Decimal).empty()) continue;
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

/// Parses all chunks; returns the first bad row, or nullptr.
template <char Decimal>
const char* parse_chunks(const RowShape& shape, std::vector<Chunk>& chunks, PointSet& points) {
  parallel_for(0, chunks.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t c = first; c < last; ++c) {
      chunks[c].bad_row = nullptr;
      parse_chunk<Decimal>(shape, chunks[c], points);
    }
  });
  for (const Chunk& chunk : chunks) {
    if (chunk.bad_row) return chunk.bad_row;
  }
  return nullptr;
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

[[noreturn]] void throw_bad_row(const InputText& input, const RowShape& shape, char decimal,
                                const char* row) {
  throw InputError(fmt::format("{}: {}", place_of(input, row),
                               explain_row(line_at(row, input.end()), shape, decimal)));
}

/// The points of all rows. Which sign stands before decimals only the rows can tell: a table whose
/// numbers do not all have points is tried with commas.
PointSet parse_rows(const InputText& input, const TableLayout& layout) {
  std::vector<Chunk> chunks = cut(layout.body, input.end());
  const std::size_t lines = number_lines(chunks);
  if (lines >= kNone) {
    throw InputError(fmt::format("{} has more rows than hodt can number ({})", input.name, kNone));
  }
  PointSet points;
  points.xy.resize(lines);
  const RowShape& shape = layout.shape;
  if (shape.has_heights) points.z.resize(lines);
  if (const char* const bad = parse_chunks<'.'>(shape, chunks, points)) {
    // Under the separator itself a comma in quotes can also divide thousands.
    if (shape.separator == ',' || !has_decimal_comma(line_at(bad, input.end()), shape))
      throw_bad_row(input, shape, '.', bad);
    if (layout.commas_may_divide_thousands) throw_bad_row(input, shape, '.', bad);
    if (const char* const worse = parse_chunks<','>(shape, chunks, points))
      throw_bad_row(input, shape, ',', worse);
  }
  compact(chunks, points);
  return points;
}

void check_announcement(const InputText& input, const TableLayout& layout, std::size_t rows) {
  if (!layout.announced_rows || *layout.announced_rows == rows) return;
  throw InputError(
      fmt::format("{}: its first line says that there are {} points, but there are {}; correct or "
                  "remove that line if the file is complete",
                  input.name, *layout.announced_rows, rows));
}

/// Throws where the values speak against what was taken for x without a name that says so.
void check_places(const InputText& input, const TableLayout& layout, const PointSet& points) {
  if (layout.known == ColumnsKnown::told) return;
  const bool counts = x_counts(points);
  const bool many_columns = layout.shape.columns > 3;
  const bool doubtful =
      many_columns ? counts || x_could_number_points(points) : counts && layout.unknown_names;
  if (!doubtful) return;
  throw InputError(
      fmt::format("{}: the first column {}, and no name says what it is; {}", input.name,
                  counts ? "counts the rows" : "could be the numbers of the points", kSayColumns));
}

std::vector<std::string> warnings_of(const TableLayout& layout, const PointSet& points) {
  std::vector<std::string> warnings = layout.warnings;
  if (x_counts(points)) {
    warnings.push_back(fmt::format(
        "x counts {}, {}, {}, ...: if column {} holds the numbers of the points, {}",
        points.xy[0].x, points.xy[1].x, points.xy[2].x, layout.taken.x.number, kSayColumns));
  }
  for (std::string& warning : warn_of_no_data(points)) warnings.push_back(std::move(warning));
  return warnings;
}

}  // namespace

PointTable parse_point_table(InputText input, const ColumnChoice& choice) {
  require_table(input);
  mend_line_ends(input);
  const TableSample sample = sample_of(input);
  if (sample.rows.empty()) throw_no_row(input);
  const TableLayout layout = layout_of(input, sample, choice);
  PointSet points = parse_rows(input, layout);
  check_announcement(input, layout, points.size());
  if (points.size() == 0) throw_no_row(input);
  check_places(input, layout, points);
  std::vector<std::string> warnings = warnings_of(layout, points);
  return {std::move(points), layout.taken, std::move(warnings)};
}

}  // namespace hodt
