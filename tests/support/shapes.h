// Large point sets: what the families are at forty points, at thousands.
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include "families.h"

#include "hodt/geometry/point_set.h"

namespace support {

using Points = std::vector<hodt::Point>;

inline Points uniform(std::size_t n, std::uint64_t seed) {
  families::Random random(seed);
  Points points(n);
  for (auto& p : points) {
    p.x = random.real();
    p.y = random.real();
  }
  return points;
}

/// Clusters of all sizes from 1 down to 1e-6, each dense in its middle.
inline Points clustered(std::size_t n, std::uint64_t seed) {
  families::Random random(seed);
  struct Cluster {
    double x, y, size;
  };
  std::vector<Cluster> clusters;
  for (int i = 0; i < 40; ++i) {
    const double x = random.real(), y = random.real();
    clusters.push_back({x, y, std::pow(10, random.real(-6, 0))});
  }
  Points points(n);
  for (auto& p : points) {
    const Cluster& c = clusters[random.bits() % clusters.size()];
    const double reach = c.size * std::pow(random.real(), 3);
    const double angle = random.real(0, 2 * std::numbers::pi);
    p = {c.x + reach * std::cos(angle), c.y + reach * std::sin(angle)};
  }
  return points;
}

/// In the order of rows, as rasters are; `place` maps column and row to a coordinate pair.
inline Points grid(int columns, int rows, const std::function<hodt::Point(int, int)>& place) {
  Points points;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) points.push_back(place(column, row));
  return points;
}

inline Points lattice(int columns, int rows) {
  return grid(columns, rows, [](int i, int j) { return hodt::Point{double(i), double(j)}; });
}

/// A raster of 10.3 m cells in UTM coordinates with two decimals: ties by the thousand in decimal,
/// most of them broken by rounding to binary.
inline Points utm_lattice(int columns, int rows) {
  return grid(columns, rows, [](int i, int j) {
    return hodt::Point{(66473705.0 + 1030.0 * i) / 100, (489578259.0 - 1030.0 * j) / 100};
  });
}

inline Points noisy_lattice(int columns, int rows, double noise, std::uint64_t seed) {
  families::Random random(seed);
  return grid(columns, rows, [&](int i, int j) {
    const double x = i + random.real(-noise, noise);
    return hodt::Point{x, j + random.real(-noise, noise)};
  });
}

/// A lattice whose step is one unit in the last place of its coordinates.
inline Points lattice_of_ulps(int columns, int rows) {
  constexpr double kUlp = std::numeric_limits<double>::epsilon();
  return grid(columns, rows, [](int i, int j) { return hodt::Point{1 + i * kUlp, 1 + j * kUlp}; });
}

/// Points with integer coordinates on x² + y² = 32045 * 65² and its centre, and the same circle
/// again around other places: all cocircular, circle by circle.
inline Points cocircular_rings(int rings) {
  constexpr int kScale = 65, kRadiusSquared = 32045 * kScale * kScale;
  Points points;
  for (int ring = 0; ring < rings; ++ring) {
    const double shift = 25000.0 * ring;
    points.push_back({shift, 0});
    for (int x = -11640; x <= 11640; ++x) {
      const int rest = kRadiusSquared - x * x;
      if (rest < 0) continue;
      const int y = static_cast<int>(std::lround(std::sqrt(rest)));
      if (y * y != rest) continue;
      points.push_back({shift + x, double(y)});
      if (y != 0) points.push_back({shift + x, double(-y)});
    }
  }
  return points;
}

/// Heights like a terrain's: a few hills, rough at all scales, rounded so that many are equal.
inline std::vector<double> rough_heights(const Points& points, double step, std::uint64_t seed) {
  families::Random random(seed);
  double low_x = points[0].x, high_x = low_x, low_y = points[0].y, high_y = low_y;
  for (const auto& p : points) {
    low_x = std::min(low_x, p.x), high_x = std::max(high_x, p.x);
    low_y = std::min(low_y, p.y), high_y = std::max(high_y, p.y);
  }
  std::vector<double> z;
  for (const auto& p : points) {
    const double x = (p.x - low_x) / (high_x - low_x), y = (p.y - low_y) / (high_y - low_y);
    const double hills = 100 * std::sin(7 * x + 3 * y) + 60 * std::cos(11 * y - 5 * x);
    z.push_back(std::round((hills + random.real(-10, 10)) / step) * step);
  }
  return z;
}

inline Points shuffled(Points points, std::uint64_t seed) {
  families::Random(seed).shuffle(points);
  return points;
}

struct Shape {
  std::string name;
  std::function<Points()> make;
};

/// The name that GoogleTest gives a test of this shape.
inline void PrintTo(const Shape& shape, std::ostream* out) {
  *out << shape.name;
}

}  // namespace support
