// The surface between the vertices: linear on each triangle.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "hodt/base/ids.h"
#include "hodt/tin/tin.h"

namespace hodt {

/// For each place a triangle that contains it, its edges and corners included; kNone if there is
/// none. Decided in exact arithmetic. Requires an embedded mesh (see embedding.h), of any shape,
/// and finite coordinates. O((n + m) log (n + m)) for n triangles and m places, for each mesh.
std::vector<Index> triangles_at(const Tin& tin, std::span<const Point> places);

/// The height of the surface at each place; NaN where there is no triangle. At a vertex it is the
/// vertex's height. Requires what triangles_at requires, and tin.points.has_heights().
std::vector<double> interpolate(const Tin& tin, std::span<const Point> places);

/// The height at a place in a triangle that contains it: at a corner its own, and never beyond those
/// of the corners.
double height_in(const PointSet& points, const std::array<Index, 3>& corners, const Point& p);

}  // namespace hodt
