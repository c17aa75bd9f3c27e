// How many neighbours keep each vertex from being a local extremum.
// Tested by tests/optimize/in_order_test.cpp.
#pragma once

#include "hodt/base/buffer.h"
#include "hodt/geometry/heights.h"
#include "hodt/mesh/triangle_mesh.h"

namespace hodt {

/// Every edge has one end that it removes, as a minimum or as a maximum; a vertex is an extremum if
/// no edge removes it. A view of the heights.
class RemoverCounts {
 public:
  RemoverCounts(const TriangleMesh& mesh, const Heights& heights, Extremum kind)
      : heights_(heights), kind_(kind), count_(mesh.vertex_count(), 0) {
    for (Index i = 0; i < mesh.halfedge_count(); ++i)
      if (const HalfEdgeId h(i); mesh.is_boundary(h) || h < mesh.twin(h))
        change(mesh.origin(h), mesh.target(h), 1);
  }

  Extremum kind() const { return kind_; }
  VertexId removed_by(VertexId u, VertexId v) const {
    return heights_.removes(u, v, kind_) ? v : u;
  }
  bool is_extremum(VertexId v) const { return count_[v] == 0; }
  /// By how many the extrema become more if an edge uv comes (1) or goes (-1).
  int effect(VertexId u, VertexId v, int by) const {
    const Index count = count_[removed_by(u, v)];
    return int{count + static_cast<Index>(by) == 0} - int{count == 0};
  }
  /// The edge came or went; returns the same.
  int change(VertexId u, VertexId v, int by) {
    const int more = effect(u, v, by);
    count_[removed_by(u, v)] += static_cast<Index>(by);
    return more;
  }

 private:
  Heights heights_;
  Extremum kind_;
  Buffer<Index> count_;  // of every vertex
};

}  // namespace hodt
