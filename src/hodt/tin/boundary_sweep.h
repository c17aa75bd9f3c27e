// Whether the boundary of a mesh bounds it: no crossing, and its inside never doubled.
// Tested by tests/tin/embedding_test.cpp.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "hodt/base/ids.h"
#include "hodt/geometry/point.h"

namespace hodt {

/// A directed edge with one triangle, on its left.
struct BoundaryEdge {
  Index from = 0;
  Index to = 0;
  Index triangle = 0;
};

struct BoundaryProblem {
  enum class Kind {
    crossing,      ///< first and second meet elsewhere than in a shared end
    equal_points,  ///< an end of first and an end of second are two vertices with equal coordinates
    doubled,       ///< between first and second, or beyond first, triangles lie on triangles
  };
  Kind kind = Kind::crossing;
  BoundaryEdge first;
  BoundaryEdge second;  ///< the same as first if there is no second
};

/// Sweeps over the edges, which must form closed chains (as many edges come to a vertex as leave
/// it). Returns the first problem met, if any. If there is none, the edges bound a region without
/// overlap: each has the region on its left and none on its right. O(b log b) for b edges.
std::optional<BoundaryProblem> sweep_boundary(std::span<const Point> points,
                                              std::span<const BoundaryEdge> edges);

}  // namespace hodt
