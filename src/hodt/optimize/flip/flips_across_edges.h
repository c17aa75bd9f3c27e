// Flips that improve a triangulation for a measure across edges, alone or two together, on all
// cores. Tested by tests/optimize/flips_across_edges_test.cpp.
#pragma once

#include <span>

#include "hodt/base/deadline.h"
#include "hodt/optimize/flip/quadrilateral.h"
#include "hodt/optimize/measure/edge_measures.h"
#include "hodt/order/delaunay_graph.h"

namespace hodt {

/// Has a say in every move.
class MoveGuard {
 public:
  MoveGuard() = default;
  MoveGuard(const MoveGuard&) = delete;
  MoveGuard& operator=(const MoveGuard&) = delete;
  virtual ~MoveGuard() = default;

  /// Whether it may be made: flips one after the other. Several threads ask at the same time, about
  /// different vertices.
  virtual bool allows(std::span<const Quadrilateral> move) = 0;
  /// It was made.
  virtual void take(std::span<const Quadrilateral> move) = 0;
};

/// Flips as long as a move makes the mesh better for the objective and leaves triangles of order at
/// most k, or until the deadline passes. A move is one flip or, up to `most_flips`, some one after
/// another near each other that are of use together; more than two only for sums, and more than
/// three only where they gain much. A flip changes the values of the diagonal and of the four
/// sides; better is a better sum, or for largest and smallest values lexicographically better
/// sorted ones. So every move improves the sum, or the sorted values of all edges, and it ends. The
/// mesh must be a triangulation of the graph's points of order at most k, with the same half-edges
/// on the boundary. The same result on any number of threads. Only
/// moves that the guard allows, if there is one.
void improve_across_edges(const DelaunayGraph& graph, const EdgeValues& values, Index k,
                          int most_flips, const Deadline& deadline, TriangleMesh& mesh,
                          MoveGuard* guard = nullptr);

}  // namespace hodt
