// Changes of a triangulation that make one objective better and those before it no worse.
// Tested by tests/optimize/in_order_test.cpp.
#pragma once

#include <span>

#include "hodt/base/buffer.h"
#include "hodt/base/deadline.h"
#include "hodt/mesh/triangle_mesh.h"
#include "hodt/optimize/objective.h"
#include "hodt/order/delaunay_graph.h"

namespace hodt {

struct OrderedProblem {
  const DelaunayGraph& graph;
  std::span<const double> z;  ///< may be empty if no objective needs heights
  Index order = 0;
  std::span<const Objective> objectives;  ///< the first one counts most
  /// Minima that have to stay, a flag for every vertex.
  const Buffer<bool>& kept;
  Deadline deadline = {};
};

/// Makes the last of the problem's objectives better: by flips, and by regions that become as they
/// are in `other`, as long as there are any or until the deadline passes. No objective before gets
/// worse. Both meshes are triangulations of that order; `other` is good for the last objective.
void improve_in_order(const OrderedProblem& problem, const TriangleMesh& other, TriangleMesh& mesh);

/// The same by regions alone: few are exchanged where `mesh` is good for what is to come next.
void exchange_in_order(const OrderedProblem& problem, const TriangleMesh& other,
                       TriangleMesh& mesh);

}  // namespace hodt
