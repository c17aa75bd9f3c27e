#include "hodt/tin/quality.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "hodt/base/parallel.h"

namespace hodt {

namespace {

/// Of one triangle.
struct Shape {
  double smallest_angle, largest_angle, radius_ratio, aspect_ratio;
};

/// The sides at a corner, in units of which none is out of range: products neither overflow nor
/// vanish because the whole triangle is huge or tiny.
struct Corner {
  double cross, dot;

  Corner(const Point& a, const Point& b, const Point& c, double unit) {
    const double ux = (b.x / 2 - a.x / 2) / unit, uy = (b.y / 2 - a.y / 2) / unit;
    const double vx = (c.x / 2 - a.x / 2) / unit, vy = (c.y / 2 - a.y / 2) / unit;
    cross = std::fabs(ux * vy - uy * vx);
    dot = ux * vx + uy * vy;
  }
  double angle() const { return std::atan2(cross, dot) * 180 / std::numbers::pi; }
};

double half_distance(const Point& p, const Point& q) {
  return std::hypot(p.x / 2 - q.x / 2, p.y / 2 - q.y / 2);
}

Shape shape_of(const Point& p, const Point& q, const Point& r) {
  std::array<double, 3> edges{half_distance(q, r), half_distance(r, p), half_distance(p, q)};
  const double unit = *std::max_element(edges.begin(), edges.end());
  const std::array<Corner, 3> corners{Corner(p, q, r, unit), Corner(q, r, p, unit),
                                      Corner(r, p, q, unit)};
  Shape shape{180, 0, 0, 0};
  double cross = 0, perimeter = 0, product = 1;
  for (int i = 0; i < 3; ++i) {
    shape.smallest_angle = std::min(shape.smallest_angle, corners[i].angle());
    shape.largest_angle = std::max(shape.largest_angle, corners[i].angle());
    // The same at all corners, but for rounding.
    cross = std::max(cross, corners[i].cross);
    perimeter += edges[i] / unit;
    product *= edges[i] / unit;
  }
  shape.smallest_angle = std::min(shape.smallest_angle, 60.0);
  shape.largest_angle = std::max(shape.largest_angle, 60.0);
  // The inradius is cross / perimeter, the circumradius product / (2 cross).
  const double ratio = 4 * cross / perimeter * (cross / product);
  shape.radius_ratio = ratio <= 1 ? ratio : ratio > 1 ? 1 : 0;
  // The longest edge is 1, the height above it cross.
  constexpr double equilateral = 2 / std::numbers::sqrt3;
  shape.aspect_ratio =
      cross > 0 ? std::max(1 / cross / equilateral, 1.0) : std::numeric_limits<double>::infinity();
  return shape;
}

constexpr std::size_t kGrain = 1 << 14;

Spread spread_of(std::span<const Shape> shapes, double Shape::*member) {
  std::vector<double> values(shapes.size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = shapes[i].*member;
  const double sum =
      parallel_sum(0, values.size(), kGrain, [&](std::size_t first, std::size_t last) {
        double part = 0;
        for (std::size_t i = first; i < last; ++i) part += values[i];
        return part;
      });
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  // The middle one; of an even number, the mean of both.
  const double lower = values.size() % 2 ? *middle : *std::max_element(values.begin(), middle);
  return {*std::min_element(values.begin(), values.end()),
          lower == *middle ? lower : lower / 2 + *middle / 2,
          sum / static_cast<double>(values.size()),
          *std::max_element(values.begin(), values.end())};
}

template <std::size_t bins>
void count_in_bin(std::array<std::size_t, bins>& counts, double above) {
  const auto bin = static_cast<std::size_t>(std::max(above, 0.0) / double(Quality::kBinWidth));
  ++counts[std::min(bin, bins - 1)];
}

}  // namespace

double angle_at(const Point& a, const Point& b, const Point& c) {
  const double unit = std::max({half_distance(a, b), half_distance(b, c), half_distance(c, a)});
  return Corner(a, b, c, unit).angle();
}

Quality quality_of(std::span<const Point> points, std::span<const std::array<Index, 3>> triangles) {
  Quality quality;
  if (triangles.empty()) return quality;
  std::vector<Shape> shapes(triangles.size());
  parallel_for(0, shapes.size(), kGrain, [&](std::size_t first, std::size_t last) {
    for (std::size_t t = first; t < last; ++t) {
      const auto& [a, b, c] = triangles[t];
      shapes[t] = shape_of(points[a], points[b], points[c]);
    }
  });
  for (const Shape& shape : shapes) {
    count_in_bin(quality.smallest_angles, shape.smallest_angle);
    count_in_bin(quality.largest_angles, shape.largest_angle - 60);
  }
  parallel_invoke(
      [&] {
        quality.smallest_angle = spread_of(shapes, &Shape::smallest_angle);
        quality.largest_angle = spread_of(shapes, &Shape::largest_angle);
      },
      [&] {
        quality.radius_ratio = spread_of(shapes, &Shape::radius_ratio);
        quality.aspect_ratio = spread_of(shapes, &Shape::aspect_ratio);
      });
  return quality;
}

}  // namespace hodt
