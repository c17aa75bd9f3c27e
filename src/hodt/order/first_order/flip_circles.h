// The circles that flips of Delaunay edges make.
#pragma once

#include <array>
#include <span>

#include "hodt/order/circle_counter.h"
#include "hodt/order/delaunay_graph.h"

namespace hodt {

/// A flip takes the edge from each of its ends, and makes a triangle of the other end and the two
/// apexes. If it is one of order 1, the circle of that holds the end that lost the edge, and
/// nothing else.
class FlipCircles {
 public:
  explicit FlipCircles(const DelaunayGraph& graph) : graph_(graph), sole_(graph) {}

  /// What a flip makes of the triangle on the side of the half-edge's target.
  static std::array<VertexId, 3> corners(const TriangleMesh& mesh, HalfEdgeId h) {
    return {mesh.target(h), mesh.apex(h), mesh.apex(mesh.twin(h))};
  }

  /// Of each edge, given by any half-edge, whether its flip makes two counter-clockwise triangles,
  /// and the circles of both hold only the end that they lost. Several threads may ask at once.
  /// REQUIRES that no edge is on the boundary.
  void hold_one_each(std::span<const HalfEdgeId> edges, bool* answers);

 private:
  bool holds_one(HalfEdgeId h);

  const DelaunayGraph& graph_;
  SoleInside sole_;
};

}  // namespace hodt
