#include "hodt/optimize/measure/edge_measures.h"

#include <algorithm>
#include <cmath>

#include "hodt/base/lanes.h"
#include "hodt/base/parallel.h"
#include "hodt/optimize/measure/angle.h"
#include "hodt/optimize/measure/measures.h"

namespace hodt {

namespace {

// What is measured across one edge, with the vector (x, y) along it, between planes with these
// gradients. All is inlined into loops over many edges (see measures.cpp).

using Gradient = EdgeValues::Gradient;
using G = const Gradient&;

/// Between the normals (-f, 1) and (-g, 1): their cross product is (g.y - f.y, f.x - g.x, f x g).
constexpr auto angle_of_normals = [](double, double, G f, G g) HODT_INLINE_LAMBDA {
  const double cross = f.x * g.y - f.y * g.x, u = g.y - f.y, v = f.x - g.x;
  return degrees(std::sqrt(u * u + v * v + cross * cross), f.x * g.x + f.y * g.y + 1);
};
constexpr auto weighted_angle = [](double x, double y, G f, G g) HODT_INLINE_LAMBDA {
  return std::sqrt(x * x + y * y) * angle_of_normals(x, y, f, g);
};
constexpr auto jump = [](double x, double y, G f, G g) HODT_INLINE_LAMBDA {
  return std::fabs((f.x - g.x) * y - (f.y - g.y) * x) / std::sqrt(x * x + y * y);
};

/// Calls f with the function of the measure.
template <class F>
void with_measure(Measure measure, const F& f) {
  if (measure == Measure::abn) return f(angle_of_normals);
  if (measure == Measure::wabn) return f(weighted_angle);
  f(jump);
}

}  // namespace

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
  double value = 0;
  const auto [x, y] = along(a, b);
  with_measure(objective().measure,
               [&, x = x, y = y](const auto& measure) { value = finite(measure(x, y, f, g)); });
  return value;
}

const double* ManyEdges::measure(std::size_t size, int left, int right) {
  const GradientColumns &f = left_[left], &g = right_[right];
  Column& value = value_[left][right];
  with_measure(values_.objective().measure, [&](const auto& measure) {
    run_in_lanes([&]<Index>() HODT_INLINE_LAMBDA {
      for (std::size_t i = 0; i < size; ++i)
        value[i] = finite(measure(x_[i], y_[i], {f.x[i], f.y[i]}, {g.x[i], g.y[i]}));
    });
  });
  return value.data();
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
