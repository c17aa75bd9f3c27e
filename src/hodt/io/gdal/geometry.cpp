#include "hodt/io/gdal/geometry.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "hodt/base/error.h"

namespace hodt {

namespace {

constexpr int kStride = sizeof(double);

OGRwkbGeometryType kind_of(OGRGeometryH geometry) {
  return gdal().OGR_GT_Flatten(gdal().OGR_G_GetGeometryType(geometry));
}

/// Curves would need vertices that the file does not have.
void check_kind(OGRwkbGeometryType kind) {
  const bool is_known = (wkbPoint <= kind && kind <= wkbGeometryCollection) ||
                        kind == wkbPolyhedralSurface || kind == wkbTIN || kind == wkbTriangle;
  if (!is_known)
    throw InputError(
        fmt::format("it is a {}, which hodt does not read; make it points, lines or polygons, with "
                    "ogr2ogr -nlt CONVERT_TO_LINEAR for example",
                    gdal().OGRGeometryTypeToName(kind)));
}

}  // namespace

void for_each_part(OGRGeometryH geometry, const std::function<void(OGRGeometryH, Part)>& f) {
  const OGRwkbGeometryType kind = kind_of(geometry);
  check_kind(kind);
  if (gdal().OGR_G_IsEmpty(geometry)) return;
  if (kind == wkbPoint) return f(geometry, Part::point);
  if (kind == wkbLineString) return f(geometry, Part::line);
  const bool is_polygon = kind == wkbPolygon || kind == wkbTriangle;
  const int members = gdal().OGR_G_GetGeometryCount(geometry);
  for (int i = 0; i < members; ++i) {
    const OGRGeometryH member = gdal().OGR_G_GetGeometryRef(geometry, i);
    if (is_polygon)
      f(member, i == 0 ? Part::outer_ring : Part::inner_ring);
    else
      for_each_part(member, f);
  }
}

Line positions_of(OGRGeometryH part, bool heights) {
  const auto count = static_cast<std::size_t>(gdal().OGR_G_GetPointCount(part));
  Line line;
  line.xy.resize(count);
  if (heights && gdal().OGR_G_Is3D(part)) line.z.resize(count);
  if (count == 0) return line;
  gdal().OGR_G_GetPoints(part, &line.xy[0].x, sizeof(Point), &line.xy[0].y, sizeof(Point),
                         line.z.empty() ? nullptr : line.z.data(), kStride);
  const bool is_finite =
      std::all_of(line.xy.begin(), line.xy.end(),
                  [](const Point& p) { return std::isfinite(p.x) && std::isfinite(p.y); }) &&
      std::all_of(line.z.begin(), line.z.end(), [](double z) { return std::isfinite(z); });
  if (!is_finite)
    throw InputError("it has a coordinate that is not finite; give it a number or remove it");
  return line;
}

const char* name_of(Part part) {
  switch (part) {
    case Part::point:
      return "point";
    case Part::line:
      return "line";
    case Part::outer_ring:
    case Part::inner_ring:
      return "polygon";
  }
  return "";
}

}  // namespace hodt
