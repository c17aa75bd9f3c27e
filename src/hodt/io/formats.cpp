#include "hodt/io/formats.h"

#include <utility>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/file_kind.h"
#include "hodt/io/file_name.h"
#include "hodt/io/gdal/readers.h"
#include "hodt/io/geojson_reader.h"
#include "hodt/io/input_text.h"
#include "hodt/io/obj.h"
#include "hodt/io/ply.h"
#include "hodt/io/point_text_file.h"

namespace hodt {

namespace {

PointTable read_table(const std::filesystem::path& path, const PointChoice& choice) {
  check_choice(choice, PointKind::table, display_name(path));
  return parse_point_table(read_input(path), choice.columns);
}

/// Tables have this extension, too.
PointTable read_grid_or_table(const std::filesystem::path& path, const PointChoice& choice) {
  InputText input = read_input(path);
  if (is_esri_grid(input.view())) return read_raster_points(path, choice);
  check_choice(choice, PointKind::table, input.name);
  return parse_point_table(std::move(input), choice.columns);
}

std::string read_geojson_file(const std::filesystem::path& path, const std::string& layer,
                              const FeatureTaker& taker) {
  if (!layer.empty())
    throw ParameterError(
        fmt::format("{} is GeoJSON, which has no layers, and no '{}'", display_name(path), layer));
  return read_geojson(read_input(path), taker);
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
    {"GeoJSON", ".geojson .json", true, read_layer_points, read_geojson_file, nullptr, nullptr,
     nullptr, kNoMesh},
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
    {"GeoPackage", ".gpkg", false, read_layer_points, read_layer_features, nullptr, nullptr,
     nullptr, kNoMesh},
    {"Shapefile", ".shp", false, read_layer_points, read_layer_features, nullptr, nullptr, nullptr,
     kNoMesh},
    {"FlatGeobuf", ".fgb", false, read_layer_points, read_layer_features, nullptr, nullptr, nullptr,
     kNoMesh},
    {"DXF", ".dxf", false, read_layer_points, read_layer_features, nullptr, nullptr, nullptr,
     kNoMesh},
    {"GML", ".gml", false, read_layer_points, read_layer_features, nullptr, nullptr, nullptr,
     kNoMesh},
    {"KML", ".kml", false, read_layer_points, read_layer_features, nullptr, nullptr, nullptr,
     kNoMesh},
    {"MapInfo", ".tab .mif", false, read_layer_points, read_layer_features, nullptr, nullptr,
     nullptr, kNoMesh},
    {"SQLite", ".sqlite", false, read_layer_points, read_layer_features, nullptr, nullptr, nullptr,
     kNoMesh},
    {"ESRI ASCII grid", ".asc", true, read_grid_or_table, nullptr, nullptr, nullptr, nullptr,
     kNoMesh},
    {"GeoTIFF", ".tif .tiff", false, read_raster_points, nullptr, nullptr, nullptr, nullptr,
     kNoMesh},
    {"GDAL virtual raster", ".vrt", false, read_raster_points, nullptr, nullptr, nullptr, nullptr,
     kNoMesh},
    {"ERDAS Imagine", ".img", false, read_raster_points, nullptr, nullptr, nullptr, nullptr,
     kNoMesh},
    {"SRTM", ".hgt", false, read_raster_points, nullptr, nullptr, nullptr, nullptr, kNoMesh},
    {"USGS DEM", ".dem", false, read_raster_points, nullptr, nullptr, nullptr, nullptr, kNoMesh},
    {"DTED", ".dt0 .dt1 .dt2", false, read_raster_points, nullptr, nullptr, nullptr, nullptr,
     kNoMesh},
    {"netCDF grid", ".nc", false, read_raster_points, nullptr, nullptr, nullptr, nullptr, kNoMesh},
    {"Surfer grid", ".grd", false, read_raster_points, nullptr, nullptr, nullptr, nullptr, kNoMesh},
    {"ESRI float and BIL grids", ".flt .bil", false, read_raster_points, nullptr, nullptr, nullptr,
     nullptr, kNoMesh},
    {"ESRI binary grid", ".adf", false, read_raster_points, nullptr, nullptr, nullptr, nullptr,
     kNoMesh},
    {"JPEG 2000", ".jp2", false, read_raster_points, nullptr, nullptr, nullptr, nullptr, kNoMesh},
    {"GRIB", ".grb .grb2", false, read_raster_points, nullptr, nullptr, nullptr, nullptr, kNoMesh},
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
  const bool is_packed = use != Use::write_tin && is_packed_name(path);
  for (const Format& format : kFormats)
    if (can(format, use) && has_extension(format, extension))
      return is_packed && !format.can_be_packed ? nullptr : &format;
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
