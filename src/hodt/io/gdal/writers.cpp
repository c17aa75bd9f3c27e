#include "hodt/io/gdal/writers.h"

#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/base/printable.h"
#include "hodt/io/crs_name.h"
#include "hodt/io/feature_file.h"
#include "hodt/io/file_name.h"
#include "hodt/io/gdal/api.h"
#include "hodt/io/gdal/crs_facts.h"
#include "hodt/io/gdal/dataset.h"
#include "hodt/io/gdal/spatial_reference.h"
#include "hodt/io/well_known_binary.h"

namespace hodt {

namespace {

template <auto release>
struct Release {
  void operator()(void* handle) const { (gdal().*release)(handle); }
};
template <auto release>
using Owned = std::unique_ptr<void, Release<release>>;
using OwnedFeature = Owned<&GdalFunctions::OGR_F_Destroy>;
using OwnedField = Owned<&GdalFunctions::OGR_Fld_Destroy>;

/// Also of text of which GDAL understands its code alone; nullptr if it understands nothing. x and
/// y are what they always are to those who draw maps.
Reference reference_to_write(const std::string& crs) {
  Reference reference = reference_of(crs);
  if (const std::optional<CrsCode> code = crs_code(crs); !reference && code)
    reference = reference_of(fmt::format("{}:{}", code->authority, code->number));
  if (reference) gdal().OSRSetAxisMappingStrategy(reference.get(), OAMS_TRADITIONAL_GIS_ORDER);
  return reference;
}

/// Also of other text: nothing is lost, even if nobody understands it.
Reference reference_or_name(const std::string& crs) {
  if (crs.empty()) return nullptr;
  if (Reference reference = reference_to_write(crs)) return reference;
  GdalErrors errors;
  Reference reference(gdal().OSRNewSpatialReference(nullptr));
  gdal().OSRSetLocalCS(reference.get(), printable(crs).c_str());
  return reference;
}

/// The code that GDAL takes a system without a code for; empty if it finds none, or has one.
std::string guessed_code(OGRSpatialReferenceH reference) {
  if (gdal().OSRGetAuthorityCode(reference, nullptr)) return {};
  GdalErrors errors;
  const Reference guess(gdal().OSRClone(reference));
  if (gdal().OSRAutoIdentifyEPSG(guess.get()) != OGRERR_NONE) return {};
  const char* const code = gdal().OSRGetAuthorityCode(guess.get(), nullptr);
  return code ? fmt::format("EPSG:{}", code) : "";
}

/// GDAL takes UTM in feet for UTM.
void refuse_wrong_code(OGRSpatialReferenceH reference, const std::string& crs,
                       const std::filesystem::path& shown) {
  const std::string code = guessed_code(reference);
  if (!code.empty() && !are_equal_crs(crs, code))
    throw ParameterError(fmt::format(
        "cannot write {}: in this format GDAL would take the coordinate reference system for {}, "
        "which it is not; write another format, GeoPackage for example",
        shown.string(), code));
}

/// How a format is made.
struct Making {
  const char* driver;
  std::vector<const char*> layer_options;  ///< the last one is nullptr
  /// Of the files beside the first one.
  std::string_view companions;
  /// Whether the driver looks for a code of a system that has none.
  bool guesses_codes = false;
};

OGRwkbGeometryType type_of(const FeatureLayer& layer) {
  constexpr OGRwkbGeometryType types[] = {wkbPoint, wkbLineString, wkbPolygon};
  constexpr OGRwkbGeometryType with_heights[] = {wkbPoint25D, wkbLineString25D, wkbPolygon25D};
  return (layer.has_heights ? with_heights : types)[static_cast<int>(layer.geometry)];
}

OGRFieldType type_of(FieldType type) {
  switch (type) {
    case FieldType::integer:
      return OFTInteger64;
    case FieldType::real:
      return OFTReal;
    case FieldType::text:
      return OFTString;
  }
  return OFTString;
}

class LayerWriter {
 public:
  LayerWriter(const FeatureLayer& layer, const std::filesystem::path& shown, const Making& making)
      : layer_(layer), shown_(shown), making_(making) {}

