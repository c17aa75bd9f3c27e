// Whether a mesh is what its two arrays promise: everything is looked at, nothing is assumed.
#pragma once

#include <cstdint>
#include <string>

#include "hodt/mesh/triangle_mesh.h"

namespace hodt {

/// What a mesh should be as a whole.
enum class Surface : std::uint8_t {
  any,   ///< holes, several pieces, closed surfaces: all allowed
  disk,  ///< one piece with one boundary and no holes; vertices without triangles do not count
};

/// What is wrong with the mesh's connectivity, naming a half-edge, triangle or vertex; empty if
/// nothing is. Nothing wrong means: every number is in range, the three corners of a triangle
/// differ, twins name each other and run along the same edge in opposite directions, and the
/// triangles at each vertex form one fan, so that a vertex has at most two boundary edges.
/// O(n), whatever the arrays hold.
std::string connectivity_problem(const TriangleMesh& mesh, Surface surface = Surface::any);

}  // namespace hodt
