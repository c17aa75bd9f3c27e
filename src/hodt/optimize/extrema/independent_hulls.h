// Edges whose hulls are apart, by fixed priority: Theorem 8's heuristic.
// Tested by tests/optimize/remove_extrema_test.cpp.
#pragma once

#include "hodt/base/deadline.h"
#include "hodt/optimize/extrema/extrema_targets.h"
#include "hodt/optimize/extrema/extrema_triangulation.h"

namespace hodt {

/// Brings in edges that remove targets, the smallest orders first, each with its hull in the place
/// of Delaunay triangles: together these never have a higher order than each edge alone.
/// Ends with the deadline.
void insert_independent_hulls(const ExtremaTargets& targets, const Deadline& deadline,
                              ExtremaTriangulation& triangulation);

}  // namespace hodt
