// A triangulated surface as two flat arrays: topology only, no coordinates.
//
// Triangle t has the half-edges 3t, 3t + 1, 3t + 2, counter-clockwise. A half-edge stores the
// vertex it leaves and its twin, the half-edge along the same edge in the neighbouring triangle.
//
//              apex(h)
//                 *
//     prev(h)   /   \   next(h)
//              / t   \                   twin(h) runs from target(h) to origin(h);
//    origin(h) *---->* target(h)         kNone across the boundary.
//                 h
#pragma once

#include <array>
#include <cstddef>

#include "hodt/base/buffer.h"
#include "hodt/base/ids.h"

namespace hodt {

class TriangleMesh {
 public:
  TriangleMesh() = default;
  /// Takes over the arrays: the origin and the twin of every half-edge, three a triangle.
  TriangleMesh(std::size_t vertices, Buffer<Index> origins, Buffer<Index> twins)
      : vertices_(vertices), origin_(std::move(origins)), twin_(std::move(twins)) {}

  std::size_t vertex_count() const { return vertices_; }
  std::size_t triangle_count() const { return origin_.size() / 3; }
  std::size_t halfedge_count() const { return origin_.size(); }

  static HalfEdgeId halfedge(TriangleId t) { return HalfEdgeId(3 * t); }
  static TriangleId triangle(HalfEdgeId h) { return TriangleId(h / 3); }
  // Without branches, which would go the wrong way every third time.
  static HalfEdgeId next(HalfEdgeId h) { return HalfEdgeId(h + 1 - 3 * Index{h % 3 == 2}); }
  static HalfEdgeId prev(HalfEdgeId h) { return HalfEdgeId(h - 1 + 3 * Index{h % 3 == 0}); }

  VertexId origin(HalfEdgeId h) const { return VertexId(origin_[h]); }
  VertexId target(HalfEdgeId h) const { return origin(next(h)); }
  VertexId apex(HalfEdgeId h) const { return origin(prev(h)); }
  HalfEdgeId twin(HalfEdgeId h) const { return HalfEdgeId(twin_[h]); }
  bool is_boundary(HalfEdgeId h) const { return twin_[h] == kNone; }
  std::array<VertexId, 3> corners(TriangleId t) const {
    return {VertexId(origin_[3 * t]), VertexId(origin_[3 * t + 1]), VertexId(origin_[3 * t + 2])};
  }

  /// The edges that leave the origin of h, one step around it; kNone across the boundary.
  HalfEdgeId rotate_ccw(HalfEdgeId h) const { return twin(prev(h)); }
  HalfEdgeId rotate_cw(HalfEdgeId h) const { return twin(h).valid() ? next(twin(h)) : twin(h); }

  /// Replaces the edge of h by the other diagonal of its two triangles, and returns that diagonal:
  /// d -> c, which is next(h). Only h and its twin come to name other edges (a -> d and b -> c).
  /// Requires !is_boundary(h); the caller knows that the quadrilateral is convex.
  ///
  ///         c                 c
  ///       /   \             / | \           (a, b, c), (b, a, d)  ==>  (a, d, c), (b, c, d)
  ///      a --> b    ==>    a  |  b
  ///       \   /             \ | /
  ///         d                 d
  HalfEdgeId flip(HalfEdgeId h);

  void set_vertex_count(std::size_t vertices) { vertices_ = vertices; }
  void set_origin(HalfEdgeId h, VertexId v) { origin_[h] = v; }
  /// Makes a and b twins; either may be kNone.
  void glue(HalfEdgeId a, HalfEdgeId b) {
    if (a.valid()) twin_[a] = b;
    if (b.valid()) twin_[b] = a;
  }

  const Buffer<Index>& origins() const { return origin_; }
  const Buffer<Index>& twins() const { return twin_; }
  Buffer<Index>& origins() { return origin_; }
  Buffer<Index>& twins() { return twin_; }

 private:
  std::size_t vertices_ = 0;
  Buffer<Index> origin_;
  Buffer<Index> twin_;
};

/// For every vertex a half-edge that leaves it, or kNone. Of a boundary vertex it is the boundary
/// half-edge, so that rotate_ccw from it passes every triangle at the vertex. Data beside the mesh:
/// a flip makes it stale.
Buffer<HalfEdgeId> outgoing_halfedges(const TriangleMesh& mesh);

/// Calls f(h) for every half-edge that leaves the origin of `start`, counter-clockwise; `start` as
/// outgoing_halfedges gives it. At a boundary vertex the last boundary edge has no such half-edge:
/// it is the prev of the last one.
template <class F>
void for_each_outgoing(const TriangleMesh& mesh, HalfEdgeId start, const F& f) {
  HalfEdgeId h = start;
  do {
    f(h);
    h = mesh.rotate_ccw(h);
  } while (h.valid() && h != start);
}

/// Calls f(v) for every neighbour of the origin of `start`, counter-clockwise.
template <class F>
void for_each_neighbour(const TriangleMesh& mesh, HalfEdgeId start, const F& f) {
  HalfEdgeId h = start;
  for (;;) {
    f(mesh.target(h));
    const HalfEdgeId following = mesh.rotate_ccw(h);
    if (!following.valid()) {
      f(mesh.apex(h));
      return;
    }
    if (following == start) return;
    h = following;
  }
}

}  // namespace hodt
