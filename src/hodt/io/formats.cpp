#include "hodt/io/formats.h"

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/file_name.h"
#include "hodt/io/geojson.h"
#include "hodt/io/geojson_reader.h"
#include "hodt/io/geopackage.h"
#include "hodt/io/glb.h"
#include "hodt/io/input_text.h"
#include "hodt/io/landxml.h"
#include "hodt/io/obj.h"
#include "hodt/io/ply.h"
#include "hodt/io/point_text_file.h"
#include "hodt/io/stl.h"
#include "hodt/io/two_dm.h"
#include "hodt/io/ugrid.h"
#include "hodt/io/vtu.h"

namespace hodt {

namespace {

PointTable read_table(const std::filesystem::path& path, const PointChoice& choice) {
  return parse_point_table(read_input(path), choice.columns);
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
    // name, extensions, packed, points, features, mesh, write points, write mesh, write features,
    // what a mesh keeps
    {"CSV", ".csv", true, read_table, nullptr, nullptr, write_csv, nullptr, nullptr, kNoMesh},
    {"XYZ", ".xyz", true, read_table, nullptr, nullptr, write_xyz, nullptr, nullptr, kNoMesh},
    {"GeoJSON", ".geojson .json", true, nullptr, read_geojson_file, nullptr, nullptr, nullptr,
     write_geojson_layer, kNoMesh},
    {"GeoPackage", ".gpkg", false, nullptr, nullptr, nullptr, nullptr, nullptr, write_geopackage,
     kNoMesh},
    {"OBJ",
     ".obj",
     true,
     nullptr,
     nullptr,
     read_mesh<parse_obj>,
     nullptr,
     write_obj,
     nullptr,
     {true, true, false}},
    {"PLY",
     ".ply",
     true,
     nullptr,
     nullptr,
     read_mesh<parse_ply>,
     nullptr,
     write_ply,
     nullptr,
     {true, true, false}},
    {"VTU",
     ".vtu",
     false,
     nullptr,
     nullptr,
     nullptr,
     nullptr,
     write_vtu,
     nullptr,
     {true, true, true}},
    {"UGRID netCDF",
     ".nc",
     false,
     nullptr,
     nullptr,
     nullptr,
     nullptr,
     write_ugrid,
     nullptr,
     {true, true, true}},
    {"2DM",
     ".2dm",
     false,
     nullptr,
     nullptr,
     nullptr,
     nullptr,
     write_2dm,
     nullptr,
     {true, false, false}},
    {"LandXML 1.2",
     ".xml .landxml",
     false,
     nullptr,
     nullptr,
     nullptr,
     nullptr,
     write_landxml,
     nullptr,
     {true, true, false}},
    {"GLB",
     ".glb",
     false,
     nullptr,
     nullptr,
     nullptr,
     nullptr,
     write_glb,
     nullptr,
     {false, true, false}},
    {"STL",
     ".stl",
     false,
     nullptr,
     nullptr,
     nullptr,
     nullptr,
     write_stl,
     nullptr,
     {false, false, false}},
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

/// Meshes and features are never written packed.
bool may_be_packed(Use use) {
  return use != Use::write_tin && use != Use::write_features;
}

std::string extension_of(const std::filesystem::path& path, Use use) {
  return may_be_packed(use) ? format_extension(path) : lower_extension(path);
}

std::string known_extensions(Use use) {
  std::string known;
  bool packed = may_be_packed(use);
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
    case Use::write_features:
      return "write features to";
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
    case Use::write_features:
      return format.write_features != nullptr;
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
