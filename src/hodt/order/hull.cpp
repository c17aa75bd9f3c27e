#include "hodt/order/hull.h"

#include <cstddef>

#include "hodt/order/emptiest.h"
#include "hodt/order/segment_walk.h"

namespace hodt {
namespace {

using Triangles = std::vector<std::array<VertexId, 3>>;

/// Triangulates between a chain and the edge from its first vertex to its last, which has the chain
/// on its left. All vertices between two that have become joined are on the left of that new edge,
/// although the chain may turn back: each sees a point of the first edge, and these points are in
/// the order of the chain.
void triangulate_beside(const DelaunayGraph& graph, const std::vector<VertexId>& chain,
                        Triangles& triangles) {
  struct Part {
    std::size_t first, last;
  };
  std::vector<Part> parts{{0, chain.size() - 1}};  // not recursion: chains can be long
  while (!parts.empty()) {
    const auto [first, last] = parts.back();
    parts.pop_back();
    if (last - first < 2) continue;
    const std::size_t best = emptiest(graph.xy, chain, first, last);
    triangles.push_back({chain[first], chain[last], chain[best]});
    parts.push_back({best, last});
    parts.push_back({first, best});
  }
}

}  // namespace

Hull hull_of_edge(const DelaunayGraph& graph, VertexId u, VertexId v) {
  Hull hull;
  if (graph.has_edge(u, v)) return hull;
  const TriangleMesh& mesh = graph.mesh;
  const HalfEdgeId first = first_crossed(mesh, graph.xy, graph.outgoing[u], u, v);
  hull.triangles.push_back(TriangleMesh::triangle(first));
  hull.right.push_back(mesh.origin(first));
  hull.left.push_back(mesh.target(first));
  for (HalfEdgeId h = first; h.valid();) {
    const HalfEdgeId across = mesh.twin(h);
    hull.triangles.push_back(TriangleMesh::triangle(across));
    h = next_crossed(mesh, graph.xy, h, u, v);
    if (!h.valid()) break;
    // The next edge has the new vertex for its left end, or for its right one.
    const bool new_is_left = h == TriangleMesh::next(across);
    (new_is_left ? hull.left : hull.right).push_back(mesh.apex(across));
  }
  return hull;
}

std::vector<std::array<VertexId, 3>> greedy_triangulation(const DelaunayGraph& graph, VertexId u,
                                                          VertexId v) {
  const Hull hull = hull_of_edge(graph, u, v);
  Triangles triangles;
  if (hull.triangles.empty()) return triangles;
  triangles.reserve(hull.triangles.size());
  std::vector<VertexId> chain{u};
  chain.insert(chain.end(), hull.left.begin(), hull.left.end());
  chain.push_back(v);
  triangulate_beside(graph, chain, triangles);
  chain.assign({v});
  chain.insert(chain.end(), hull.right.rbegin(), hull.right.rend());
  chain.push_back(u);
  triangulate_beside(graph, chain, triangles);
  return triangles;
}

}  // namespace hodt
