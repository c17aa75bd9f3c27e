// Where a domain touches itself at a point, each side there has a vertex of its own, and what is
// optimised counts each for itself. These tell what whoever has the mesh finds: at a point once,
// among all its neighbours.
// Tested by tests/exhaustive/constraints_small_test.cpp.
#pragma once

#include <span>

#include "hodt/base/deadline.h"
#include "hodt/optimize/objective.h"
#include "hodt/optimize/optimize.h"
#include "hodt/order/delaunay_graph.h"

namespace hodt {

/// Whether any two vertices are at one point.
bool touches_itself(const DelaunayGraph& graph);

/// Whether it makes a difference for the objective how often a point counts.
bool counts_vertices(const Objective& objective);

/// Makes values of sides values of points, and a bound on those a bound on these, for
/// triangulations of the order. Takes the Delaunay triangulation if that is better so.
void count_points(const DelaunayGraph& graph, std::span<const double> z, Index order,
                  const Objective& objective, const Deadline& deadline, Optimum& optimum);

}  // namespace hodt
