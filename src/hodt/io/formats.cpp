#include "hodt/io/formats.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/io/file_kind.h"
#include "hodt/io/file_name.h"
#include "hodt/io/gdal/readers.h"
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
PointTable parse_points(InputText input, const PointChoice& choice) {
  if (is_las(input.view())) {
    check_choice(choice, PointKind::las, input.name);
    return read_las_table(input, choice);
  }
  check_choice(choice, PointKind::table, input.name);
  return parse_point_table(std::move(input), choice.columns);
}

PointTable read_table(const std::filesystem::path& path, const PointChoice& choice) {
  return parse_points(read_input(path), choice);
}

/// Tables have this extension, too.
PointTable read_grid_or_table(const std::filesystem::path& path, const PointChoice& choice) {
  InputText input = read_input(path);
  if (is_esri_grid(input.view())) {
    input = {};  // GDAL reads it by itself
    return read_raster_points(path, choice);
  }
  return parse_points(std::move(input), choice);
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
     .keeps = {.heights = true, .crs = true}},
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
     .read_points = read_layer_points, .read_features = read_geojson_file,
     .write_tin = write_triangles<write_geojson_layer>, .write_features = write_geojson_layer,
     .keeps = {.heights = true, .crs = true, .order = true}},
    {.name = "GeoPackage", .extensions = ".gpkg",
     .read_points = read_layer_points, .read_features = read_layer_features,
     .write_tin = write_triangles<write_geopackage>, .write_features = write_geopackage,
     .keeps = {.heights = true, .crs = true, .order = true}},
    {.name = "FlatGeobuf", .extensions = ".fgb",
     .read_points = read_layer_points, .read_features = read_layer_features,
     .write_tin = write_triangles<write_flatgeobuf>, .write_features = write_flatgeobuf,
     .keeps = {.heights = true, .crs = true, .order = true}},
    {.name = "Shapefile", .extensions = ".shp",
     .read_points = read_layer_points, .read_features = read_layer_features,
     .write_tin = write_triangles<write_shapefile>, .write_features = write_shapefile,
     .keeps = {.heights = true, .crs = true, .order = true}},
    {.name = "DXF", .extensions = ".dxf",
     .read_points = read_layer_points, .read_features = read_layer_features},
    {.name = "GML", .extensions = ".gml",
     .read_points = read_layer_points, .read_features = read_layer_features},
    {.name = "KML", .extensions = ".kml",
     .read_points = read_layer_points, .read_features = read_layer_features},
    {.name = "MapInfo", .extensions = ".tab .mif",
     .read_points = read_layer_points, .read_features = read_layer_features},
    {.name = "SQLite", .extensions = ".sqlite",
     .read_points = read_layer_points, .read_features = read_layer_features},
    {.name = "ESRI ASCII grid", .extensions = ".asc", .can_be_packed = true,
     .read_points = read_grid_or_table},
    {.name = "GeoTIFF", .extensions = ".tif .tiff", .read_points = read_raster_points},
    {.name = "GDAL virtual raster", .extensions = ".vrt", .read_points = read_raster_points},
    {.name = "ERDAS Imagine", .extensions = ".img", .read_points = read_raster_points},
    {.name = "SRTM", .extensions = ".hgt", .read_points = read_raster_points},
    {.name = "USGS DEM", .extensions = ".dem", .read_points = read_raster_points},
    {.name = "DTED", .extensions = ".dt0 .dt1 .dt2", .read_points = read_raster_points},
    {.name = "netCDF grid", .extensions = ".nc", .read_points = read_raster_points},
    {.name = "Surfer grid", .extensions = ".grd", .read_points = read_raster_points},
    {.name = "ESRI float and BIL grids", .extensions = ".flt .bil", .read_points = read_raster_points},
    {.name = "ESRI binary grid", .extensions = ".adf", .read_points = read_raster_points},
    {.name = "JPEG 2000", .extensions = ".jp2", .read_points = read_raster_points},
    {.name = "GRIB", .extensions = ".grb .grb2", .read_points = read_raster_points},
};
// clang-format on

/// Meshes and features are never written packed.
bool may_be_packed(Use use) {
  return use != Use::write_tin && use != Use::write_features;
}

std::string extension_of(const std::filesystem::path& path, Use use) {
  return may_be_packed(use) ? format_extension(path) : lower_extension(path);
}

std::string known_extensions(Use use) {
  std::vector<std::string_view> known, packed;  // of the known ones, those that may be
  for (const Format& format : kFormats) {
    if (!can(format, use)) continue;
    for (const std::string_view extension : extensions_of(format)) {
      known.push_back(extension);
      if (format.can_be_packed) packed.push_back(extension);
    }
  }
  const std::string list = fmt::format("{}", fmt::join(known, ", "));
  if (!may_be_packed(use) || packed.empty()) return list;
  return fmt::format("{}, {} also with .gz", list,
                     packed == known ? "each" : fmt::format("{}", fmt::join(packed, ", ")));
}

bool is_reading(Use use) {
  return use == Use::read_points || use == Use::read_features || use == Use::read_tin;
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

std::vector<std::string_view> extensions_of(const Format& format) {
  std::vector<std::string_view> extensions;
  for (std::string_view rest = format.extensions; !rest.empty();) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    extensions.push_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return extensions;
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
  const bool is_packed = use != Use::write_tin && is_packed_name(path);
  for (const Format& format : kFormats) {
    const std::vector<std::string_view> known = extensions_of(format);
    if (can(format, use) && std::find(known.begin(), known.end(), extension) != known.end())
      return is_packed && !format.can_be_packed ? nullptr : &format;
  }
  return nullptr;
}

const Format& format_for(const std::filesystem::path& path, Use use) {
  if (const Format* format = find_format(path, use)) return *format;
  const std::string extension = extension_of(path, use);
  throw ParameterError(fmt::format(
      "cannot {} {}: {}; known are {}", doing(use),
      is_reading(use) ? display_name(path) : output_name(path),
      extension.empty() ? "the name has no extension" : "unknown extension '" + extension + "'",
      known_extensions(use)));
}

}  // namespace hodt
