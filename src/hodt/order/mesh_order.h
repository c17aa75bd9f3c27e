// The order of a given mesh, recounted from coordinates alone.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "hodt/base/ids.h"
#include "hodt/geometry/point_set.h"

namespace hodt {

struct MeshOrder {
  /// The largest order of a triangle, cocircular points judged by the perturbation.
  Index order = 0;
  /// The same with cocircular points counted as outside; never larger than `order`.
  Index order_plain = 0;
  /// How many triangles have plain order 0, 1, ..., `order_plain`.
  std::vector<std::size_t> histogram;
  /// Edges that were to be walls and are no edges of the mesh, counted from vertex to vertex. If
  /// there are any, nothing was counted.
  std::size_t missing_walls = 0;
};

/// Counts the points inside every triangle's circumcircle. Points that are a corner of no triangle
/// count too; a point with the coordinates of a corner is outside. Works for any list of triangles,
/// embedded or not. Requires every triangle counter-clockwise and every corner < points.size().
///
/// With walls, edges between points, the orders are constrained orders: points that are not reached
/// without crossing a wall do not count. Then requires an embedded mesh. The edges of its border
/// are walls, too, but are not looked for in the mesh: a point of no triangle can lie on one.
/// Throws InputError if walls cross.
MeshOrder order_of_mesh(const PointSet& points, std::span<const std::array<Index, 3>> triangles,
                        std::span<const std::array<Index, 2>> walls = {},
                        std::span<const std::array<Index, 2>> border = {});

}  // namespace hodt
