// What a triangulation has to keep to: breaklines, and the border of its domain.
// Tested by tests/exhaustive/constraints_small_test.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "hodt/base/ids.h"

namespace hodt {

/// By the rows of a PointSet, from 0. An edge may pass through points, which split it; edges may
/// overlap, be given twice, or have equal ends, which is no edge. No two may cross elsewhere than
/// at a point.
struct Constraints {
  using Edge = std::array<Index, 2>;

  /// Edges that have to be there: breaklines.
  std::vector<Edge> edges;
  /// The edges that bound the domain, in any order and direction; they have to be there, too. A
  /// triangle is inside if a way from it out of the hull crosses them an odd number of times: so
  /// outlines, holes, and islands in holes are all the same. None: the domain is the convex hull.
  /// Triangles outside are left out, and points that are no triangle's corner then.
  std::vector<Edge> boundary;
  /// Of the triangles inside, those at the boundary go that have an edge there longer than this,
  /// from outside in; edges that have to be there are not taken away.
  double max_edge = std::numeric_limits<double>::infinity();
  /// A triangulation of the domain that is there already, to compare with: its triangles, counter-
  /// clockwise (see pipeline/given_tin.h). The result is no worse, if it is of no larger order than
  /// is asked for. Not together with max_edge.
  std::vector<std::array<Index, 3>> triangles;

  bool empty() const {
    return edges.empty() && boundary.empty() && max_edge == std::numeric_limits<double>::infinity();
  }
};

/// What the constraints did.
struct ConstraintReport {
  std::size_t edges = 0;               ///< given, those of the boundary included
  std::size_t walls = 0;               ///< edges of the triangulation that they are
  std::size_t triangles_outside = 0;   ///< left out, as they are not in the domain
  std::size_t triangles_too_long = 0;  ///< left out for max_edge
  std::size_t unused_points = 0;       ///< left out, as no triangle has them
  std::size_t walls_left_out = 0;      ///< edges of the given ones that no triangle has then
};

}  // namespace hodt
