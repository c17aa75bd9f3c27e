// The points inside a circle that can be reached without crossing a wall.
// Tested by tests/order/constrained_order_test.cpp.
#pragma once

#include <span>
#include <vector>

#include "hodt/base/round_marks.h"
#include "hodt/geometry/circle.h"
#include "hodt/order/delaunay_graph.h"

namespace hodt {

/// Counts for the constrained order. From a triangle it goes to the vertices inside its circle
/// along the edges of the constrained Delaunay triangulation; around a vertex it does not turn past
/// a wall. That finds all that is reached by any path in the circle which crosses no wall:
///
/// Such a path passes from triangle to triangle, and can be one that crosses no edge twice. If both
/// ends of an edge that it crosses were outside, no vertex would be reached on one of its sides:
/// the circle's part there would be inside that of the triangle of this side, as two circles meet
/// twice at most. But on both sides there is something, a corner of the triangle to begin with or
/// what is reached in the end. So one end of each edge is inside, and is reached, too.
///
/// Holds scratch memory for one thread.
class Reachable {
 public:
  explicit Reachable(const DelaunayGraph& graph)
      : graph_(graph), seen_(graph.xy.size()), counted_(graph.xy.size()) {}

  /// The number of vertices reached inside the circle through a, b and c (counter-clockwise) from
  /// the triangle abc, or limit + 1 if there are more than `limit`, and if the triangle is outside
  /// of the domain, between edges of its border. REQUIRES that it crosses no wall.
  Index count(VertexId a, VertexId b, VertexId c, Index limit);

  /// Those that the last count found, at most limit + 1 of them.
  std::span<const VertexId> inside() const { return inside_; }

 private:
  bool begin_at(VertexId a, VertexId b, VertexId c, Index most);
  void visit(HalfEdgeId from);
  void go_around(HalfEdgeId from);

  const DelaunayGraph& graph_;
  const Circle* circle_ = nullptr;
  RoundMarks seen_;
  RoundMarks counted_;  // places
  std::vector<VertexId> inside_;
  /// A vertex inside, as a half-edge that leaves it in a triangle which is reached.
  std::vector<HalfEdgeId> reached_;
  /// The triangles at parted vertices that were gone around, as their half-edges that leave these.
  std::vector<HalfEdgeId> gone_around_;
  std::vector<HalfEdgeId> overlapping_;  // scratch of begin_at()
};

}  // namespace hodt
