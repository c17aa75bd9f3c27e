// Triangulations that are best for measures of one's own: a function of a triangle, and one of two
// triangles across an edge.
//
//   example_own_measure points.csv
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>

#include "hodt/io/point_file.h"
#include "hodt/pipeline.h"

using hodt::Corner;

/// Twice the inradius by the circumradius: 1 for an equilateral triangle, 0 for none.
double radius_ratio(const Corner& a, const Corner& b, const Corner& c) {
  const double p = std::hypot(a.x - b.x, a.y - b.y);
  const double q = std::hypot(b.x - c.x, b.y - c.y);
  const double r = std::hypot(c.x - a.x, c.y - a.y);
  return std::max(0.0, (p + q - r) * (q + r - p) * (r + p - q)) / (p * q * r);
}

/// How far the surface bends along the edge ab, squared: the heights of l and r, above or below the
/// line through a and b, by their distances from it.
double squared_bend(const Corner& a, const Corner& b, const Corner& l, const Corner& r) {
  const double x = b.x - a.x, y = b.y - a.y, length = std::hypot(x, y);
  const auto slope = [&](const Corner& p) {
    const double along = ((p.x - a.x) * x + (p.y - a.y) * y) / (length * length);
    const double away = std::fabs((p.x - a.x) * y - (p.y - a.y) * x) / length;
    return away > 0 ? (p.z - a.z - along * (b.z - a.z)) / away : 0;
  };
  return std::pow(std::atan(slope(l)) + std::atan(slope(r)), 2);
}

void print(const hodt::PointSet& points, const hodt::Objective& objective) {
  const auto result = hodt::triangulate(points, {.order = 4, .objective = objective});
  const hodt::Value& value = *result.report.value;
  std::printf("%s: %g, Delaunay %g, at best %g%s\n", hodt::name_of(objective).c_str(), value.result,
              value.delaunay, value.bound, value.optimal ? " (reached)" : "");
}

int main(int argc, char** argv) try {
  if (argc != 2) return 2;
  const hodt::PointSet points = hodt::read_points(argv[1]);
  const hodt::OwnTriangleMeasure ratio{"radius-ratio", radius_ratio};
  const hodt::OwnEdgeMeasure bend{"squared-bend", squared_bend, /*needs_heights=*/true};
  print(points, {hodt::Direction::maximize, hodt::Aggregate::sum, ratio});
  print(points, {hodt::Direction::minimize, hodt::Aggregate::sum, bend});
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
