// The best triangulation of order k for a measure of triangles.
// Tested by tests/optimize/optimize_measure_test.cpp.
#pragma once

#include "hodt/optimize/measure_problem.h"

namespace hodt {

/// Order 1 is always optimal: the quadrilaterals are independent (Theorem 7). Above, the fixed
/// edges cut the plane into faces (Silveira and van Kreveld). A face that is a polygon is solved by
/// dynamic programming over its valid triangles; any other one, for sums, by a linear program. What
/// is not solved is improved by flips, and bounded. docs/design/measures.md explains.
MeasuredSolution optimize_triangle_measure(const MeasureProblem& problem);

}  // namespace hodt
