#include "hodt/optimize/measures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "hodt/base/parallel.h"

namespace hodt {

namespace {

double squared(const Point& a, const Point& b) {
  const double x = b.x - a.x, y = b.y - a.y;
  return x * x + y * y;
}

double distance(const Point& a, const Point& b) {
  return std::sqrt(squared(a, b));
}

/// Twice the area.
double cross(const Point& a, const Point& b, const Point& c) {
  return std::fabs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

/// At a, in degrees.
double angle(const Point& a, const Point& b, const Point& c) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  const double dot = (b.x - a.x) * (c.x - a.x) + (b.y - a.y) * (c.y - a.y);
  return kDegrees * std::atan2(cross(a, b, c), dot);
}

double area(const Point& a, const Point& b, const Point& c) {
  return cross(a, b, c) / 2;
}

/// Opposite to the longest edge.
double largest_angle(const Point& a, const Point& b, const Point& c) {
  const double ab = squared(a, b), bc = squared(b, c), ca = squared(c, a);
  return bc >= ab && bc >= ca ? angle(a, b, c) : ca >= ab ? angle(b, c, a) : angle(c, a, b);
}

double smallest_angle(const Point& a, const Point& b, const Point& c) {
  const double ab = squared(a, b), bc = squared(b, c), ca = squared(c, a);
  return bc <= ab && bc <= ca ? angle(a, b, c) : ca <= ab ? angle(b, c, a) : angle(c, a, b);
}

double longest_edge(const Point& a, const Point& b, const Point& c) {
  return std::max({distance(a, b), distance(b, c), distance(c, a)});
}

double shortest_edge(const Point& a, const Point& b, const Point& c) {
  return std::min({distance(a, b), distance(b, c), distance(c, a)});
}

double circumradius(const Point& a, const Point& b, const Point& c) {
  return distance(a, b) * distance(b, c) * distance(c, a) / (2 * cross(a, b, c));
}

double enclosing_radius(const Point& a, const Point& b, const Point& c) {
  return largest_angle(a, b, c) >= 90 ? longest_edge(a, b, c) / 2 : circumradius(a, b, c);
}

double inradius(const Point& a, const Point& b, const Point& c) {
  return cross(a, b, c) / (distance(a, b) + distance(b, c) + distance(c, a));
}

/// The edges count half: each but those of the hull is in two triangles.
double half_perimeter(const Point& a, const Point& b, const Point& c) {
  return (distance(a, b) + distance(b, c) + distance(c, a)) / 2;
}

}  // namespace

double finite(double value) {
  constexpr double kLargest = 1e150;
  return std::isnan(value) ? 0 : std::min(value, kLargest);
}

double TriangleValues::of(VertexId u, VertexId v, VertexId w) const {
  return finite(measured(u, v, w));
}

double TriangleValues::measured(VertexId u, VertexId v, VertexId w) const {
  // The same bits whatever corner comes first. Sorted without branches.
  const Index first = std::min({u, v, w}), last = std::max({u, v, w});
  const Index middle = u ^ v ^ w ^ first ^ last;
  const Point &a = xy_[first], &b = xy_[middle], &c = xy_[last];
  switch (objective().measure) {
    case Measure::area:
      return area(a, b, c);
    case Measure::angle:
      return largest_angle(a, b, c);
    case Measure::small_angle:
      return smallest_angle(a, b, c);
    case Measure::circumradius:
      return circumradius(a, b, c);
    case Measure::enclosing_radius:
      return enclosing_radius(a, b, c);
    case Measure::inradius:
      return inradius(a, b, c);
    case Measure::length:
      return objective().aggregate == Aggregate::sum   ? half_perimeter(a, b, c)
             : objective().aggregate == Aggregate::max ? longest_edge(a, b, c)
                                                       : shortest_edge(a, b, c);
    case Measure::flat_area:
      return z_[u] == z_[v] && z_[v] == z_[w] ? area(a, b, c) : 0;
    case Measure::abn:
    case Measure::jnd:
    case Measure::wabn:
      break;  // of edges
  }
  return 0;
}

bool TriangleValues::better_pair(double a1, double a2, double b1, double b2) const {
  const double a = combine(a1, a2), b = combine(b1, b2);
  if (objective().aggregate == Aggregate::sum) {
    // What rounding can have made of equal sums is no gain.
    const double tiny = 1e-14 * (std::fabs(a1) + std::fabs(a2) + std::fabs(b1) + std::fabs(b2));
    return better(a, b) && std::fabs(a - b) > tiny;
  }
  if (a != b) return better(a, b);
  return better(a1 == a ? a2 : a1, b1 == b ? b2 : b1);
}

Buffer<double> TriangleValues::of_each(const TriangleMesh& mesh) const {
  Buffer<double> values(mesh.triangle_count());
  parallel_for(0, values.size(), 1 << 14, [&](std::size_t first, std::size_t last) {
    for (std::size_t t = first; t < last; ++t) {
      const auto [a, b, c] = mesh.corners(TriangleId(Index(t)));
      values[t] = of(a, b, c);
    }
  });
  return values;
}

double TriangleValues::of(const TriangleMesh& mesh, std::span<const double> each) const {
  double value = neutral();
  for (const double v : each) value = combine(value, v);
  if (objective().measure == Measure::length && objective().aggregate == Aggregate::sum)
    for (Index h = 0; h < mesh.halfedge_count(); ++h)
      if (mesh.is_boundary(HalfEdgeId(h)))
        value +=
            finite(distance(xy_[mesh.origin(HalfEdgeId(h))], xy_[mesh.target(HalfEdgeId(h))])) / 2;
  return value;
}

}  // namespace hodt
