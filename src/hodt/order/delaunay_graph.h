// The Delaunay triangulation as the graph that every question about orders is answered on.
#pragma once

#include <span>

#include "hodt/delaunay/delaunay.h"
#include "hodt/geometry/circle.h"
#include "hodt/mesh/triangle_mesh.h"

namespace hodt {

/// A view: the Delaunay triangulation must outlive it and stay as it is.
class DelaunayGraph {
 public:
  explicit DelaunayGraph(const Delaunay& delaunay)
      : xy(delaunay.vertices.xy),
        mesh(delaunay.mesh),
        outgoing(outgoing_halfedges(delaunay.mesh)) {}

  /// Stores every vertex's neighbours side by side, 28 bytes a point: worth it before questions
  /// about most of the vertices. Changes no answer.
  void list_neighbours();

  const Point& point(VertexId v) const { return xy[v]; }

  /// Calls f(w) for every neighbour w of v, counter-clockwise.
  template <class F>
  void for_each_neighbour(VertexId v, const F& f) const {
    if (first_.empty()) return hodt::for_each_neighbour(mesh, outgoing[v], f);
    for (Index i = first_[v]; i < first_[v + 1]; ++i) f(neighbours_[i]);
  }

  const std::span<const Point> xy;
  const TriangleMesh& mesh;
  const Buffer<HalfEdgeId> outgoing;  ///< as outgoing_halfedges gives it

 private:
  Buffer<Index> first_;          // where each vertex's neighbours begin; empty without a list
  Buffer<VertexId> neighbours_;  // of all vertices in turn
};

}  // namespace hodt
