// Triangles that share edges, made a mesh.
// Tested by tests/exhaustive/given_tin_test.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "hodt/mesh/triangle_mesh.h"

namespace hodt {

/// The triangles as they are given, glued along their common edges. REQUIRES counter-clockwise ones
/// that meet in nothing, in a corner or in an edge, and corners below `vertices`. O(n log n).
TriangleMesh glued(std::size_t vertices, std::span<const std::array<Index, 3>> triangles);

}  // namespace hodt
