#include "hodt/optimize/edge_measures.h"

#include <algorithm>
#include <cmath>

#include "hodt/base/parallel.h"
#include "hodt/optimize/angle.h"
#include "hodt/optimize/measures.h"

namespace hodt {

EdgeValues::Gradient EdgeValues::gradient(VertexId u, VertexId v, VertexId w) const {
  // Sorted without branches.
  const Index a = std::min({u, v, w}), c = std::max({u, v, w}), b = u ^ v ^ w ^ a ^ c;
  const double bx = xy_[b].x - xy_[a].x, by = xy_[b].y - xy_[a].y, bz = z_[b] - z_[a];
  const double cx = xy_[c].x - xy_[a].x, cy = xy_[c].y - xy_[a].y, cz = z_[c] - z_[a];
  const double area = bx * cy - by * cx;
  return {(bz * cy - by * cz) / area, (bx * cz - bz * cx) / area};
}

Buffer<EdgeValues::Gradient> EdgeValues::gradients(const TriangleMesh& mesh) const {
  Buffer<Gradient> all(mesh.triangle_count());
  parallel_for(0, all.size(), 1 << 14, [&](std::size_t first, std::size_t last) {
    for (std::size_t t = first; t < last; ++t) {
      const auto [a, b, c] = mesh.corners(TriangleId(Index(t)));
      all[t] = gradient(a, b, c);
    }
  });
  return all;
}

double EdgeValues::across(VertexId a, VertexId b, const Gradient& f, const Gradient& g) const {
  const double x = xy_[b].x - xy_[a].x, y = xy_[b].y - xy_[a].y;
  const auto length = [&] { return std::sqrt(x * x + y * y); };
  const auto angle = [&] {
    // Of the normals (-f, 1) and (-g, 1): their cross product is (g.y - f.y, f.x - g.x, f × g).
    const double cross = f.x * g.y - f.y * g.x, u = g.y - f.y, v = f.x - g.x;
    return degrees(std::sqrt(u * u + v * v + cross * cross), f.x * g.x + f.y * g.y + 1);
  };
  switch (objective().measure) {
    case Measure::abn:
      return finite(angle());
    case Measure::wabn:
      return finite(length() * angle());
    case Measure::jnd:
      return finite(std::fabs((f.x - g.x) * y - (f.y - g.y) * x) / length());
    default:
      return 0;  // of triangles
  }
}

double EdgeValues::of(const TriangleMesh& mesh) const {
  const Buffer<Gradient> all = gradients(mesh);
  double value = neutral();
  bool any = false;
  for_each_inner_edge(mesh, [&](HalfEdgeId h) {
    value = combine(value, across(mesh.origin(h), mesh.target(h), all[TriangleMesh::triangle(h)],
                                  all[TriangleMesh::triangle(mesh.twin(h))]));
    any = true;
  });
  return any ? value : 0;
}

}  // namespace hodt
