// What is certain of a measure before anything is computed.
// Tested by tests/optimize/time_limit_test.cpp.
#pragma once

#include <span>

#include "hodt/geometry/point.h"
#include "hodt/mesh/triangle_mesh.h"
#include "hodt/optimize/objective.h"

namespace hodt {

/// No triangulation of the points is better, of whatever order, and the number is finite: what is
/// left to say where time was too short for a better bound. In linear time.
double trivial_bound(const Objective& objective, std::span<const Point> xy,
                     const TriangleMesh& delaunay);

}  // namespace hodt
