// Local minima, maxima and pits of a TIN, counted from its triangles alone.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "hodt/base/ids.h"
#include "hodt/geometry/point_set.h"

namespace hodt {

/// Vertices inside, and vertices on the boundary (an end of an edge with one triangle).
struct SplitCount {
  std::size_t interior = 0;
  std::size_t boundary = 0;

  std::size_t total() const { return interior + boundary; }
  friend bool operator==(const SplitCount&, const SplitCount&) = default;
};

struct ExtremaCount {
  /// Vertices with no lower neighbour; u is lower than v if (z, x, y) is lexicographically smaller.
  SplitCount minima;
  /// Vertices with no higher neighbour.
  SplitCount maxima;
  /// Maximal connected sets of vertices of equal z with no neighbour of smaller z; one of them is
  /// on the boundary if any of its vertices is.
  SplitCount pits;

  friend bool operator==(const ExtremaCount&, const ExtremaCount&) = default;
};

/// Counts the extrema of the surface. `corners` lists three vertices a triangle, each < xy.size();
/// vertices of no triangle count as nothing. Requires z.size() == xy.size(). Fastest if vertices
/// that are near in the plane have near numbers.
ExtremaCount count_extrema(std::span<const Point> xy, std::span<const double> z,
                           std::span<const Index> corners);

/// The same for a TIN's arrays. Requires points.has_heights().
inline ExtremaCount count_extrema(const PointSet& points,
                                  std::span<const std::array<Index, 3>> triangles) {
  return count_extrema(points.xy, points.z,
                       {triangles.empty() ? nullptr : triangles[0].data(), 3 * triangles.size()});
}

}  // namespace hodt
