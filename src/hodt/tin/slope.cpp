#include "hodt/tin/slope.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hodt {

Normal normal_of(const Point& a, const Point& b, const Point& c, double za, double zb, double zc) {
  double ux = b.x - a.x, uy = b.y - a.y, vx = c.x - a.x, vy = c.y - a.y;
  double uz = zb - za, vz = zc - za;
  // In units of the longest sides, so that no product is out of range.
  const double width = std::max({std::fabs(ux), std::fabs(uy), std::fabs(vx), std::fabs(vy)});
  const double height = std::max(std::fabs(uz), std::fabs(vz));
  for (double* const side : {&ux, &uy, &vx, &vy}) *side /= width;
  const double up = ux * vy - uy * vx;
  if (height == 0) return {0, 0, up, width, 0};
  for (double* const side : {&uz, &vz}) *side /= height;
  return {uy * vz - uz * vy, uz * vx - ux * vz, up, width, height};
}

Slope slope_of(const Point& a, const Point& b, const Point& c, double za, double zb, double zc) {
  // It leans to where the plane falls.
  const auto [east, north, up, width, height] = normal_of(a, b, c, za, zb, zc);
  if (height == 0) return {};
  constexpr double degrees = 180 / std::numbers::pi;
  const double slope = std::atan2(height * std::hypot(east, north), width * up) * degrees;
  if (east == 0 && north == 0) return {slope, {}};
  const double aspect = std::atan2(east, north) * degrees;
  const double from_north = aspect < 0 ? aspect + 360 : aspect;
  return {slope, from_north < 360 ? from_north : 0};
}

}  // namespace hodt
