// What the nearest points tell about flips of Delaunay edges, for runs of triangles at once.
// Tested by tests/order/first_order_test.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "hodt/order/delaunay_graph.h"

namespace hodt {

/// A flip makes two triangles, and each shall have one point in its circle: the end of the edge
/// that it lost. The nearest others are those beyond the four sides. If one of them is inside the
/// wrong circle, or the quadrilateral is not convex, which is so for four edges of five, the edge
/// is not flippable.
///
///            beyond_sv      beyond_vy
///                     \ v /              The edge is s y, its half-edge runs from s to y.
///                     s   y
///                     / u \              .
///            beyond_us      beyond_yu
///
/// As far as rounded arithmetic tells, which is nearly always. Holds scratch memory for one thread.
class NearestBeyond {
 public:
  static constexpr std::size_t kMostTriangles = 1 << 13;

  explicit NearestBeyond(const DelaunayGraph& graph) : graph_(graph) {}

  /// Takes up the triangles from `first` on, kMostTriangles at most.
  void judge(std::size_t first, std::size_t count);

  /// Whether they rule out the flip of the edge e of a triangle, which is one of these: those
  /// beyond the triangle's other edges. Never on the boundary.
  bool rule_out_from_inside(std::size_t triangle, Index e) const {
    return (ruled_out_[triangle - first_] >> e & 1) != 0;
  }
  /// Those on the other side of the edge, if the triangle there is one of these.
  bool rule_out_from_outside(HalfEdgeId h) const {
    const HalfEdgeId twin = graph_.mesh.twin(h);
    const TriangleId t = TriangleMesh::triangle(twin);
    return t - first_ < count_ && rule_out_from_inside(t, twin - 3 * t);
  }

 private:
  const DelaunayGraph& graph_;
  std::size_t first_ = 0, count_ = 0;
  std::array<std::uint8_t, kMostTriangles> ruled_out_;  // of three half-edges, a bit each
};

}  // namespace hodt
