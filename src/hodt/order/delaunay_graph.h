// The Delaunay triangulation as the graph that every question about orders is answered on.
#pragma once

#include <span>

#include "hodt/delaunay/delaunay.h"
#include "hodt/geometry/circle.h"
#include "hodt/mesh/triangle_mesh.h"

namespace hodt {

/// A view: the Delaunay triangulation must outlive it and stay as it is.
struct DelaunayGraph {
  explicit DelaunayGraph(const Delaunay& delaunay)
      : xy(delaunay.vertices.xy),
        mesh(delaunay.mesh),
        outgoing(outgoing_halfedges(delaunay.mesh)) {}

  const Point& point(VertexId v) const { return xy[v]; }
  template <class F>
  void for_each_neighbour(VertexId v, const F& f) const {
    hodt::for_each_neighbour(mesh, outgoing[v], f);
  }

  std::span<const Point> xy;
  const TriangleMesh& mesh;
  Buffer<HalfEdgeId> outgoing;  ///< as outgoing_halfedges gives it
};

}  // namespace hodt
