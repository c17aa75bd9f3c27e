#include "hodt/order/first_order.h"

#include "hodt/base/parallel.h"
#include "hodt/geometry/predicates.h"

namespace hodt {

namespace {

/// Whether the circle holds no neighbour of `inside` other than that point itself: points inside a
/// circle are connected in the Delaunay graph, so then it holds nothing else at all.
bool holds_only(const DelaunayGraph& graph, const Circle& circle, VertexId inside) {
  bool alone = true;
  graph.for_each_neighbour(inside, [&](VertexId v) {
    if (alone && circle.contains(graph.point(v))) alone = false;
  });
  return alone;
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
  return holds_only(graph, Circle(pu, pv, ps), y) && holds_only(graph, Circle(pv, pu, py), s);
}

std::vector<HalfEdgeId> first_order_edges(const DelaunayGraph& graph) {
  const TriangleMesh& mesh = graph.mesh;
  constexpr std::size_t kPiece = 1 << 14;
  const std::size_t pieces = (mesh.halfedge_count() + kPiece - 1) / kPiece;
  std::vector<std::vector<HalfEdgeId>> found(pieces);
  parallel_for(0, pieces, 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t piece = first; piece < last; ++piece) {
      const std::size_t end = std::min(mesh.halfedge_count(), (piece + 1) * kPiece);
      for (std::size_t i = piece * kPiece; i < end; ++i) {
        const HalfEdgeId h{Index(i)};
        if (h < mesh.twin(h) && is_first_order_flippable(graph, h)) found[piece].push_back(h);
      }
    }
  });
  std::vector<HalfEdgeId> all;
  for (const auto& piece : found) all.insert(all.end(), piece.begin(), piece.end());
  return all;
}

}  // namespace hodt
