// The engine of the Delaunay triangulation; delaunay.h is the door.
// Tested by tests/delaunay/delaunay_test.cpp.
#pragma once

#include "hodt/delaunay/spatial_order.h"
#include "hodt/mesh/triangle_mesh.h"

namespace hodt {

/// The Delaunay triangulation of a spatially ordered vertex set. Requires three vertices or more.
/// If all lie on one line the mesh has no triangle.
TriangleMesh divide_and_conquer(const SpatialOrder& order);

}  // namespace hodt
