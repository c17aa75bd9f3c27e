#include "hodt/io/vtu.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "hodt/io/bytes.h"
#include "hodt/io/parallel_text.h"
#include "hodt/io/tin_parts.h"

namespace hodt {

namespace {

constexpr std::uint8_t kTriangle = 5;

/// The XML, and the size of what it says will follow.
class Announcement {
 public:
  /// An array of `count` numbers.
  template <class T>
  std::string array(std::string_view type, std::string_view name, std::size_t count,
                    std::string_view attributes = {}) {
    std::string text =
        fmt::format("<DataArray type=\"{}\" Name=\"{}\"{} format=\"appended\" offset=\"{}\"/>\n",
                    type, name, attributes, offset_);
    offset_ += sizeof(std::uint64_t) + count * sizeof(T);
    return text;
  }

 private:
  std::size_t offset_ = 0;
};

std::string crs_field(std::string_view crs) {
  if (crs.empty()) return {};
  std::string text = fmt::format(
      "<FieldData>\n<DataArray type=\"UInt8\" Name=\"crs\" NumberOfTuples=\"{}\" "
      "format=\"ascii\">\n",
      crs.size());
  for (const char c : crs) text += fmt::format("{} ", static_cast<unsigned char>(c));
  return text + "\n</DataArray>\n</FieldData>\n";
}

std::string header_of(const Tin& tin) {
  const std::size_t points = tin.points.size(), triangles = tin.triangles.size();
  Announcement next;
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
      "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n";
  text += crs_field(tin.crs);
  text += fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", points, triangles);
  // One after the other, as each tells the next its offset.
  text += "<Points>\n";
  text += next.array<double>("Float64", "Points", 3 * points, " NumberOfComponents=\"3\"");
  text += "</Points>\n<Cells>\n";
  text += next.array<std::int64_t>("Int64", "connectivity", 3 * triangles);
  text += next.array<std::int64_t>("Int64", "offsets", triangles);
  text += next.array<std::uint8_t>("UInt8", "types", triangles);
  text += "</Cells>\n<PointData>\n";
  if (tin.points.has_heights()) text += next.array<double>("Float64", "z", points);
  text += "</PointData>\n<CellData>\n";
  if (!tin.order.empty()) {
    text += next.array<std::uint32_t>("UInt32", "order", triangles);
    text += next.array<std::uint8_t>("UInt8", "changed", triangles);
  }
  text += "</CellData>\n";
  return text + "</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
}

/// An array after its length in bytes; number(i, k) is number k of record i.
template <std::size_t Numbers, class Number>
void write_array(OutputFile& file, std::size_t count, const Number& number) {
  constexpr std::size_t longest = Numbers * sizeof(number(std::size_t{}, std::size_t{}));
  char length[sizeof(std::uint64_t)];
  put_little(length, std::uint64_t{count * longest});
  file.write({length, sizeof length});
  write_records(file, count, longest, [&](std::size_t i, char* to) {
    for (std::size_t k = 0; k < Numbers; ++k) to = put_little(to, number(i, k));
    return to;
  });
}

}  // namespace

void write_vtu(const Tin& tin, OutputFile& file) {
  const PointSet& points = tin.points;
  const std::size_t triangles = tin.triangles.size();
  file.write(header_of(tin));
  write_array<3>(file, points.size(), [&](std::size_t i, std::size_t k) {
    return std::array{points.xy[i].x, points.xy[i].y, height_or_zero(points, i)}[k];
  });
  write_array<3>(file, triangles, [&](std::size_t t, std::size_t k) {
    return static_cast<std::int64_t>(tin.triangles[t][k]);
  });
  write_array<1>(file, triangles,
                 [](std::size_t t, std::size_t) { return static_cast<std::int64_t>(3 * (t + 1)); });
  write_array<1>(file, triangles, [](std::size_t, std::size_t) { return kTriangle; });
  if (points.has_heights())
    write_array<1>(file, points.size(), [&](std::size_t i, std::size_t) { return points.z[i]; });
  if (!tin.order.empty()) {
    write_array<1>(file, triangles, [&](std::size_t t, std::size_t) { return tin.order[t]; });
    write_array<1>(file, triangles, [&](std::size_t t, std::size_t) {
      return static_cast<std::uint8_t>(tin.is_changed(t));
    });
  }
  file.write("\n</AppendedData>\n</VTKFile>\n");
}

}  // namespace hodt
