// What a triangle, or two across an edge, measure: from the definitions, in extended precision,
// with no thought of speed or of numbers out of range.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "hodt/optimize/objective.h"

namespace support {

using Real = long double;  // for small coordinates: no rounding to speak of

struct Place {
  Real x, y, z;
};

inline Real distance(const Place& a, const Place& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

inline Real degrees(Real sine, Real cosine) {
  return std::atan2(sine, cosine) * 180 / std::acos(Real(-1));
}

/// Of a built-in measure. A sum of lengths gets half of the perimeter: all edges inside count once
/// then, and those of the boundary half.
inline Real measure_by_definition(hodt::TriangleMeasure::Kind kind, hodt::Aggregate aggregate,
                                  const Place& a, const Place& b, const Place& c) {
  using hodt::Aggregate;
  using hodt::TriangleMeasure;
  const Real area = std::fabs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
  std::array<Real, 3> s{distance(a, b), distance(b, c), distance(c, a)};
  std::sort(s.begin(), s.end());
  const auto angle_beside = [&](Real opposite, Real p, Real q) {
    return degrees(2 * area, (p * p + q * q - opposite * opposite) / 2);
  };
  const Real radius = s[0] * s[1] * s[2] / (4 * area);
  switch (kind) {
    case TriangleMeasure::area:
      return area;
    case TriangleMeasure::angle:
      return angle_beside(s[2], s[0], s[1]);
    case TriangleMeasure::small_angle:
      return angle_beside(s[0], s[1], s[2]);
    case TriangleMeasure::circumradius:
      return radius;
    case TriangleMeasure::enclosing_radius:
      return s[0] * s[0] + s[1] * s[1] <= s[2] * s[2] ? s[2] / 2 : radius;
    case TriangleMeasure::inradius:
      return 2 * area / (s[0] + s[1] + s[2]);
    case TriangleMeasure::length:
      return aggregate == Aggregate::sum   ? (s[0] + s[1] + s[2]) / 2
             : aggregate == Aggregate::max ? s[2]
                                           : s[0];
    case TriangleMeasure::flat_area:
      return a.z == b.z && b.z == c.z ? area : 0;
    case TriangleMeasure::own:
      break;
  }
  return 0;
}

/// Of a built-in measure of the edge ab between the triangles abl and bar.
inline Real measure_by_definition(hodt::EdgeMeasure::Kind kind, const Place& a, const Place& b,
                                  const Place& l, const Place& r) {
  using Vector = std::array<Real, 3>;
  const auto normal = [](const Place& p, const Place& q, const Place& s) {
    const Vector u{q.x - p.x, q.y - p.y, q.z - p.z}, v{s.x - p.x, s.y - p.y, s.z - p.z};
    return Vector{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  };
  const Vector m = normal(a, b, l), n = normal(b, a, r);
  if (kind == hodt::EdgeMeasure::jnd) {
    const Real x = (b.y - a.y) / distance(a, b), y = (a.x - b.x) / distance(a, b);
    return std::fabs((m[0] / m[2] - n[0] / n[2]) * x + (m[1] / m[2] - n[1] / n[2]) * y);
  }
  const Vector cross{m[1] * n[2] - m[2] * n[1], m[2] * n[0] - m[0] * n[2],
                     m[0] * n[1] - m[1] * n[0]};
  const Real sine = std::sqrt(cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2]);
  const Real angle = degrees(sine, m[0] * n[0] + m[1] * n[1] + m[2] * n[2]);
  return kind == hodt::EdgeMeasure::abn ? angle : distance(a, b) * angle;
}

}  // namespace support
