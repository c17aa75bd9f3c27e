#include "hodt/order/first_order.h"

#include "hodt/base/parallel.h"
#include "hodt/geometry/predicates.h"

namespace hodt {

namespace {

/// Whether the circle through the other corners of the quadrilateral with this diagonal, which
/// holds the diagonal's origin, holds nothing else: points inside a circle are connected in the
/// Delaunay graph, so it is enough to ask the origin's neighbours.
bool holds_only_origin(const DelaunayGraph& graph, const Circle& circle, HalfEdgeId diagonal) {
  const TriangleMesh& mesh = graph.mesh;
  const VertexId last_corner = mesh.target(mesh.rotate_cw(diagonal));
  HalfEdgeId h = mesh.rotate_ccw(diagonal);  // towards the first corner, seen from outside
  for (; h.valid() && mesh.apex(h) != last_corner; h = mesh.rotate_ccw(h))
    if (circle.contains(graph.point(mesh.apex(h)))) return false;
  if (h.valid()) return true;
  // The boundary was in the way: the others from the last corner backwards.
  for (h = mesh.rotate_cw(mesh.rotate_cw(diagonal)); h.valid(); h = mesh.rotate_cw(h))
    if (circle.contains(graph.point(mesh.target(h)))) return false;
  return true;
}

}  // namespace

bool is_first_order_flippable(const DelaunayGraph& graph, HalfEdgeId h) {
  const TriangleMesh& mesh = graph.mesh;
  if (mesh.is_boundary(h)) return false;
  // The diagonal u v crosses the edge s y; s is to the left of u v, so s, u, y, v go around.
  const VertexId s = mesh.origin(h), y = mesh.target(h);
  const VertexId v = mesh.apex(h), u = mesh.apex(mesh.twin(h));
  const Point &ps = graph.point(s), &py = graph.point(y), &pu = graph.point(u),
              &pv = graph.point(v);
  if (orient(pu, pv, ps) <= 0 || orient(pv, pu, py) <= 0) return false;  // not convex
  return holds_only_origin(graph, Circle(pu, pv, ps), mesh.twin(h)) &&
         holds_only_origin(graph, Circle(pv, pu, py), h);
}

std::vector<HalfEdgeId> first_order_edges(const DelaunayGraph& graph) {
  const TriangleMesh& mesh = graph.mesh;
  return parallel_collect<HalfEdgeId>(
      0, mesh.halfedge_count(), 1 << 14,
      [&](std::size_t first, std::size_t last, std::vector<HalfEdgeId>& found) {
        for (std::size_t i = first; i < last; ++i) {
          const HalfEdgeId h{Index(i)};
          if (h < mesh.twin(h) && is_first_order_flippable(graph, h)) found.push_back(h);
        }
      });
}

}  // namespace hodt
