#include "hodt/optimize/measure/trivial_bound.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <variant>

namespace hodt {

namespace {

constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kMoreThanRounding = 1 + 1e-9;

/// The size of a box around the points.
Point extent(std::span<const Point> xy) {
  const auto by_x = [](const Point& p, const Point& q) { return p.x < q.x; };
  const auto by_y = [](const Point& p, const Point& q) { return p.y < q.y; };
  const auto [left, right] = std::minmax_element(xy.begin(), xy.end(), by_x);
  const auto [low, high] = std::minmax_element(xy.begin(), xy.end(), by_y);
  return {right->x - left->x, high->y - low->y};
}

/// No triangle in such a box measures more.
double largest_value(const TriangleMeasure& measure, const Point& extent) {
  const double diagonal = std::hypot(extent.x, extent.y);
  switch (measure.kind) {
    case TriangleMeasure::angle:
      return 180;
    case TriangleMeasure::small_angle:
      return 60;
    case TriangleMeasure::area:
    case TriangleMeasure::flat_area:
      return extent.x * extent.y;
    case TriangleMeasure::enclosing_radius:
    case TriangleMeasure::inradius:
      return diagonal;
    case TriangleMeasure::length:
      return 3 * diagonal;
    case TriangleMeasure::circumradius:
    case TriangleMeasure::own:
      break;
  }
  return kLargest;
}

/// No pair of triangles in such a box measures more.
double largest_value(const EdgeMeasure& measure, const Point& extent) {
  switch (measure.kind) {
    case EdgeMeasure::abn:
      return 180;
    case EdgeMeasure::wabn:
      return 180 * std::hypot(extent.x, extent.y);
    case EdgeMeasure::jnd:
    case EdgeMeasure::own:
      break;
  }
  return kLargest;
}

/// Triangles, or inner edges.
std::size_t values_in(const Objective& objective, const TriangleMesh& mesh) {
  if (!is_of_edges(objective)) return mesh.triangle_count();
  std::size_t inner_sides = 0;
  for (const Index twin : mesh.twins()) inner_sides += twin != kNone;
  return inner_sides / 2;
}

}  // namespace

double trivial_bound(const Objective& objective, std::span<const Point> xy,
                     const TriangleMesh& mesh) {
  if (objective.direction == Direction::minimize) return 0;  // no measure is negative
  const double count =
      objective.aggregate == Aggregate::sum ? double(values_in(objective, mesh)) : 1;
  const double largest = std::visit(
      [&](const auto& measure) { return largest_value(measure, extent(xy)); }, objective.measure);
  const double bound = count * largest * kMoreThanRounding;
  return std::min(bound, kLargest);
}

}  // namespace hodt
