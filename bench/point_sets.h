// Point sets to time on: the same on every run.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "hodt/geometry/point.h"

namespace point_sets {

inline std::vector<hodt::Point> uniform(std::size_t n) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<hodt::Point> points(n);
  for (auto& p : points) p = {unit(random), unit(random)};
  return points;
}

inline std::vector<hodt::Point> lattice(std::size_t n) {
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(n)));
  std::vector<hodt::Point> points;
  for (std::size_t y = 0; y < side; ++y)
    for (std::size_t x = 0; x < side; ++x) points.push_back({double(x), double(y)});
  return points;
}

/// Normal clouds of very different sizes.
inline std::vector<hodt::Point> clustered(std::size_t n) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> unit(0, 1);
  std::normal_distribution<double> normal;
  struct Cloud {
    double x, y, size;
  };
  std::vector<Cloud> clouds;
  for (int i = 0; i < 40; ++i)
    clouds.push_back({unit(random), unit(random), std::pow(10, -4 * unit(random))});
  std::vector<hodt::Point> points(n);
  for (hodt::Point& p : points) {
    const Cloud& cloud = clouds[random() % clouds.size()];
    p = {cloud.x + cloud.size * normal(random), cloud.y + cloud.size * normal(random)};
  }
  return points;
}

/// Near a circle, off by one part in a hundred.
inline std::vector<hodt::Point> circle(std::size_t n) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> angle(0, 6.283185307179586);
  std::normal_distribution<double> normal(1, 0.01);
  std::vector<hodt::Point> points(n);
  for (hodt::Point& p : points) {
    const double a = angle(random), radius = normal(random);
    p = {radius * std::cos(a), radius * std::sin(a)};
  }
  return points;
}

/// Uniform in the disk of radius 1 around (0, 0), but for those that are nearer than `hole`.
inline std::vector<hodt::Point> annulus(std::size_t n, double hole) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> side(-1, 1);
  std::vector<hodt::Point> points;
  while (points.size() < n) {
    const double x = side(random), y = side(random), square = x * x + y * y;
    if (square <= 1 && square >= hole * hole) points.push_back({x, y});
  }
  return points;
}

inline std::vector<hodt::Point> disk(std::size_t n) {
  return annulus(n, 0);
}

/// Around an empty disk of half the radius.
inline std::vector<hodt::Point> ring(std::size_t n) {
  return annulus(n, 0.5);
}

/// At the corners of a square, the gaps as wide as a radius.
inline std::vector<hodt::Point> four_disks(std::size_t n) {
  std::vector<hodt::Point> points = disk(n);
  for (std::size_t i = 0; i < n; ++i) {
    points[i].x += i % 2 ? 3 : 0;
    points[i].y += i / 2 % 2 ? 3 : 0;
  }
  return points;
}

/// The corners of a regular polygon, rounded: on a circle as far as doubles can tell.
inline std::vector<hodt::Point> polygon(std::size_t n) {
  std::vector<hodt::Point> points(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double a = 6.283185307179586 * double(i) / double(n);
    points[i] = {std::cos(a), std::sin(a)};
  }
  return points;
}

/// The same with its centre.
inline std::vector<hodt::Point> wheel(std::size_t n) {
  std::vector<hodt::Point> points = polygon(n - 1);
  points.push_back({0, 0});
  return points;
}

/// A hub with all others around it, off a circle by one part in a thousand.
inline std::vector<hodt::Point> star(std::size_t n) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<hodt::Point> points(n);
  for (std::size_t i = 1; i < n; ++i) {
    const double a = 6.283185307179586 * unit(random), radius = 1 + 0.001 * unit(random);
    points[i] = {radius * std::cos(a), radius * std::sin(a)};
  }
  return points;
}

/// On the curve y = x².
inline std::vector<hodt::Point> parabola(std::size_t n) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> side(-1, 1);
  std::vector<hodt::Point> points(n);
  for (hodt::Point& p : points) {
    const double x = side(random);
    p = {x, x * x};
  }
  return points;
}

/// Along a spiral of ten turns, whatever n is.
inline std::vector<hodt::Point> spiral(std::size_t n) {
  std::vector<hodt::Point> points(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double part = double(i + 1) / double(n), a = 10 * 6.283185307179586 * part;
    points[i] = {part * std::cos(a), part * std::sin(a)};
  }
  return points;
}

