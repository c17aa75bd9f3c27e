#include "hodt/io/file_kind.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include <fmt/format.h>

#include "hodt/base/error.h"

namespace hodt {

namespace {

using std::string_view_literals::operator""sv;

constexpr std::string_view kMesh =
    "a mesh; 'hodt check' looks at OBJ and PLY meshes; export the vertices as a table x,y,z";
constexpr std::string_view kRaster =
    "a raster; hodt reads rasters by their extensions, .tif, .asc, .nc and others: name it so, "
    "unpacked, or write its cells as points, with gdal_translate -of XYZ for example";
constexpr std::string_view kVector =
    "map features; hodt reads them by their extensions, .gpkg, .shp, .fgb, .geojson and others: "
    "name it so, unpacked, or make it a GeoPackage with ogr2ogr";
constexpr std::string_view kCloud =
    "a point cloud; write it as text, with pdal translate or las2txt for example";
constexpr std::string_view kSheet = "a spreadsheet; save the sheet with the points as CSV";
constexpr std::string_view kArchive = "an archive; unpack it first";
constexpr std::string_view kData = "a data file; export the points as a table x,y,z";
constexpr std::string_view kPage = "no data; export the points as a table x,y,z";

struct Signature {
  std::string_view start;
  std::string_view format;
  std::string_view advice;
};

/// First bytes that nothing else has.
constexpr Signature kSignatures[] = {
    {"ASTM-E57"sv, "E57", kCloud},
    {"# .PCD"sv, "PCD", kCloud},
    {"glTF"sv, "glTF", kMesh},
    {"# vtk DataFile"sv, "VTK", kMesh},
    {"$MeshFormat"sv, "Gmsh", kMesh},
    {"MESH2D"sv, "2DM", kMesh},
    {"II*\0"sv, "TIFF", kRaster},
    {"MM\0*"sv, "TIFF", kRaster},
    {"II+\0"sv, "BigTIFF", kRaster},
    {"MM\0+"sv, "BigTIFF", kRaster},
    {"DSAA"sv, "Surfer grid", kRaster},
    {"DSBB"sv, "Surfer grid", kRaster},
    {"DSRB"sv, "Surfer grid", kRaster},
    {"EHFA_HEADER_TAG"sv, "ERDAS Imagine", kRaster},
    {"CDF\1"sv, "netCDF", kRaster},
    {"CDF\2"sv, "netCDF", kRaster},
    {"CDF\5"sv, "netCDF", kRaster},
    {"\x89HDF\r\n\x1a\n"sv, "HDF5 or netCDF", kRaster},
    {"GRIB"sv, "GRIB", kRaster},
    {"\0\0\x27\x0A"sv, "shapefile", kVector},
    {"SQLite format 3"sv, "SQLite or GeoPackage", kVector},
    {"fgb\3"sv, "FlatGeobuf", kVector},
    {"PAR1\x15"sv, "Parquet", kVector},
    {"AC10"sv, "DWG", kVector},
    {"AutoCAD Binary DXF"sv, "DXF", kVector},
    {"\xD0\xCF\x11\xE0"sv, "old Office", kSheet},
    {"BZh"sv, "bzip2", kArchive},
    {"\xFD"
     "7zXZ"sv,
     "xz", kArchive},
    {"\x28\xB5\x2F\xFD"sv, "Zstandard", kArchive},
    {"7z\xBC\xAF"sv, "7z", kArchive},
    {"Rar!"sv, "RAR", kArchive},
    {"\x93NUMPY"sv, "NumPy", kData},
    {"MATLAB 5.0"sv, "MATLAB", kData},
    {"{\\rtf"sv, "RTF", kPage},
    {"%PDF-"sv, "PDF", kPage},
    {"%!PS"sv, "PostScript", kPage},
};

std::string described(std::string_view format, std::string_view advice) {
  // "a mesh; do this" becomes "a mesh (PLY); do this".
  const std::size_t cut = advice.find(';');
  return fmt::format("{} ({}){}", advice.substr(0, cut), format, advice.substr(cut));
}

char lower(char c) {
  return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool contains_word(std::string_view text, std::string_view lower_case) {
  const auto same = [](char a, char b) { return lower(a) == b; };
  return std::search(text.begin(), text.end(), lower_case.begin(), lower_case.end(), same) !=
         text.end();
}

bool starts_with_word(std::string_view text, std::string_view lower_case) {
  return contains_word(text.substr(0, lower_case.size()), lower_case);
}

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

std::string_view without_leading_blanks(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  return text;
}

/// The first word of the text, and the text behind it.
std::string_view take_word(std::string_view& text) {
  text = without_leading_blanks(text);
  const auto end = std::find_if(text.begin(), text.end(), is_blank);
  const std::string_view word(text.data(), static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(word.size());
  return word;
}

std::string zip_content(std::string_view start) {
  if (contains_word(start, "[content_types].xml") || contains_word(start, "xl/") ||
      contains_word(start, "spreadsheet")) {
    return described("xlsx or ods", kSheet);
  }
  if (contains_word(start, ".kml")) return described("KMZ", kVector);
  return described("zip", kArchive);
}

std::string markup(std::string_view start) {
  if (starts_with_word(start, "<!doctype html") || starts_with_word(start, "<html"))
    return described("HTML", kPage);
  constexpr Signature roots[] = {{"<landxml", "LandXML", kMesh}, {"<gpx", "GPX", kVector},
                                 {"<kml", "KML", kVector},       {"<html", "HTML", kPage},
                                 {"<x3d", "X3D", kMesh},         {"<collada", "COLLADA", kMesh},
                                 {"gml", "GML", kVector},        {"<vtkfile", "VTK", kMesh}};
  for (const Signature& root : roots)
    if (contains_word(start, root.start)) return described(root.format, root.advice);
  return described("XML", kData);
}

bool is_json(std::string_view text) {
  if (text.starts_with('{')) return true;
  if (!text.starts_with('[')) return false;
  const std::string_view inner = without_leading_blanks(text.substr(1));
  return !inner.empty() && std::string_view("{[\"-0123456789").find(inner.front()) != inner.npos;
}

std::string json(std::string_view start) {
  const bool features =
      contains_word(start, "\"feature") || contains_word(start, "\"coordinates\"");
  return features ? described("GeoJSON", kVector) : described("JSON", kData);
}

bool is_dxf(std::string_view text) {
  return take_word(text) == "0" && take_word(text) == "SECTION";
}

bool is_off(std::string_view text) {
  std::string_view word = take_word(text);
  return word == "OFF" || word == "COFF" || word == "NOFF" || word == "STOFF" || word == "nOFF";
}

/// "v 1 2 3" or another statement of OBJ, after its comments.
bool is_obj(std::string_view text) {
  text = without_leading_blanks(text);
  while (text.starts_with('#')) {
    text.remove_prefix(std::min(text.find('\n'), text.size()));
    text = without_leading_blanks(text);
  }
  const std::string_view word = take_word(text);
  if (word == "mtllib" || word == "usemtl") return true;
  if (word == "v" || word == "vn" || word == "vt") {
    const std::string_view number = take_word(text);
    return !number.empty() && number.find_first_not_of("0123456789+-.eE") == number.npos;
  }
  return (word == "o" || word == "g") && text.find("\nv ") != text.npos;
}

/// The size of a binary STL follows from its number of triangles.
bool is_binary_stl(std::string_view bytes) {
  constexpr std::size_t header = 84, triangle = 50;
  if (bytes.size() < header) return false;
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < 4; ++i)
    count |= std::uint64_t{static_cast<unsigned char>(bytes[80 + i])} << (8 * i);
  return bytes.size() == header + triangle * count && count > 0;
}

bool is_stl(std::string_view start) {
  return starts_with_word(start, "solid") && contains_word(start, "facet");
}

std::string text_format(std::string_view start) {
  const std::string_view text = without_leading_blanks(start);
  if (text.starts_with("ply\n") || text.starts_with("ply\r")) return described("PLY", kMesh);
  if (is_off(text)) return described("OFF", kMesh);
  if (is_stl(text)) return described("STL", kMesh);
  if (is_obj(text)) return described("OBJ", kMesh);
  if (is_esri_grid(text)) return described("ESRI ASCII grid", kRaster);
  if (text.starts_with("VERSION") && contains_word(text, "\nfields "))
    return described("PCD", kCloud);
  if (is_dxf(text)) return described("DXF", kVector);
  if (text.starts_with('<')) return markup(text);
  if (is_json(text)) return json(text);
  return {};
}

/// Text in UTF-16 without a mark: every other byte is zero.
bool is_unmarked_utf16(std::string_view text) {
  const std::string_view start = text.substr(0, 64);
  if (start.size() < 4) return false;
  const auto zeros_from = [&](std::size_t first) {
    for (std::size_t i = first; i < start.size(); i += 2)
      if (start[i] != '\0' || start[i ^ 1] == '\0') return false;
    return true;
  };
  return zeros_from(0) || zeros_from(1);
}

}  // namespace

bool is_esri_grid(std::string_view bytes) {
  const std::string_view text = without_leading_blanks(bytes.substr(0, 4096));
  for (const std::string_view key : {"ncols", "nrows", "xllcorner", "xllcenter"})
    if (starts_with_word(text, key) && text.size() > key.size() && is_blank(text[key.size()]))
      return true;
  return false;
}

std::string foreign_format(std::string_view bytes) {
  for (const Signature& signature : kSignatures)
    if (bytes.starts_with(signature.start)) return described(signature.format, signature.advice);
  constexpr std::size_t enough = 4096;
  const std::string_view start = bytes.substr(0, enough);
  if (start.starts_with("PK\3\4")) return zip_content(start);
  if (start.substr(0, 262).ends_with("ustar")) return described("tar", kArchive);
  // Text of a mesh can begin like anything, so what its size proves comes first.
  if (start.find('\0') != start.npos && is_binary_stl(bytes)) return described("STL", kMesh);
  return text_format(start);
}

void require_table(const InputText& input) {
  if (const std::string format = foreign_format(input.view()); !format.empty())
    throw InputError(fmt::format("{} is {}", input.name, format));
  if (is_unmarked_utf16(input.view()))
    throw InputError(
        fmt::format("{} is UTF-16 text without a byte order mark; save it as UTF-8", input.name));
  require_text(input);
}

}  // namespace hodt
