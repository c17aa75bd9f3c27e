#include "hodt/optimize/edge_measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "hodt/optimize/measures.h"

namespace hodt {

/// Of the plane through the three points.
EdgeValues::Gradient EdgeValues::gradient(VertexId a, VertexId b, VertexId c) const {
  const double bx = xy_[b].x - xy_[a].x, by = xy_[b].y - xy_[a].y, bz = z_[b] - z_[a];
  const double cx = xy_[c].x - xy_[a].x, cy = xy_[c].y - xy_[a].y, cz = z_[c] - z_[a];
  const double area = bx * cy - by * cx;
  return {(bz * cy - by * cz) / area, (bx * cz - bz * cx) / area};
}

double EdgeValues::of(VertexId a, VertexId b, VertexId c, VertexId d) const {
  if (b < a) {
    std::swap(a, b);
    std::swap(c, d);
  }
  constexpr double kDegrees = 180 / std::numbers::pi;
  const Gradient f = gradient(a, b, c), g = gradient(b, a, d);
  const double x = xy_[b].x - xy_[a].x, y = xy_[b].y - xy_[a].y;
  const double length = std::sqrt(x * x + y * y);
  const auto angle = [&] {
    // Of the normals (-f, 1) and (-g, 1): their cross product is (g.y - f.y, f.x - g.x, f × g).
    const double cross = f.x * g.y - f.y * g.x, u = g.y - f.y, v = f.x - g.x;
    return kDegrees *
           std::atan2(std::sqrt(u * u + v * v + cross * cross), f.x * g.x + f.y * g.y + 1);
  };
  switch (objective().measure) {
    case Measure::abn:
      return finite(angle());
    case Measure::wabn:
      return finite(length * angle());
    case Measure::jnd:
      return finite(std::fabs((f.x - g.x) * y - (f.y - g.y) * x) / length);
    default:
      return 0;  // of triangles
  }
}

double EdgeValues::of(const TriangleMesh& mesh) const {
  double value = neutral();
  bool any = false;
  for_each_inner_edge(mesh, [&](HalfEdgeId h) {
    value = combine(value, of(mesh, h));
    any = true;
  });
  return any ? value : 0;
}

}  // namespace hodt
