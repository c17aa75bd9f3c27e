// What an objective measures of any triangulation.
// Tested by tests/exhaustive/given_tin_test.cpp.
#pragma once

#include <span>

#include "hodt/geometry/point.h"
#include "hodt/mesh/triangle_mesh.h"
#include "hodt/optimize/objective.h"

namespace hodt {

/// The objective's value of a mesh on these vertices; 0 for Objective::none. Vertices one after the
/// other that are at one point, as where a domain touches itself, count as one, with the neighbours
/// of all. Throws InputError if a double cannot hold it. REQUIRES heights if the objective needs
/// them.
double value_of(const Objective& objective, const TriangleMesh& mesh, std::span<const Point> xy,
                std::span<const double> z);

/// Whether a value is better than another one.
bool is_better(const Objective& objective, double value, double other);

}  // namespace hodt
