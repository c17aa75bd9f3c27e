#include "hodt/io/edge_pairs_file.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/column_names.h"
#include "hodt/io/field_kind.h"
#include "hodt/io/file_kind.h"
#include "hodt/io/number_text.h"
#include "hodt/io/table_sample.h"
#include "hodt/io/text_encoding.h"
#include "hodt/io/text_lines.h"

namespace hodt {

namespace {

using Fields = std::vector<std::string>;

constexpr std::array<const char*, 2> kEnds = {"u", "v"};

struct Columns {
  std::array<std::size_t, 2> ends = {0, 1};
  std::size_t count = 2;  ///< no row has more
  bool has_header = false;
};

/// Whether the row holds nothing but names.
bool is_header(const Fields& row) {
  return std::none_of(row.begin(), row.end(),
                      [](const std::string& field) { return is_data(kind_of(field)); });
}

/// Reads the columns off the first row. Of two it makes no difference which one is u.
Columns columns_of(const Fields& first) {
  if (!is_header(first)) return {};
  Columns columns{{0, 1}, filled_count(first), true};
  const auto u = column_called(kEnds[0], first), v = column_called(kEnds[1], first);
  if (u && v) {
    columns.ends = {*u, *v};
    for (const std::size_t end : columns.ends)
      if (std::count(first.begin(), first.end(), first[end]) > 1)
        throw InputError(fmt::format("two columns {}; name only the edges' ends u and v",
                                     in_quotes(first[end])));
  } else if (columns.count != 2) {
    throw InputError(fmt::format(
        "no columns u and v, but {}; name those of the edges' ends u and v", listed(first)));
  }
  return columns;
}

Index vertex_of(const std::string& field, const char* name) {
  if (field.empty()) throw InputError(fmt::format("no value for {}; give both ends", name));
  if (!is_whole(field))
    throw InputError(fmt::format("{} for {} is no whole number; vertices are numbers of rows",
                                 in_quotes(field), name));
  if (field.starts_with('-'))
    throw InputError(
        fmt::format("{} for {} is negative; vertices are numbered from 0, the first row of points",
                    in_quotes(field), name));
  Index vertex = 0;
  const char* const digits = field.data() + (field.starts_with('+') ? 1 : 0);
  const auto error = std::from_chars(digits, field.data() + field.size(), vertex).ec;
  if (error != std::errc() || vertex == kNone)
    throw InputError(fmt::format("{} for {} is too large; no vertex has a number above {}",
                                 in_quotes(field), name, kNone - 1));
  return vertex;
}

std::array<Index, 2> edge_of(const Fields& row, const Columns& columns) {
  if (const std::size_t filled = filled_count(row); filled > columns.count) {
    throw InputError(
        columns.has_header
            ? fmt::format("the row has {} values and the header {}; correct one of them", filled,
                          columns.count)
            : fmt::format("the row has {} values, not two; name the columns of the edges' ends u "
                          "and v on a first line",
                          filled));
  }
  std::array<Index, 2> edge{};
  for (std::size_t i = 0; i < edge.size(); ++i) {
    const std::size_t column = columns.ends[i];
    edge[i] = vertex_of(column < row.size() ? row[column] : std::string(), kEnds[i]);
  }
  if (edge[0] == edge[1])
    throw InputError(fmt::format("both ends are vertex {}; an edge needs two", edge[0]));
  return edge;
}

/// Reads a row of the plainest kind, as most are: digits, the separator, digits, and nothing in
/// quotes behind them. Returns false, having proved nothing, for any other.
bool read_plainly(const char* p, char separator, const Columns& columns,
                  std::array<Index, 2>& edge) {
  if (columns.ends != std::array<std::size_t, 2>{0, 1}) return false;
  for (std::size_t i = 0; i < 2; ++i) {
    if (i > 0 && *p++ != separator) return false;
    constexpr std::ptrdiff_t fitting_digits = 9;
    std::uint64_t value = 0;
    const char* const end = number_text::read_digits(p, value);
    if (end == p || end - p > fitting_digits) return false;
    edge[i] = static_cast<Index>(value);
    p = end;
  }
  if (edge[0] == edge[1]) return false;
  if (*skip_returns(p) == '\n') return true;
  if (*p != separator) return false;
  std::size_t fields = 2;
  for (; *p != '\n'; ++p) {
    if (*p == '"') return false;
    fields += *p == separator;
  }
  return fields <= columns.count;
}

class Parser {
 public:
  explicit Parser(const InputText& input) : input_(input), sample_(sample_of(input)) {
    edges_.source = input.name;
  }

  EdgePairs parse() && {
    if (!sample_.rows.empty()) parse_rows();
    if (edges_.edges.empty())
      throw InputError(fmt::format("{} holds no edge; a row is its two ends u and v", input_.name));
    return std::move(edges_);
  }

 private:
  void parse_rows() {
    const SampleRow& first = sample_.rows.front();
    const char* p = first.text.data();
    std::size_t line = 1 + count_line_feeds(input_.begin(), p);
    try {
      columns_ = columns_of(first.fields);
      if (columns_.has_header) {
        p = next_line(p, input_.end());
        ++line;
      }
      for (; p < input_.end(); p = next_line(p, input_.end()), ++line) parse_row(p, line);
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}", place_of(input_.name, line), error.what()));
    }
  }

  void parse_row(const char* p, std::size_t line) {
    std::array<Index, 2> edge{};
    if (!read_plainly(p, sample_.separator, columns_, edge)) {
      if (is_skipped(p)) return;
      const Fields row = split_row(line_at(p, input_.end()), sample_.separator);
      if (filled_count(row) == 0) return;
      edge = edge_of(row, columns_);
    }
    edges_.edges.push_back(edge);
    edges_.lines.push_back(line);
  }

  const InputText& input_;
  const TableSample sample_;
  Columns columns_;
  EdgePairs edges_;
};

}  // namespace

std::string EdgePairs::place(std::size_t edge) const {
  return place_of(source, lines[edge]);
}

EdgePairs parse_edge_pairs(InputText input) {
  require_table(input);
  mend_line_ends(input);
  return Parser(input).parse();
}

EdgePairs read_edge_pairs(const std::filesystem::path& path) {
  return parse_edge_pairs(read_input(path));
}

}  // namespace hodt
