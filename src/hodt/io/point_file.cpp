#include "hodt/io/point_file.h"

#include <string>

#include <fmt/format.h>

#include "hodt/base/buffer.h"
#include "hodt/base/error.h"
#include "hodt/io/atomic_write.h"
#include "hodt/io/file_name.h"
#include "hodt/io/gzip.h"
#include "hodt/io/input_text.h"
#include "hodt/io/number_text.h"
#include "hodt/io/parallel_text.h"

namespace hodt {

namespace {

struct TableStyle {
  std::string_view extension;
  char separator;
  bool header;
};

constexpr TableStyle kTableStyles[] = {{".csv", ',', true}, {".xyz", ' ', false}};

const TableStyle& style_of(const std::filesystem::path& path) {
  if (path == kStandardInput) return kTableStyles[0];
  const std::string extension = format_extension(path);
  for (const TableStyle& style : kTableStyles) {
    if (style.extension == extension) return style;
  }
  throw ParameterError(
      fmt::format("cannot write points to {}: unknown extension '{}'; known are "
                  ".csv and .xyz, each also with .gz",
                  path.string(), path.extension().string()));
}

template <class Sink>
void format_table(const PointSet& points, const TableStyle& style, const Sink& sink) {
  const bool has_heights = points.has_heights();
  if (style.header) sink(std::string_view(has_heights ? "x,y,z\n" : "x,y\n"));
  const auto format_row = [&](std::size_t i, char* to) {
    to = format_number(to, points.xy[i].x);
    *to++ = style.separator;
    to = format_number(to, points.xy[i].y);
    if (has_heights) {
      *to++ = style.separator;
      to = format_number(to, points.z[i]);
    }
    *to++ = '\n';
    return to;
  };
  format_records(points.size(), 3 * (kLongestNumber + 1), format_row, sink);
}

}  // namespace

PointTable read_point_table(const std::filesystem::path& path, const ColumnChoice& choice) {
  return parse_point_table(read_input(path), choice);
}

PointSet read_points(const std::filesystem::path& path, const ColumnChoice& choice) {
  return read_point_table(path, choice).points;
}

void write_points(const PointSet& points, const std::filesystem::path& path) {
  const TableStyle& style = style_of(path);
  atomic_write(path, [&](OutputFile& file) {
    if (!is_packed_name(path)) {
      format_table(points, style, [&](std::string_view bytes) { file.write(bytes); });
      return;
    }
    std::string text;
    format_table(points, style, [&](std::string_view bytes) { text += bytes; });
    const Buffer<char> packed = gzip(text);
    file.write({packed.data(), packed.size()});
  });
}

void check_points_extension(const std::filesystem::path& path) {
  style_of(path);
}

}  // namespace hodt