/// On two parallel lines, one as long as they are apart.
inline std::vector<hodt::Point> two_lines(std::size_t n) {
  std::vector<hodt::Point> points = uniform(n);
  for (std::size_t i = 0; i < n; ++i) points[i].y = double(i % 2);
  return points;
}

/// On two lines that cross.
inline std::vector<hodt::Point> cross(std::size_t n) {
  std::vector<hodt::Point> points = uniform(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double along = 2 * points[i].x - 1;
    points[i] = i % 2 ? hodt::Point{along, 0} : hodt::Point{0, along};
  }
  return points;
}

/// On a quarter of a circle, off it by one part in a thousand, with its centre.
inline std::vector<hodt::Point> fan(std::size_t n) {
  std::vector<hodt::Point> points = uniform(n);
  for (hodt::Point& p : points) {
    const double a = 1.5707963267948966 * p.x, radius = 1 + 0.001 * p.y;
    p = {radius * std::cos(a), radius * std::sin(a)};
  }
  points[0] = {0, 0};
  return points;
}

/// Near a line, with a hub on either side.
inline std::vector<hodt::Point> two_hubs(std::size_t n) {
  std::vector<hodt::Point> points = uniform(n);
  for (hodt::Point& p : points) p = {p.x - 0.5, 1e-9 * p.y};
  points[0] = {0, 1e3};
  points[1] = {0, -1e3};
  return points;
}

/// Stars of √n points side by side, each with its hub.
inline std::vector<hodt::Point> stars(std::size_t n) {
  std::vector<hodt::Point> points = uniform(n);
  const auto width = static_cast<std::size_t>(std::sqrt(double(n))), row = width / 10 + 1;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t s = i / width;
    const double a = 6.283185307179586 * points[i].x;
    const double radius = i % width == 0 ? 0 : 1 + 0.001 * points[i].y;
    points[i] = {3 * double(s % row) + radius * std::cos(a),
                 3 * double(s / row) + radius * std::sin(a)};
  }
  return points;
}

/// Rounded corners of regular polygons around one centre, √n of them.
inline std::vector<hodt::Point> target(std::size_t n) {
  const auto rings = static_cast<std::size_t>(std::sqrt(double(n)));
  std::vector<hodt::Point> points(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double radius = 1 + double(i % rings) / double(rings);
    const double a = 6.283185307179586 * double(i / rings) / double(n / rings + 1);
    points[i] = {radius * std::cos(a), radius * std::sin(a)};
  }
  return points;
}

/// Along wavy contour lines, as far from each other as a hundred points of one.
inline std::vector<hodt::Point> contours(std::size_t n) {
  const double side = std::sqrt(double(n) / 100), step = 0.01;
  const auto a_line = static_cast<std::size_t>(side / step) + 1;
  std::vector<hodt::Point> points(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double x = step * double(i % a_line);
    points[i] = {x, double(i / a_line) + 0.3 * std::sin(2 * x)};
  }
  return points;
}

/// Uniform, but far wider than high.
inline std::vector<hodt::Point> flat(std::size_t n) {
  std::vector<hodt::Point> points = uniform(n);
  for (hodt::Point& p : points) p.y *= 1e-6;
  return points;
}

/// Uniform, at the ends of what doubles can tell.
inline std::vector<hodt::Point> stretched(std::size_t n) {
  std::vector<hodt::Point> points = uniform(n);
  for (hodt::Point& p : points) p = {1e150 * p.x, 1e-150 * p.y};
  return points;
}

/// Ever closer to one point, by powers: half of them in the inner half of what is left.
inline std::vector<hodt::Point> funnel(std::size_t n) {
  std::vector<hodt::Point> points = uniform(n);
  for (hodt::Point& p : points) {
    const double a = 6.283185307179586 * p.x, radius = std::exp(-40 * p.y);
    p = {radius * std::cos(a), radius * std::sin(a)};
  }
  return points;
}

/// Hills, and noise that is stronger, so that a share of all points are extrema however many there
/// are.
inline std::vector<double> heights(const std::vector<hodt::Point>& points) {
  std::mt19937_64 random(6);
  std::normal_distribution<double> normal;
  hodt::Point low = points.front(), high = low;
  for (const hodt::Point& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  std::vector<double> z;
  for (const hodt::Point& p : points)
    z.push_back(100 * std::sin(7 * (p.x - low.x) / (high.x - low.x)) *
                    std::cos(9 * (p.y - low.y) / (high.y - low.y)) +
                100 * normal(random));
  return z;
}

}  // namespace point_sets
