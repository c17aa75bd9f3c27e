#include "hodt/mesh/triangle_mesh.h"

namespace hodt {

HalfEdgeId TriangleMesh::flip(HalfEdgeId h) {
  const HalfEdgeId g = twin(h);
  const HalfEdgeId hn = next(h), gn = next(g);
  const HalfEdgeId outside_bc = twin(hn), outside_ad = twin(gn);
  const VertexId c = apex(h), d = apex(g);
  // (a, b, c) and (b, a, d) become (a, d, c) and (b, c, d); prev(h) and prev(g) stay as they are.
  set_origin(hn, d);
  set_origin(gn, c);
  glue(h, outside_ad);
  glue(g, outside_bc);
  glue(hn, gn);
  return hn;
}

Buffer<HalfEdgeId> outgoing_halfedges(const TriangleMesh& mesh) {
  Buffer<HalfEdgeId> outgoing(mesh.vertex_count(), HalfEdgeId());
  // The first of each vertex, and after these what is on the boundary: a branch on whether there is
  // one already would go the wrong way for every vertex.
  const auto count = static_cast<Index>(mesh.halfedge_count());
  for (Index i = count; i-- > 0;) outgoing[mesh.origin(HalfEdgeId(i))] = HalfEdgeId(i);
  for (Index i = 0; i < count; ++i)
    if (const HalfEdgeId h(i); mesh.is_boundary(h)) outgoing[mesh.origin(h)] = h;
  return outgoing;
}

}  // namespace hodt
