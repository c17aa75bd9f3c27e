#include "hodt/io/two_dm.h"

#include <string_view>

#include "hodt/io/number_text.h"
#include "hodt/io/parallel_text.h"
#include "hodt/io/tin_parts.h"

namespace hodt {

namespace {

template <class Number>
char* put_number(char* to, Number number) {
  *to++ = ' ';
  return format_number(to, number);
}

}  // namespace

void write_2dm(const Tin& tin, OutputFile& file) {
  file.write("MESH2D\n");
  constexpr std::size_t longest = 8 + 4 * (kLongestNumber + 1);
  write_records(file, tin.triangles.size(), longest, [&](std::size_t t, char* to) {
    to = put_number(put_text(to, "E3T"), static_cast<Index>(t + 1));
    for (const Index corner : tin.triangles[t]) to = put_number(to, corner + 1);
    return put_text(to, " 1\n");  // its material
  });
  const PointSet& points = tin.points;
  write_records(file, points.size(), longest, [&](std::size_t i, char* to) {
    to = put_number(put_text(to, "ND"), static_cast<Index>(i + 1));
    for (const double value : {points.xy[i].x, points.xy[i].y, height_or_zero(points, i)})
      to = put_number(to, value);
    *to++ = '\n';
    return to;
  });
}

}  // namespace hodt
