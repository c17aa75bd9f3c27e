#include "hodt/order/crossings.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "hodt/base/parallel.h"
#include "hodt/geometry/predicates.h"
#include "hodt/order/segment_walk.h"

namespace hodt {

namespace {

/// Calls f for the triangles on both sides of the Delaunay edge uv; false if there is none.
template <class F>
bool for_each_beside(const DelaunayGraph& graph, const PlainEdge& edge, const F& f) {
  const TriangleMesh& mesh = graph.mesh;
  bool found = false;
  for_each_outgoing(mesh, graph.outgoing[edge.u], [&](HalfEdgeId h) {
    if (mesh.target(h) != edge.v && mesh.apex(h) != edge.v) return;
    f(TriangleMesh::triangle(h));
    found = true;
  });
  return found;
}

/// Calls f for the triangles that the edge passes through, or that it is a side of. Two edges that
/// cross have one in common.
template <class F>
void for_each_passed(const DelaunayGraph& graph, const PlainEdge& edge, const F& f) {
  if (for_each_beside(graph, edge, f)) return;
  VertexId last;
  for_each_crossed(graph.mesh, graph.xy, graph.outgoing[edge.u], edge.u, edge.v, [&](HalfEdgeId h) {
    f(TriangleMesh::triangle(h));
    last = VertexId(graph.mesh.twin(h));
  });
  f(TriangleMesh::triangle(HalfEdgeId(last)));
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

Lists crossings(const DelaunayGraph& graph, std::span<const PlainEdge> edges) {
  using Pair = std::pair<Index, Index>;
  std::vector<Pair> passed = parallel_collect<Pair>(
      0, edges.size(), 1 << 10, [&](std::size_t first, std::size_t last, std::vector<Pair>& found) {
        for (std::size_t i = first; i < last; ++i)
          for_each_passed(graph, edges[i], [&](TriangleId t) { found.emplace_back(Index(i), t); });
      });
  const Lists triangles(edges.size(), passed);
  for (auto& [edge, triangle] : passed) std::swap(edge, triangle);
  const Lists through(graph.mesh.triangle_count(), passed);

  // Long edges meet in many triangles; each pair is asked about once.
  PerThread<Buffer<Index>> asked([&] { return Buffer<Index>(edges.size(), kNone); });
  return Lists(edges.size(), parallel_collect<Pair>(0, edges.size(), 1 << 8,
                                                    [&](std::size_t first, std::size_t last,
                                                        std::vector<Pair>& found) {
                                                      Buffer<Index>& asked_by = asked.mine();
                                                      for (Index i = Index(first); i < last; ++i)
                                                        for (const Index t : triangles[i])
                                                          for (const Index j : through[t]) {
                                                            if (j <= i || asked_by[j] == i)
                                                              continue;
                                                            asked_by[j] = i;
                                                            if (!cross(graph, edges[i], edges[j]))
                                                              continue;
                                                            found.emplace_back(i, j);
                                                            found.emplace_back(j, i);
                                                          }
                                                    }));
}

}  // namespace hodt
