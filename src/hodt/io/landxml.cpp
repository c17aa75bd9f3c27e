#include "hodt/io/landxml.h"

#include <cmath>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "hodt/io/crs.h"
#include "hodt/io/crs_name.h"
#include "hodt/io/number_text.h"
#include "hodt/io/parallel_text.h"
#include "hodt/io/tin_parts.h"

namespace hodt {

namespace {

constexpr std::string_view kBeginning = R"(<?xml version="1.0" encoding="UTF-8"?>
<LandXML xmlns="http://www.landxml.org/schema/LandXML-1.2" version="1.2" date="2000-01-01" time="00:00:00">
)";
constexpr std::string_view kSurface = R"(<Application name="hodt"/>
<Surfaces>
<Surface name="terrain">
<Definition surfType="TIN">
<Pnts>
)";
constexpr std::string_view kBetween = "</Pnts>\n<Faces>\n";
constexpr std::string_view kEnd = "</Faces>\n</Definition>\n</Surface>\n</Surfaces>\n</LandXML>\n";

/// A unit of lengths that the format has.
struct LinearUnit {
  double metres;
  std::string_view name, name_for_heights;
  bool is_metric;
};
constexpr LinearUnit kLinearUnits[] = {{1, "meter", "meter", true},
                                       {0.3048, "foot", "feet", false},
                                       {1200. / 3937, "USSurveyFoot", "feet", false},
                                       {1000, "kilometer", "kilometer", true},
                                       {1609.344, "mile", "miles", false}};

const LinearUnit* unit_of(double metres) {
  for (const LinearUnit& unit : kLinearUnits)
    if (std::fabs(unit.metres - metres) < 1e-8 * unit.metres) return &unit;
  return nullptr;
}

std::string units_text(const LinearUnit& unit, const LinearUnit* heights) {
  const std::string_view others = unit.is_metric
                                      ? R"(temperatureUnit="celsius" pressureUnit="milliBars")"
                                      : R"(temperatureUnit="fahrenheit" pressureUnit="inHG")";
  std::string elevation;
  if (heights != nullptr)
    elevation = fmt::format(" elevationUnit=\"{}\"", heights->name_for_heights);
  return fmt::format(
      "<Units><{} areaUnit=\"{}\" linearUnit=\"{}\" volumeUnit=\"{}\" {}{}/></Units>\n",
      unit.is_metric ? "Metric" : "Imperial", unit.is_metric ? "squareMeter" : "squareFoot",
      unit.name, unit.is_metric ? "cubicMeter" : "cubicFeet", others, elevation);
}

/// Of x and y, and of heights where the system says that these are in another one. Metres where
/// nothing is known, as the format wants to know a unit; nothing where it has none of them.
std::string units_of(const std::string& crs) {
  const CrsUnits units = crs_units(crs);
  if (units.horizontal.empty()) return units_text(kLinearUnits[0], nullptr);
  const LinearUnit* const unit = unit_of(units.horizontal_metres);
  if (unit == nullptr) return {};
  const bool differs = units.metres != 0 && !is_same_unit(units.metres, unit->metres);
  const LinearUnit* const heights = differs ? unit_of(units.metres) : nullptr;
  return units_text(*unit, heights);
}

std::string coordinate_system(std::string_view crs) {
  if (crs.empty()) return {};
  std::string code;
  if (const auto number = epsg_code(crs)) code = fmt::format(" epsgCode=\"{}\"", *number);
  return fmt::format("<CoordinateSystem {}=\"{}\"{}/>\n", is_wkt(crs) ? "ogcWktCode" : "name",
                     xml_attribute(crs), code);
}

}  // namespace

void write_landxml(const Tin& tin, OutputFile& file) {
  file.write(kBeginning);
  file.write(units_of(tin.crs));
  file.write(coordinate_system(tin.crs));
  file.write(kSurface);
  constexpr std::size_t longest = 20 + 4 * (kLongestNumber + 1);
  const PointSet& points = tin.points;
  write_records(file, points.size(), longest, [&](std::size_t i, char* to) {
    to = format_number(put_text(to, "<P id=\""), static_cast<Index>(i + 1));
    to = format_number(put_text(to, "\">"), points.xy[i].y);
    to = format_number(put_text(to, " "), points.xy[i].x);
    to = format_number(put_text(to, " "), height_or_zero(points, i));
    return put_text(to, "</P>\n");
  });
  file.write(kBetween);
  write_records(file, tin.triangles.size(), longest, [&](std::size_t t, char* to) {
    const auto& [a, b, c] = tin.triangles[t];
    to = format_number(put_text(to, "<F>"), a + 1);
    to = format_number(put_text(to, " "), b + 1);
    to = format_number(put_text(to, " "), c + 1);
    return put_text(to, "</F>\n");
  });
  file.write(kEnd);
}

}  // namespace hodt
