// Level water over one triangle of a terrain.
// Tested by tests/hydrology/pit_water_test.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "hodt/geometry/point.h"
#include "hodt/mesh/triangle_mesh.h"

namespace hodt {

/// A volume of water, of how far the water has risen above some level, in a unit of its own.
struct Rise {
  std::array<double, 4> of_power{};

  Rise& operator+=(const Rise& other) {
    for (int i = 0; i < 4; ++i) of_power[i] += other.of_power[i];
    return *this;
  }
  /// The same volume, counted from so much further up.
  Rise from(double up) const {
    const auto& [a, b, c, d] = of_power;
    return {{a + up * (b + up * (c + up * d)), b + up * (2 * c + up * 3 * d), c + up * 3 * d, d}};
  }
};

class WetTriangle {
 public:
  WetTriangle(const TriangleMesh& mesh, TriangleId t, std::span<const Point> xy,
              std::span<const double> z) {
    std::array<VertexId, 3> corner = mesh.corners(t);
    std::sort(corner.begin(), corner.end(), [&](VertexId u, VertexId v) { return z[u] < z[v]; });
    const Point &a = xy[corner[0]], &b = xy[corner[1]], &c = xy[corner[2]];
    area_ = std::fabs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
    low_ = z[corner[0]];
    middle_ = z[corner[1]];
    high_ = z[corner[2]];
  }

  /// 0 if it is dry.
  double volume(double level) const {
    if (level <= low_) return 0;
    return area_ * mean_depth(level - low_, level - middle_, level - high_);
  }

  /// The volume above a level that is higher than the lowest corner, as far as the next corner.
  /// Within that range nothing cancels, in sums of many neither: where a coefficient is negative,
  /// the one before outweighs it.
  Rise rise(double level, double unit) const {
    const double a = level - low_, b = level - middle_, c = high_ - level;
    const double v = volume(level);
    const double at_once = area_ * unit;
    if (c <= 0) return {{v, at_once, 0, 0}};
    const double whole = high_ - low_, part = b < 0 ? middle_ - low_ : high_ - middle_;
    const double last = at_once / 3 * (unit / part) * (unit / whole);
    if (b < 0)
      return {{v, at_once * (a / part) * (a / whole), at_once * (a / part) * (unit / whole), last}};
    return {{v, at_once * ((a + b) / whole * (c / part) + (a / whole) * (b / part)),
             at_once * (c / part) * (unit / whole), -last}};
  }

  /// The next corner's height above the level; infinity if there is none.
  double next_corner(double level) const {
    if (level < middle_) return middle_;
    return level < high_ ? high_ : std::numeric_limits<double>::infinity();
  }

 private:
  /// The mean over the triangle of the depth, which is linear, counted as 0 where it is negative.
  /// The depths at the corners are sorted, the largest first and positive. Sums of products that
  /// are not negative: nothing cancels, however thin the wedge.
  static double mean_depth(double a, double b, double c) {
    if (c >= 0) return (a + b + c) / 3;
    const double along_ac = a / (a - c);  // the share of that side that is under water
    if (b <= 0) return a / 3 * along_ac * (a / (a - b));
    const double along_bc = b / (b - c);
    return ((a + b) * along_bc + a * along_ac * (1 - along_bc)) / 3;
  }

  double area_;
  double low_, middle_, high_;
};

}  // namespace hodt
