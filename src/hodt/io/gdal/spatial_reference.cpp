#include "hodt/io/gdal/spatial_reference.h"

#include <utility>

#include <fmt/format.h>

#include "hodt/io/gdal/crs_facts.h"

namespace hodt {

namespace {

bool has_heights(OGRSpatialReferenceH reference) {
  return gdal().OSRIsCompound(reference) || gdal().OSRGetAxesCount(reference) > 2;
}

void drop_heights(OGRSpatialReferenceH reference) {
  if (gdal().OSRIsCompound(reference)) gdal().OSRStripVertical(reference);
  gdal().OSRDemoteTo2D(reference, nullptr);
}

std::string text_or_empty(const char* text) {
  return text ? text : "";
}

}  // namespace

Reference reference_of(const std::string& crs) {
  GdalErrors errors;
  Reference reference(gdal().OSRNewSpatialReference(nullptr));
  const bool known = gdal().OSRSetFromUserInput(reference.get(), crs.c_str()) == OGRERR_NONE;
  return known ? std::move(reference) : nullptr;
}

std::string wkt_of(OGRSpatialReferenceH reference, const char* format) {
  const std::string format_option = fmt::format("FORMAT={}", format);
  const char* const options[] = {format_option.c_str(), "MULTILINE=NO", nullptr};
  char* wkt = nullptr;
  const bool done = gdal().OSRExportToWktEx(reference, &wkt, options) == OGRERR_NONE;
  std::string text = done ? text_or_empty(wkt) : "";
  gdal().VSIFree(wkt);
  return text;
}

std::string crs_text(OGRSpatialReferenceH reference) {
  // "Undefined geographic SRS" and the like are how a GeoPackage says that it does not know.
  if (!reference || text_or_empty(gdal().OSRGetName(reference)).starts_with("Undefined "))
    return {};
  GdalErrors errors;
  const std::string authority = text_or_empty(gdal().OSRGetAuthorityName(reference, nullptr));
  const std::string code = text_or_empty(gdal().OSRGetAuthorityCode(reference, nullptr));
  return authority.empty() || code.empty() ? wkt_of(reference, "WKT2_2019")
                                           : fmt::format("{}:{}", authority, code);
}

std::optional<CrsFacts> crs_facts(const std::string& crs) {
  const Reference reference = reference_of(crs);
  if (!reference) return std::nullopt;
  GdalErrors errors;
  CrsFacts facts;
  facts.text = crs_text(reference.get());
  facts.name = text_or_empty(gdal().OSRGetName(reference.get()));
  facts.is_geographic = gdal().OSRIsGeographic(reference.get()) != 0;
  const bool is_vertical =
      gdal().OSRIsVertical(reference.get()) && !gdal().OSRIsCompound(reference.get());
  facts.is_plane = !is_vertical && !gdal().OSRIsGeocentric(reference.get());
  char* unit = nullptr;
  facts.unit = gdal().OSRGetLinearUnits(reference.get(), &unit);
  facts.unit_name = text_or_empty(unit);
  facts.has_heights = has_heights(reference.get());
  if (gdal().OSRIsCompound(reference.get())) {
    facts.height_unit = gdal().OSRGetTargetLinearUnits(reference.get(), "VERT_CS", &unit);
    facts.height_unit_name = text_or_empty(unit);
  }
  return facts;
}

bool are_equal_crs(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty()) return false;
  const Reference first = reference_of(a), second = reference_of(b);
  if (!first || !second) return false;
  GdalErrors errors;
  // Outlines need no heights, so their system need not tell of them.
  if (has_heights(first.get()) != has_heights(second.get()))
    for (const Reference* reference : {&first, &second}) drop_heights(reference->get());
  constexpr const char* options[] = {"CRITERION=EQUIVALENT_EXCEPT_AXIS_ORDER_GEOGCRS",
                                     "IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES",
                                     "IGNORE_COORDINATE_EPOCH=YES", nullptr};
  return gdal().OSRIsSameEx(first.get(), second.get(), options) != 0;
}

}  // namespace hodt
