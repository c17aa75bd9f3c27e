// Good triangulations of order k for a measure of edges.
// Tested by tests/optimize/optimize_measure_test.cpp.
#pragma once

#include "hodt/optimize/measure_problem.h"

namespace hodt {

/// Order 1: a quadrilateral's choice and its neighbours' decide what an edge between them measures.
/// On scattered points they form small parts that are nearly trees, solved by dynamic programming:
/// optimal. Parts of great width (on lattices) are improved and bounded. Above order 1: flips, and
/// a bound: no edge is better than the best two valid triangles at it. docs/design/measures.md
/// explains.
MeasuredSolution optimize_edge_measure(const MeasureProblem& problem);

}  // namespace hodt
