#include "hodt/optimize/extrema/order_repair.h"

#include <algorithm>
#include <vector>

#include "hodt/order/circle_counter.h"

namespace hodt {

namespace {

/// Of the locked edges, the one fewest triangles away from t. There is one, or else all triangles
/// would be Delaunay.
void release_nearest(ConstrainedTriangulation& triangulation, TriangleId t) {
  const TriangleMesh& mesh = triangulation.mesh();
  std::vector<TriangleId> seen{t};
  for (std::size_t i = 0; i < seen.size(); ++i)
    for (Index side = 0; side < 3; ++side) {
      const HalfEdgeId h(TriangleMesh::halfedge(seen[i]) + side);
      const VertexId a = mesh.origin(h), b = mesh.target(h);
      if (triangulation.is_locked(a, b))
        return triangulation.release(triangulation.partner(a) == b ? a : b);
      if (mesh.is_boundary(h)) continue;
      const TriangleId next = TriangleMesh::triangle(mesh.twin(h));
      if (std::find(seen.begin(), seen.end(), next) == seen.end()) seen.push_back(next);
    }
}

}  // namespace

void release_where_order_is_too_high(const DelaunayGraph& graph, Index order,
                                     const Deadline& deadline,
                                     ExtremaTriangulation& triangulation) {
  CircleCounter counter(graph);
  triangulation.edit([&](ConstrainedTriangulation& edges) {
    for (bool released = true; released;) {
      released = false;
      for (Index i = 0; i < edges.mesh().triangle_count(); ++i) {
        const TriangleId t(i);
        if (edges.is_original(t)) continue;
        deadline.check();
        const auto [a, b, c] = edges.mesh().corners(t);
        if (counter.count(a, b, c, order) <= order) continue;
        release_nearest(edges, t);
        released = true;
      }
    }
  });
}

}  // namespace hodt
