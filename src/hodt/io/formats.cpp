#include "hodt/io/formats.h"

#include <utility>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/file_name.h"
#include "hodt/io/gdal/writers.h"
#include "hodt/io/geojson.h"
#include "hodt/io/geojson_reader.h"
#include "hodt/io/geopackage.h"
#include "hodt/io/glb.h"
#include "hodt/io/input_text.h"
#include "hodt/io/landxml.h"
#include "hodt/io/las/las_reader.h"
#include "hodt/io/las_table.h"
#include "hodt/io/obj.h"
#include "hodt/io/ply.h"
#include "hodt/io/point_text_file.h"
#include "hodt/io/stl.h"
#include "hodt/io/tin_layer.h"
#include "hodt/io/two_dm.h"
#include "hodt/io/ugrid.h"
#include "hodt/io/vtu.h"

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

/// A polygon a triangle.
template <void (*write)(const FeatureLayer&, OutputFile&)>
void write_triangles(const Tin& tin, OutputFile& file) {
  write(triangle_layer(tin), file);
}

// clang-format off
constexpr Format kFormats[] = {
    {.name = "CSV", .extensions = ".csv", .can_be_packed = true,
     .read_points = read_table, .write_points = write_csv},
    {.name = "XYZ", .extensions = ".xyz", .can_be_packed = true,
     .read_points = read_table, .write_points = write_xyz},
    {.name = "LAS", .extensions = ".las .laz", .can_be_packed = true,
     .read_points = read_table},
    {.name = "OBJ", .extensions = ".obj", .can_be_packed = true,
     .read_tin = read_mesh<parse_obj>, .write_tin = write_obj,
     .keeps = {.heights = true, .crs = true}},
    {.name = "PLY", .extensions = ".ply", .can_be_packed = true,
     .read_tin = read_mesh<parse_ply>, .write_tin = write_ply,
     .keeps = {.heights = true, .crs = true, .order = true}},
    {.name = "VTU", .extensions = ".vtu",
     .write_tin = write_vtu, .keeps = {.heights = true, .crs = true, .order = true}},
    {.name = "UGRID netCDF", .extensions = ".nc",
     .write_tin = write_ugrid, .keeps = {.heights = true, .crs = true, .order = true}},
    {.name = "2DM", .extensions = ".2dm",
     .write_tin = write_2dm, .keeps = {.heights = true}},
    {.name = "LandXML 1.2", .extensions = ".xml .landxml",
     .write_tin = write_landxml, .keeps = {.heights = true, .crs = true}},
    {.name = "GLB", .extensions = ".glb",
     .write_tin = write_glb, .keeps = {.crs = true}},
    {.name = "STL", .extensions = ".stl",
     .write_tin = write_stl},
    {.name = "GeoJSON", .extensions = ".geojson .json", .can_be_packed = true,
     .read_features = read_geojson_file, .write_tin = write_triangles<write_geojson_layer>,
     .write_features = write_geojson_layer,
     .keeps = {.heights = true, .crs = true, .order = true}},
    {.name = "GeoPackage", .extensions = ".gpkg",
     .write_tin = write_triangles<write_geopackage>, .write_features = write_geopackage,
     .keeps = {.heights = true, .crs = true, .order = true}},
    {.name = "FlatGeobuf", .extensions = ".fgb",
     .write_tin = write_triangles<write_flatgeobuf>, .write_features = write_flatgeobuf,
     .keeps = {.heights = true, .crs = true, .order = true}},
    {.name = "Shapefile", .extensions = ".shp",
     .write_tin = write_triangles<write_shapefile>, .write_features = write_shapefile,
     .keeps = {.heights = true, .crs = true, .order = true}},
};
// clang-format on

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
