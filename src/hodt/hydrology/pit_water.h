// How much water the pits of a triangulated terrain hold, and how deep they are in all.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hodt/base/buffer.h"
#include "hodt/geometry/point.h"
#include "hodt/hydrology/pit_depths.h"
#include "hodt/mesh/triangle_mesh.h"

namespace hodt {

/// For each vertex the height of the water at it once every pit is full: the least height that a
/// path from it to the boundary has to rise to, and the vertex's own height where it stays dry.
/// Paths along edges are as good as any on the surface: within a triangle, the way to its lowest
/// corner never rises. O(n log n).
Buffer<double> water_levels(const TriangleMesh& mesh, std::span<const double> z);

/// The volume between the surface, linear on each triangle, and the water that stands on it once
/// every pit is full. Over a triangle the water is level, at the level of the lowest corner, and
/// ends where the surface rises out of it; each such wedge is integrated in closed form. A pit in a
/// larger pit is part of it. In cubed units of the input if heights and places share theirs.
double water_volume(const TriangleMesh& mesh, std::span<const Point> xy, std::span<const double> z);

/// What each of the pits (see pit_depths.h) holds before it flows over, smaller pits inside of it
/// included. O(n log n), however deep pits are nested in pits.
std::vector<double> pit_volumes(const TriangleMesh& mesh, std::span<const Point> xy,
                                std::span<const double> z, std::span<const Pit> pits);

/// All pits of a terrain together.
struct PitTotals {
  std::size_t count = 0;  ///< local minima that are not on the boundary
  double depth = 0;       ///< the sum of their depths (see pit_depths.h)
  double deepest = 0;
  double volume = 0;  ///< of the water (see water_volume)
};

PitTotals pit_totals(const TriangleMesh& mesh, std::span<const Point> xy,
                     std::span<const double> z);

}  // namespace hodt
