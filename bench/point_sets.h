// Point sets to time on: the same on every run.
#pragma once

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

}  // namespace point_sets
