// Objectives in order at order 1, where the choices of diagonals can be told apart.
// Tested by tests/optimize/in_order_test.cpp.
#pragma once

#include "hodt/mesh/triangle_mesh.h"
#include "hodt/optimize/in_order/improve_in_order.h"

namespace hodt {

struct FirstOrderInOrder {
  TriangleMesh mesh;
  /// Among all triangulations of order 1 that keep the value of the first objective it is the best
  /// for the second, of these for the third.
  bool is_best = false;
};

/// Either diagonal of every quadrilateral may be taken, whatever is taken elsewhere; what they cost
/// for each objective is a matter of few that hang together, which are solved for all objectives at
/// once. Where too many do, the diagonals stay as in `mesh`, which is of order 1. Nothing is solved
/// with a degree among the objectives, or if one that is not the last asks only for the best of all
/// values. REQUIRES order 1.
FirstOrderInOrder first_order_in_order(const OrderedProblem& problem, const TriangleMesh& mesh);

}  // namespace hodt
