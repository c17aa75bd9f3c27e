// A part of a mesh exchanged for another triangulation of the same region.
// Tested by tests/optimize/optimize_measure_test.cpp.
#pragma once

#include <array>
#include <span>

#include "hodt/mesh/triangle_mesh.h"

namespace hodt {

/// Puts `fresh`, as many counter-clockwise triangles that cover the same region, in the places of
/// `old`. All half-edges of the mesh fit together afterwards. Throws std::logic_error if they
/// cannot.
void replace_triangles(TriangleMesh& mesh, std::span<const TriangleId> old,
                       std::span<const std::array<VertexId, 3>> fresh);

}  // namespace hodt
