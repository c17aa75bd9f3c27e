// Whether a list of triangles is an embedded mesh: a proof, in exact arithmetic.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>

#include "hodt/base/ids.h"
#include "hodt/geometry/point.h"

namespace hodt {

/// A list of triangles is an embedded mesh if each has an inside, and two of them meet in nothing,
/// in one shared corner or in one shared edge. So nothing overlaps, no vertex lies within an edge
/// or a triangle that does not have it as a corner, and no two corners are different vertices with
/// equal coordinates. Holes, concave outlines and several components are allowed.
struct Embedding {
  bool embedded = false;
  /// The first problem found, in words, with triangle and vertex numbers (0-based, in input order);
  /// empty if embedded.
  std::string problem;
  /// Embedded, and the union of the triangles is exactly the convex hull of all points.
  bool covers_hull = false;
  /// Points that are no triangle's corner.
  std::size_t unused_vertices = 0;
  /// Pieces of the mesh that hang together by edges. Counted only if embedded.
  std::size_t components = 0;
  /// Edges with one triangle. Counted only if embedded.
  std::size_t boundary_edges = 0;
  /// Triangles given clockwise: tolerated, and read backwards.
  std::size_t clockwise = 0;
};

/// Checks a list of triangles, in O(n log n). Requires every corner < points.size() and every
/// coordinate finite.
Embedding check_embedding(std::span<const Point> points,
                          std::span<const std::array<Index, 3>> triangles);

}  // namespace hodt
