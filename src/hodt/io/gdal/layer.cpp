#include "hodt/io/gdal/layer.h"

#include <algorithm>
#include <memory>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "hodt/base/error.h"
#include "hodt/io/gdal/spatial_reference.h"
#include "hodt/io/input_text.h"

namespace hodt {

namespace {

struct DestroyFeature {
  void operator()(OGRFeatureH feature) const { gdal().OGR_F_Destroy(feature); }
};
using Feature = std::unique_ptr<std::remove_pointer_t<OGRFeatureH>, DestroyFeature>;

std::string quoted_list(const std::vector<std::string>& names) {
  std::vector<std::string> quoted;
  for (const std::string& name : names) quoted.push_back("'" + name + "'");
  return fmt::format("{}", fmt::join(quoted, ", "));
}

std::string field_name(OGRFeatureDefnH fields, int field) {
  return gdal().OGR_Fld_GetNameRef(gdal().OGR_FD_GetFieldDefn(fields, field));
}

/// Whether a drawing (DXF) has a text there: TEXT, MTEXT, ATTRIB and the texts of dimensions. Its
/// point is where the text stands, and its height that of the paper.
bool is_label(OGRFeatureH feature) {
  const char* const style = gdal().OGR_F_GetStyleString(feature);
  return style && std::string_view(style).starts_with("LABEL(");
}

}  // namespace

Layer::Layer(const std::filesystem::path& path, const std::string& name)
    : file_(display_name(path)), dataset_(open_dataset(path, DatasetKind::vector)) {
  std::vector<std::string> names;
  const int count = gdal().GDALDatasetGetLayerCount(dataset_.get());
  for (int i = 0; i < count; ++i) {
    const OGRLayerH layer = gdal().GDALDatasetGetLayer(dataset_.get(), i);
    // Tables without geometries are of no use.
    if (!layer || gdal().OGR_L_GetGeomType(layer) == wkbNone) continue;
    names.emplace_back(gdal().OGR_L_GetName(layer));
    if (name.empty() ? names.size() == 1 : names.back() == name) layer_ = layer;
  }
  if (names.empty()) throw InputError(file_ + " holds no layer of map features");
  if (!name.empty() && !layer_)
    throw ParameterError(fmt::format("{} has no layer '{}'; there {} {}", file_, name,
                                     names.size() == 1 ? "is" : "are", quoted_list(names)));
  if (name.empty() && names.size() > 1)
    throw ParameterError(
        fmt::format("{} has {} layers: {}; choose one with --layer (of INPUT), or "
                    "as '{}|layername={}'",
                    file_, names.size(), quoted_list(names), file_, names[0]));
}

std::string Layer::name() const {
  return gdal().OGR_L_GetName(layer_);
}

std::string Layer::crs() const {
  return crs_text(gdal().OGR_L_GetSpatialRef(layer_));
}

std::string Layer::driver() const {
  return gdal().GDALGetDescription(gdal().GDALGetDatasetDriver(dataset_.get()));
}

std::size_t Layer::size() const {
  GdalErrors errors;
  const GIntBig count = gdal().OGR_L_GetFeatureCount(layer_, FALSE);
  return count < 0 ? 0 : static_cast<std::size_t>(count);
}

std::vector<std::string> Layer::fields() const {
  const OGRFeatureDefnH fields = gdal().OGR_L_GetLayerDefn(layer_);
  std::vector<std::string> names;
  for (int i = 0; i < gdal().OGR_FD_GetFieldCount(fields); ++i)
    names.push_back(field_name(fields, i));
  return names;
}

int Layer::number_field(const std::string& name) const {
  const std::vector<std::string> names = fields();
  const auto at = std::find(names.begin(), names.end(), name);
  if (at == names.end())
    throw ParameterError(
        fmt::format("{} has no field '{}'; {}", file_, name,
                    names.empty() ? "it has no fields" : "its fields are " + quoted_list(names)));
  const int field = static_cast<int>(at - names.begin());
  const OGRFieldType type =
      gdal().OGR_Fld_GetType(gdal().OGR_FD_GetFieldDefn(gdal().OGR_L_GetLayerDefn(layer_), field));
  if (type != OFTInteger && type != OFTInteger64 && type != OFTReal)
    throw ParameterError(fmt::format("the field '{}' of {} is no field of numbers", name, file_));
  return field;
}

Index Layer::for_each(int field, const std::function<void(OGRFeatureH, Index)>& f) const {
  const std::vector<std::string> names = fields();
  const bool is_drawing = driver() == "DXF";
  std::vector<const char*> ignored;
  if (!is_drawing) ignored.push_back("OGR_STYLE");
  for (std::size_t i = 0; i < names.size(); ++i)
    if (static_cast<int>(i) != field) ignored.push_back(names[i].c_str());
  ignored.push_back(nullptr);
  GdalErrors errors;
  gdal().OGR_L_SetIgnoredFields(layer_, ignored.data());  // or they are read in vain
  errors.take();
  gdal().OGR_L_ResetReading(layer_);
  Index number = 0, labels = 0;
  while (const Feature feature{gdal().OGR_L_GetNextFeature(layer_)}) {
    if (++number == kNone) throw InputError(fmt::format("{} has too many features", file_));
    if (is_drawing && is_label(feature.get())) {
      ++labels;
      continue;
    }
    try {
      f(feature.get(), number);
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}, feature {}: {}", file_, number, error.what()));
    }
  }
  if (const std::string error = errors.take(); !error.empty())
    throw InputError(fmt::format("{} is damaged behind feature {}: {}", file_, number, error));
  return labels;
}

std::vector<std::string> label_warnings(Index labels) {
  if (labels == 0) return {};
  return {fmt::format("{} of the drawing {} left out",
                      labels == 1 ? "1 label" : fmt::format("{} labels", labels),
                      labels == 1 ? "is" : "are")};
}

}  // namespace hodt
