#include "hodt/io/landxml.h"

#include <string>
#include <string_view>

#include <fmt/format.h>

#include "hodt/io/crs_name.h"
#include "hodt/io/number_text.h"
#include "hodt/io/parallel_text.h"
#include "hodt/io/tin_parts.h"

namespace hodt {

namespace {

constexpr std::string_view kBeginning = R"(<?xml version="1.0" encoding="UTF-8"?>
<LandXML xmlns="http://www.landxml.org/schema/LandXML-1.2" version="1.2" date="2000-01-01" time="00:00:00">
<Units><Metric areaUnit="squareMeter" linearUnit="meter" volumeUnit="cubicMeter" temperatureUnit="celsius" pressureUnit="milliBars"/></Units>
)";
constexpr std::string_view kSurface = R"(<Application name="hodt"/>
<Surfaces>
<Surface name="terrain">
<Definition surfType="TIN">
<Pnts>
)";
constexpr std::string_view kBetween = "</Pnts>\n<Faces>\n";
constexpr std::string_view kEnd = "</Faces>\n</Definition>\n</Surface>\n</Surfaces>\n</LandXML>\n";

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
