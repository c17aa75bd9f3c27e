#include "hodt/io/table_layout.h"

#include <algorithm>
#include <charconv>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "hodt/base/error.h"

namespace hodt {

namespace {

/// Names for the same pair of axes; the first pair with both names in the header is taken.
struct PlaneNames {
  std::string_view x;
  std::string_view y;
};

constexpr PlaneNames kPlaneNames[] = {
    {"x", "y"},
    {"easting", "northing"},
    {"east", "north"},
    {"e", "n"},
    {"utm_e", "utm_n"},
    {"x_coord", "y_coord"},
    {"coord_x", "coord_y"},
    {"xcoord", "ycoord"},
    {"point_x", "point_y"},
    {"lon", "lat"},
    {"long", "lat"},
    {"lng", "lat"},
    {"longitude", "latitude"},
    {"rechtswert", "hochwert"},
};

constexpr std::string_view kHeightNames[] = {
    "z",       "elevation", "elev",   "height",  "altitude", "alt",   "ele",
    "z_coord", "coord_z",   "zcoord", "point_z", "h",        "hoehe", "höhe"};

constexpr std::string_view kBlanks = " \t\r";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

/// "Height [m]" -> "height".
std::string plain_name(std::string_view name) {
  std::string plain(trimmed(name.substr(0, name.find_first_of("([", 1))));
  for (char& c : plain) {
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  if (plain.size() > 2 && plain.ends_with("_m")) plain.resize(plain.size() - 2);
  return plain;
}

/// The separator outside quotes; the rarer inside a number or a name, the surer.
char separator_of(std::string_view row) {
  std::string bare;
  bool quoted = false;
  for (const char c : row) {
    if (c == '"') quoted = !quoted;
    if (!quoted) bare.push_back(c);
  }
  bare = trimmed(bare);
  for (const char separator : {';', '\t', ','}) {
    if (bare.find(separator) != std::string::npos) return separator;
  }
  return TableLayout::kWhiteSpace;
}

/// One quoted or plain field from the front of the row; takes it and its separator off.
std::string take_field(std::string_view& row, char separator) {
  std::string field;
  bool quoted = false;
  std::size_t i = 0;
  const auto ends_field = [&](char c) {
    return separator == TableLayout::kWhiteSpace ? c == ' ' || c == '\t' : c == separator;
  };
  for (; i < row.size() && (quoted || !ends_field(row[i])); ++i) {
    if (row[i] == '"') {
      quoted = !quoted;
    } else {
      field.push_back(row[i]);
    }
  }
  row.remove_prefix(std::min(i + 1, row.size()));
  return std::string(trimmed(field));
}

class Header {
 public:
  explicit Header(const std::vector<std::string>& names) {
    for (const std::string& name : names) names_.push_back(plain_name(name));
  }

  std::optional<std::size_t> find(std::string_view name) const {
    const auto found = std::find(names_.begin(), names_.end(), name);
    if (found == names_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - names_.begin());
  }
  std::optional<std::size_t> find_any(std::initializer_list<std::string_view> names) const {
    for (const std::string_view name : names) {
      if (const auto column = find(name)) return column;
    }
    return std::nullopt;
  }
  std::optional<PlaneNames> plane() const {
    for (const PlaneNames& names : kPlaneNames) {
      if (find(names.x) && find(names.y)) return names;
    }
    return std::nullopt;
  }
  std::optional<std::size_t> height() const {
    for (const std::string_view name : kHeightNames) {
      if (const auto column = find(name)) return column;
    }
    return std::nullopt;
  }

 private:
  std::vector<std::string> names_;
};

void sort_sources(TableLayout& layout) {
  std::sort(layout.sources.begin(), layout.sources.begin() + layout.source_count(),
            [](const auto& a, const auto& b) { return a.column < b.column; });
}

/// Sets the sources by name. Returns false if the names say nothing about coordinates.
bool use_names(const Header& header, TableLayout& layout, const std::string& where) {
  const auto plane = header.plane();
  const auto height = header.height();
  if (!plane) {
    if (header.find_any({"x", "y", "z"})) {
      throw InputError(
          fmt::format("{}: the header names only some of x, y and z; name both x and y", where));
    }
    return false;
  }
  layout.has_heights = height.has_value();
  layout.sources[0] = {*header.find(plane->x), 0};
  layout.sources[1] = {*header.find(plane->y), 1};
  if (height) layout.sources[2] = {*height, 2};
  return true;
}

}  // namespace

TableLayout layout_of(std::string_view first_row, const std::string& where) {
  TableLayout layout;
  layout.separator = separator_of(first_row);
  const std::vector<std::string> fields = split_row(first_row, layout.separator);
  layout.columns = fields.size();
  if (layout.columns < 2) {
    throw InputError(
        fmt::format("{}: only one column; a row needs x and y, and z if there are heights", where));
  }
  const Header header(fields);
  const auto is_number = [](const std::string& field) { return spells_number(field); };
  layout.has_header = header.plane() || std::none_of(fields.begin(), fields.end(), is_number);
  if (!layout.has_header || !use_names(header, layout, where)) {
    layout.has_heights = layout.columns > 2;
    layout.sources = {{{0, 0}, {1, 1}, {2, 2}}};
  }
  sort_sources(layout);
  return layout;
}

std::vector<std::string> split_row(std::string_view row, char separator) {
  const bool blanks = separator == TableLayout::kWhiteSpace;
  std::vector<std::string> fields;
  while (!row.empty()) {
    std::string field = take_field(row, separator);
    if (!blanks || !field.empty()) fields.push_back(std::move(field));
  }
  // "1,2,3," has three columns.
  while (fields.size() > 1 && fields.back().empty()) fields.pop_back();
  return fields;
}

bool spells_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double ignored = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), ignored);
  return end != text.data() && end == text.data() + text.size();
}

}  // namespace hodt
