// The best triangulation of order k for a measure.
#pragma once

#include "hodt/optimize/measure_problem.h"

namespace hodt {

/// For a measure of triangles or across edges, by the room that knows how.
MeasuredSolution optimize_measure(const MeasureProblem& problem);

}  // namespace hodt
