// What INPUT holds where it can be points or a mesh.
// Tested by tests/app/constraints_test.cpp.
#pragma once

#include <cstddef>
#include <vector>

#include "app/points_input.h"

#include "hodt/geometry/constraints.h"

namespace hodt::app {

/// Points, or a mesh to improve.
struct Source {
  bool is_tin = false;
  InputPoints input;        ///< of a mesh, its points alone
  Constraints constraints;  ///< of a mesh, by which its outline and its holes stay
  std::size_t unused_vertices = 0;
  std::vector<Index> numbers;  ///< of the mesh's vertices among the points
};

/// Throws what read_input_points() and reading a mesh do, and ParameterError for a mesh among
/// several files, or with options that choose points.
Source read_source(const PointsInput& input);

}  // namespace hodt::app
