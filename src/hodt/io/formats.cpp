#include "hodt/io/formats.h"

#include <utility>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/file_name.h"
#include "hodt/io/geojson_reader.h"
#include "hodt/io/input_text.h"
#include "hodt/io/las/las_reader.h"
#include "hodt/io/las_table.h"
#include "hodt/io/obj.h"
#include "hodt/io/ply.h"
#include "hodt/io/point_text_file.h"

namespace hodt {

namespace {

/// What a file of points is, its bytes say.
PointTable read_table(const std::filesystem::path& path, const PointChoice& choice) {
  InputText input = read_input(path);
  if (is_las(input.view())) return read_las_table(input, choice);
  if (choice.las)
    throw ParameterError(fmt::format(
        "--las-class and --las-return are for LAS and LAZ files, and {} is none", input.name));
  return parse_point_table(std::move(input), choice.columns);
}

void read_geojson_file(const std::filesystem::path& path, const FeatureTaker& taker) {
  read_geojson(read_input(path), taker);
}

template <Tin (*parse)(const InputText&)>
Tin read_mesh(const std::filesystem::path& path) {
  return parse(read_input(path));
}

constexpr Keeps kNoMesh = {false, false, false};

constexpr Format kFormats[] = {
    // name, extensions, packed, points, features, mesh, write points, write mesh, what that keeps
    {"CSV", ".csv", true, read_table, nullptr, nullptr, write_csv, nullptr, kNoMesh},
    {"XYZ", ".xyz", true, read_table, nullptr, nullptr, write_xyz, nullptr, kNoMesh},
    {"LAS", ".las .laz", true, read_table, nullptr, nullptr, nullptr, nullptr, kNoMesh},
    {"GeoJSON", ".geojson .json", true, nullptr, read_geojson_file, nullptr, nullptr, nullptr,
     kNoMesh},
    {"OBJ",
     ".obj",
     true,
     nullptr,
     nullptr,
     read_mesh<parse_obj>,
     nullptr,
     write_obj,
     {true, true, false}},
    {"PLY",
     ".ply",
     true,
     nullptr,
     nullptr,
     read_mesh<parse_ply>,
     nullptr,
     write_ply,
     {true, true, false}},
};

bool has_extension(const Format& format, std::string_view extension) {
  std::string_view rest = format.extensions;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    if (rest.substr(0, end) == extension) return true;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return false;
}

std::string extension_of(const std::filesystem::path& path, Use use) {
  return use == Use::write_tin ? lower_extension(path) : format_extension(path);
}

std::string known_extensions(Use use) {
  std::string known;
  bool packed = use != Use::write_tin;
  for (const Format& format : kFormats) {
    if (!can(format, use)) continue;
    for (const char c : format.extensions) {
      if (c == ' ') known += ',';
      known += c;
    }
    known += ", ";
    packed = packed && format.can_be_packed;
  }
  known.resize(known.size() - 2);
  return packed ? known + ", each also with .gz" : known;
}

std::string_view doing(Use use) {
  switch (use) {
    case Use::read_points:
      return "read points from";
    case Use::read_features:
      return "read lines and places from";
    case Use::read_tin:
      return "read a mesh from";
    case Use::write_points:
      return "write points to";
    case Use::write_tin:
      return "write a mesh to";
  }
  return {};
}

}  // namespace

std::span<const Format> formats() {
  return kFormats;
}

bool can(const Format& format, Use use) {
  switch (use) {
    case Use::read_points:
      return format.read_points != nullptr;
    case Use::read_features:
      return format.read_features != nullptr;
    case Use::read_tin:
      return format.read_tin != nullptr;
    case Use::write_points:
      return format.write_points != nullptr;
    case Use::write_tin:
      return format.write_tin != nullptr;
  }
  return false;
}

const Format* find_format(const std::filesystem::path& path, Use use) {
  const std::string extension = extension_of(path, use);
  for (const Format& format : kFormats)
    if (can(format, use) && has_extension(format, extension)) return &format;
  return nullptr;
}

const Format& format_for(const std::filesystem::path& path, Use use) {
  if (const Format* format = find_format(path, use)) return *format;
  const std::string extension = extension_of(path, use);
  throw ParameterError(fmt::format(
      "cannot {} {}: {}; known are {}", doing(use), display_name(path),
      extension.empty() ? "the name has no extension" : "unknown extension '" + extension + "'",
      known_extensions(use)));
}

}  // namespace hodt
