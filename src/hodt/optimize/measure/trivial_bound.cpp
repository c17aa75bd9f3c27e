#include "hodt/optimize/measure/trivial_bound.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <variant>
#include <vector>

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

double no_value_exceeds(const Objective& objective, std::span<const Point> xy,
                        const TriangleMesh& mesh) {
  const double count =
      objective.aggregate == Aggregate::sum ? double(values_in(objective, mesh)) : 1;
  const double largest = std::visit(
      [&](const auto& measure) { return largest_value(measure, extent(xy)); }, objective.measure);
  return std::min(count * largest * kMoreThanRounding, kLargest);
}

/// How far the nearest other vertex is from each, which is a neighbour in the Delaunay
/// triangulation. No edge of any triangulation is shorter than that at either end.
std::vector<double> nearest_distances(std::span<const Point> xy, const TriangleMesh& delaunay) {
  std::vector<double> nearest(xy.size(), kLargest);
  for (HalfEdgeId h(0); h < delaunay.halfedge_count(); h = HalfEdgeId(h + 1)) {
    const VertexId u = delaunay.origin(h), v = delaunay.target(h);
    const double distance = std::hypot(xy[u].x - xy[v].x, xy[u].y - xy[v].y);
    nearest[u] = std::min(nearest[u], distance);
    nearest[v] = std::min(nearest[v], distance);
  }
  return nearest;
}

/// The perimeters of all triangles of any triangulation sum up to no less. A side is at least half
/// as long as the nearest distances at its ends together, so a perimeter is no less than those at
/// the corners are; and a vertex is the corner of three triangles at least, or of one on the hull.
double least_perimeters(std::span<const double> nearest, const TriangleMesh& mesh) {
  std::vector<bool> is_on_hull(nearest.size(), false);
  for (HalfEdgeId h(0); h < mesh.halfedge_count(); h = HalfEdgeId(h + 1))
    if (mesh.is_boundary(h)) is_on_hull[mesh.origin(h)] = true;
  double sum = 0;
  for (std::size_t v = 0; v < nearest.size(); ++v) sum += nearest[v] * (is_on_hull[v] ? 1 : 3);
  return sum;
}

/// The longest sides of all triangles of any triangulation, in sum, or the longest or the shortest
/// of them, are no less.
double least_longest_sides(Aggregate aggregate, std::span<const Point> xy,
                           const TriangleMesh& delaunay) {
  const std::vector<double> nearest = nearest_distances(xy, delaunay);
  switch (aggregate) {
    case Aggregate::sum:
      return least_perimeters(nearest, delaunay) / 3;
    case Aggregate::max:
      return *std::max_element(nearest.begin(), nearest.end());
    case Aggregate::min:
      break;
  }
  return *std::min_element(nearest.begin(), nearest.end());
}

double all_values_reach(const Objective& objective, std::span<const Point> xy,
                        const TriangleMesh& delaunay) {
  const auto* const measure = std::get_if<TriangleMeasure>(&objective.measure);
  if (measure == nullptr) return 0;
  const auto longest_sides = [&] { return least_longest_sides(objective.aggregate, xy, delaunay); };
  switch (measure->kind) {
    case TriangleMeasure::angle:
      return objective.aggregate == Aggregate::sum ? 60 * double(delaunay.triangle_count()) : 60;
    case TriangleMeasure::length:  // a sum counts half of a perimeter
      return is_total_length(objective) ? longest_sides() * 3 / 2 : longest_sides();
    case TriangleMeasure::circumradius:
    case TriangleMeasure::enclosing_radius:
      return longest_sides() / 2;
    case TriangleMeasure::area:
    case TriangleMeasure::small_angle:
    case TriangleMeasure::inradius:
    case TriangleMeasure::flat_area:
    case TriangleMeasure::own:
      break;
  }
  return 0;
}

}  // namespace

double trivial_bound(const Objective& objective, std::span<const Point> xy,
                     const TriangleMesh& delaunay) {
  if (objective.direction == Direction::maximize) return no_value_exceeds(objective, xy, delaunay);
  // Sums of tiny values are exact to no relative error.
  constexpr double kTiny = 1e-290;
  const double least = all_values_reach(objective, xy, delaunay);
  return kTiny <= least && least <= kLargest ? least / kMoreThanRounding : 0;  // none is negative
}

}  // namespace hodt
