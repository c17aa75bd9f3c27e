#include "hodt/order/voronoi/voronoi.h"

#include <algorithm>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/order/voronoi/voronoi_refinement.h"

namespace hodt {

namespace {

/// The Voronoi diagram: the dual of the Delaunay triangulation.
VoronoiDiagram first_order(const DelaunayGraph& graph) {
  VoronoiDiagram diagram;
  diagram.dual = graph.mesh;
  diagram.sites = Buffer<VertexId>(graph.mesh.halfedge_count());
  for (Index h = 0; h < diagram.sites.size(); ++h)
    diagram.sites[h] = graph.mesh.origin(HalfEdgeId(h));
  diagram.members = Buffer<VertexId>(graph.xy.size());
  for (Index v = 0; v < diagram.members.size(); ++v) diagram.members[v] = VertexId(v);
  return diagram;
}

}  // namespace

VoronoiDiagram voronoi_diagram(const DelaunayGraph& graph, Index order) {
  if (order < 1 || order >= graph.xy.size())
    throw ParameterError(
        fmt::format("the order of a Voronoi diagram must be at least 1 and less than the number of "
                    "distinct points, {}; not {}",
                    graph.xy.size(), order));
  VoronoiDiagram diagram = first_order(graph);
  while (diagram.order < order) diagram = VoronoiRefinement(graph.xy, diagram).run();
  return diagram;
}

std::vector<std::array<VertexId, 2>> bisector_pairs(const VoronoiDiagram& diagram) {
  std::vector<std::array<VertexId, 2>> pairs;
  for (Index i = 0; i < diagram.dual.halfedge_count(); ++i) {
    const HalfEdgeId h(i);
    const HalfEdgeId twin = diagram.dual.twin(h);
    if (twin.valid() && twin < h) continue;
    const VertexId u = diagram.sites[h], v = diagram.sites[TriangleMesh::next(h)];
    pairs.push_back({std::min(u, v), std::max(u, v)});
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace hodt
