// Fixed edges: what all triangulations of order k have in common, and the faces in between.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hodt/base/deadline.h"
#include "hodt/order/delaunay_graph.h"

namespace hodt {

/// Of every half-edge of the Delaunay triangulation whether its edge is fixed: no useful edge of
/// order k or less crosses it. (An edge that is not Delaunay crosses one, and is never fixed.)
/// Throws TimeIsUp if the deadline passes.
Buffer<bool> fixed_edges(const DelaunayGraph& graph, Index k, const Deadline& deadline = {});

/// The faces that the fixed edges cut the plane into, inside the hull. Each can be triangulated by
/// itself. A face is a union of Delaunay triangles; where it is more than one, its boundary is an
/// outer walk and, for each of its inner components, another one, or a single vertex that no fixed
/// edge ends at. The graph and the flags must outlive it.
class FixedFaces {
 public:
  FixedFaces(const DelaunayGraph& graph, const Buffer<bool>& fixed);

  std::size_t size() const { return first_triangle_.size() - 1; }
  Index face_of(TriangleId t) const { return face_of_[t]; }
  /// Ascending.
  std::span<const TriangleId> triangles(Index face) const {
    return {triangles_.data() + first_triangle_[face],
            triangles_.data() + first_triangle_[face + 1]};
  }

  /// One closed walk of the boundary: half-edges with the face on their left, each beginning where
  /// the one before it ends, the first where the last does.
  using Walk = std::vector<HalfEdgeId>;
  struct Boundary {
    Walk outer;
    std::vector<Walk> inner;         ///< around components of fixed edges
    std::vector<VertexId> isolated;  ///< inner components of one vertex
    /// Outer and inner.
    std::size_t components() const { return 1 + inner.size() + isolated.size(); }
  };
  Boundary boundary(Index face) const;

 private:
  const DelaunayGraph& graph_;
  const Buffer<bool>& fixed_;
  Buffer<Index> face_of_;
  std::vector<Index> first_triangle_;
  std::vector<TriangleId> triangles_;
};

}  // namespace hodt
