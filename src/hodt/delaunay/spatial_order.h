// Points in the order of a space-filling curve: near in the plane, near in memory.
#pragma once

#include <cstddef>
#include <cstdint>

#include "hodt/base/buffer.h"
#include "hodt/base/ids.h"
#include "hodt/delaunay/duplicates.h"
#include "hodt/geometry/point.h"
#include "hodt/geometry/point_set.h"

namespace hodt {

/// As many points as the ids of their half-edges, 6n, leave room for.
inline constexpr std::size_t kMaxPoints = kNone / 6;

/// The vertices of a triangulation: the distinct points of a PointSet along a Z-order curve. Every
/// stage after the reader computes with these numbers; `row` leads back to the input.
struct VertexSet {
  Buffer<Point> xy;
  Buffer<double> z;   ///< empty if the input has no heights
  Buffer<Index> row;  ///< the input row of each vertex
  DuplicateHeights duplicate_heights;

  std::size_t size() const { return xy.size(); }
};

/// A vertex set with what the divide-and-conquer needs to cut it along straight lines.
struct SpatialOrder {
  VertexSet vertices;
  /// Position on the curve, not decreasing: the bits of y and x, interleaved, y first, as 32-bit
  /// multiples of one cell size. Vertices with equal keys are in lexicographic order.
  Buffer<std::uint64_t> key;
};

/// Sorts the points. Of those with equal (x, y) the one with the lowest z stays (the first of these
/// if z ties too). The same order whatever the order of the input and the number of threads.
/// Throws InputError if a coordinate is NaN or infinite, naming its row, and if there are
/// more than kMaxPoints.
SpatialOrder spatial_order(const PointView& points);

/// The vertex that stands for each input row: for a dropped duplicate, the vertex at its place.
Buffer<VertexId> vertices_of_rows(const PointView& points, const VertexSet& vertices);

}  // namespace hodt
