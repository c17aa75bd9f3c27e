#include "hodt/io/point_file.h"

#include "hodt/io/atomic_write.h"
#include "hodt/io/formats.h"
#include "hodt/io/input_text.h"

namespace hodt {

namespace {

const Format& csv(Use use) {
  return format_for("any.csv", use);
}

/// CSV goes to standard output.
const Format& format_to_write(const std::filesystem::path& path) {
  return path == kStandardInput ? csv(Use::write_points) : format_for(path, Use::write_points);
}

}  // namespace

PointTable read_point_table(const std::filesystem::path& path, const PointChoice& choice) {
  // Whatever the name of a table is: what it holds says more.
  const Format* format = find_format(path, Use::read_points);
  return (format ? *format : csv(Use::read_points)).read_points(path, choice);
}

PointSet read_points(const std::filesystem::path& path, const PointChoice& choice) {
  return read_point_table(path, choice).points;
}

void write_points(const PointSet& points, const std::filesystem::path& path) {
  const Format& format = format_to_write(path);
  atomic_write(path, [&](OutputFile& file) { format.write_points(points, file); });
}

void check_points_extension(const std::filesystem::path& path) {
  format_to_write(path);
}

}  // namespace hodt
