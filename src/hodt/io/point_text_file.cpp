#include "hodt/io/point_text_file.h"

#include <string>
#include <string_view>

#include "hodt/base/buffer.h"
#include "hodt/io/file_name.h"
#include "hodt/io/gzip.h"
#include "hodt/io/number_text.h"
#include "hodt/io/parallel_text.h"

namespace hodt {

namespace {

struct TableStyle {
  char separator;
  bool header;
};

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

void write_table(const PointSet& points, const TableStyle& style, OutputFile& file) {
  if (!is_packed_name(file.path())) {
    format_table(points, style, [&](std::string_view bytes) { file.write(bytes); });
    return;
  }
  std::string text;
  format_table(points, style, [&](std::string_view bytes) { text += bytes; });
  const Buffer<char> packed = gzip(text);
  file.write({packed.data(), packed.size()});
}

}  // namespace

void write_csv(const PointSet& points, OutputFile& file) {
  write_table(points, {',', true}, file);
}

void write_xyz(const PointSet& points, OutputFile& file) {
  write_table(points, {' ', false}, file);
}

}  // namespace hodt
