#include "hodt/order/crossings.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "hodt/base/parallel.h"
#include "hodt/geometry/predicates.h"
#include "hodt/mesh/find_outgoing.h"
#include "hodt/order/segment_walk.h"

namespace hodt {

namespace {

/// Calls f for the triangles on both sides of the Delaunay edge uv; false if there is none.
template <class F>
bool for_each_beside(const DelaunayGraph& graph, const PlainEdge& edge, const F& f) {
  const HalfEdgeId side = find_edge(graph.mesh, graph.outgoing, edge.u, edge.v);
  if (!side.valid()) return false;
  for (const HalfEdgeId h : {side, graph.mesh.twin(side)})
    if (h.valid()) f(TriangleMesh::triangle(h));
  return true;
}

/// Calls f for the triangles that the edge passes through, or that it is a side of. Two edges that
/// cross have one in common.
template <class F>
void for_each_passed(const DelaunayGraph& graph, const PlainEdge& edge, const F& f) {
  if (for_each_beside(graph, edge, f)) return;
  HalfEdgeId last;
  for_each_crossed(graph.mesh, graph.xy, graph.outgoing.all(), edge.u, edge.v, [&](HalfEdgeId h) {
    f(TriangleMesh::triangle(h));
    last = graph.mesh.twin(h);
  });
  f(TriangleMesh::triangle(last));
}

bool are_apart(const Point& a, const Point& b, const Point& p, const Point& q) {
  return orient(a, b, p) * orient(a, b, q) < 0;
}

bool cross(const DelaunayGraph& graph, const PlainEdge& e, const PlainEdge& f) {
  if (e.u == f.u || e.u == f.v || e.v == f.u || e.v == f.v) return false;
  const Point &a = graph.point(e.u), &b = graph.point(e.v);
  const Point &p = graph.point(f.u), &q = graph.point(f.v);
  return are_apart(a, b, p, q) && are_apart(p, q, a, b);
}

}  // namespace

CsrLists crossings(const DelaunayGraph& graph, std::span<const PlainEdge> edges,
                   const Deadline& deadline) {
  using Pair = std::pair<Index, Index>;
  std::vector<Pair> passed = parallel_collect<Pair>(
      0, edges.size(), 1 << 10, [&](std::size_t first, std::size_t last, std::vector<Pair>& found) {
        for (std::size_t i = first; i < last; ++i) {
          deadline.check();
          for_each_passed(graph, edges[i], [&](TriangleId t) { found.emplace_back(Index(i), t); });
        }
      });
  const CsrLists triangles(edges.size(), passed, deadline);
  for (auto& [edge, triangle] : passed) std::swap(edge, triangle);
  const CsrLists through(graph.mesh.triangle_count(), passed, deadline);

  // Long edges meet in many triangles; each pair is asked about once.
  PerThread<Buffer<Index>> asked([&] { return Buffer<Index>(edges.size(), kNone); });
  const auto find = [&](std::size_t first, std::size_t last, std::vector<Pair>& found) {
    Buffer<Index>& asked_by = asked.mine();
    for (Index i = Index(first); i < last; ++i)
      for (const Index t : triangles[i]) {
        deadline.check();
        for (const Index j : through[t]) {
          if (j <= i || asked_by[j] == i) continue;
          asked_by[j] = i;
          if (!cross(graph, edges[i], edges[j])) continue;
          found.emplace_back(i, j);
          found.emplace_back(j, i);
        }
      }
  };
  return CsrLists(edges.size(), parallel_collect<Pair>(0, edges.size(), 1 << 8, find), deadline);
}

}  // namespace hodt