  void write(const std::filesystem::path& path) {
    const Reference reference = reference_or_name(layer_.crs);
    if (reference && making_.guesses_codes) refuse_wrong_code(reference.get(), layer_.crs, shown_);
    GDALDriverH driver = gdal().GDALGetDriverByName(making_.driver);
    if (driver == nullptr)
      throw ParameterError(fmt::format("cannot write {}: this GDAL has no driver {}",
                                       shown_.string(), making_.driver));
    Dataset dataset(gdal().GDALCreate(driver, path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    if (!dataset) fail();
    OGRLayerH to = gdal().GDALDatasetCreateLayer(dataset.get(), layer_name(layer_, shown_).c_str(),
                                                 reference.get(), type_of(layer_),
                                                 const_cast<char**>(making_.layer_options.data()));
    if (to == nullptr) fail();
    create_fields(to);
    create_features(to);
    dataset.reset();  // what is left is written now
    if (const std::string error = errors_.take(); !error.empty()) fail(error);
  }

 private:
  [[noreturn]] void fail() { fail(errors_.take()); }
  [[noreturn]] void fail(const std::string& why) {
    throw FileError(fmt::format("cannot write {}: {}", shown_.string(), why));
  }

  void create_fields(OGRLayerH to) {
    for (const Field& field : layer_.fields) {
      const OwnedField definition(gdal().OGR_Fld_Create(field.name.c_str(), type_of(field.type)));
      if (gdal().OGR_L_CreateField(to, definition.get(), TRUE) != OGRERR_NONE) fail();
    }
  }

  void create_features(OGRLayerH to) {
    const OGRFeatureDefnH definition = gdal().OGR_L_GetLayerDefn(to);
    const WellKnownBinary binary(layer_);
    LayerFeature feature;
    std::string bytes;
    feature.values.resize(layer_.fields.size());
    for (std::size_t i = 0; i < layer_.count; ++i) {
      layer_.make(i, feature);
      bytes.clear();
      binary.append(bytes, feature);
      const OwnedFeature made(gdal().OGR_F_Create(definition));
      OGRGeometryH geometry = nullptr;
      if (gdal().OGR_G_CreateFromWkb(bytes.data(), nullptr, &geometry,
                                     static_cast<int>(bytes.size())) != OGRERR_NONE)
        fail();
      gdal().OGR_F_SetGeometryDirectly(made.get(), geometry);
      for (int field = 0; field < static_cast<int>(feature.values.size()); ++field)
        set_value(made.get(), field, feature.values[static_cast<std::size_t>(field)]);
      if (gdal().OGR_L_CreateFeature(to, made.get()) != OGRERR_NONE) fail();
    }
  }

  static void set_value(OGRFeatureH feature, int field, const FieldValue& value) {
    if (const auto* const whole = std::get_if<std::int64_t>(&value))
      return gdal().OGR_F_SetFieldInteger64(feature, field, *whole);
    if (const auto* const real = std::get_if<double>(&value); real && std::isfinite(*real))
      return gdal().OGR_F_SetFieldDouble(feature, field, *real);
    if (const auto* const words = std::get_if<std::string>(&value))
      return gdal().OGR_F_SetFieldString(feature, field, words->c_str());
    gdal().OGR_F_SetFieldNull(feature, field);
  }

  const FeatureLayer& layer_;
  const std::filesystem::path& shown_;
  const Making& making_;
  GdalErrors errors_;
};

std::string with_capitals(std::string_view text) {
  std::string capitals(text);
  for (char& c : capitals)
    if ('a' <= c && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return capitals;
}

/// GDAL writes extensions in lower case, whatever the name is that it is told.
void capitalize_extensions(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    files.push_back(entry.path());
  for (const std::filesystem::path& file : files)
    std::filesystem::rename(file, std::filesystem::path(file).replace_extension(
                                      with_capitals(file.extension().string())));
}

void write_layer(const FeatureLayer& layer, OutputFile& file, const Making& making) {
  const std::string extension = follow_links(file.path()).extension().string();
  const bool has_capitals = !extension.empty() && extension == with_capitals(extension);
  file.fill_by_name(
      [&](const std::filesystem::path& path) {
        const auto plain = std::filesystem::path(path).replace_extension(lower_extension(path));
        LayerWriter(layer, file.path(), making).write(plain);
        if (has_capitals)
          capitalize_extensions(path.parent_path());
        else if (plain != path)
          std::filesystem::rename(plain, path);
      },
      has_capitals ? with_capitals(making.companions) : std::string(making.companions));
}

}  // namespace

void write_flatgeobuf(const FeatureLayer& layer, OutputFile& file) {
  write_layer(layer, file, {"FlatGeobuf", {nullptr}, {}, true});
}

void write_shapefile(const FeatureLayer& layer, OutputFile& file) {
  if (!file.is_replaced())
    throw ParameterError(
        fmt::format("cannot write {}: a shapefile is several files, which only a folder can hold",
                    file.path().string()));
  const std::string extension = follow_links(file.path()).extension().string();
  if (extension != ".shp" && extension != ".SHP")
    throw ParameterError(
        fmt::format("cannot write {}: nobody finds the parts of a shapefile whose name ends in {}; "
                    "name it .shp",
                    file.path().string(), extension));
  write_layer(layer, file,
              {"ESRI Shapefile",
               {"ENCODING=UTF-8", "DBF_DATE_LAST_UPDATE=2000-01-01", nullptr},
               ".shx .dbf .prj .cpg .qix .sbn .sbx .idm .ind .qpj"});
}

std::string crs_definition(const std::string& crs) {
  const Reference reference = reference_to_write(crs);
  if (!reference) return {};
  GdalErrors errors;
  return wkt_of(reference.get(), "WKT1_GDAL");
}

}  // namespace hodt
