// Flips edges of a triangulation as long as any is better, whatever that means.
// Tested by tests/optimize/optimize_measure_test.cpp.
#pragma once

#include <vector>

#include "hodt/base/deadline.h"
#include "hodt/geometry/predicates.h"
#include "hodt/optimize/flip/quadrilateral.h"
#include "hodt/order/circle_counter.h"
#include "hodt/order/delaunay_graph.h"

namespace hodt {

/// `Better` says of a quadrilateral whose diagonal ab could be replaced by dc whether that is
/// better. It may have a member flipped(quadrilateral), which is told what was replaced.
template <class Better>
class Flipper {
 public:
  Flipper(const DelaunayGraph& graph, Index k, Better& better, TriangleMesh& mesh)
      : graph_(graph),
        k_(k),
        better_(better),
        mesh_(mesh),
        counter_(graph),
        queued_(mesh.halfedge_count(), false) {}

  /// Returns whether there was any.
  bool run(const Deadline& deadline) {
    bool any = false;
    for (Index h = 0; h < mesh_.halfedge_count(); ++h) push(HalfEdgeId(h));
    while (!queue_.empty()) {
      if (deadline.passed()) return false;
      const HalfEdgeId h = queue_.back();
      queue_.pop_back();
      queued_[h] = false;
      if (mesh_.is_boundary(h)) continue;  // since it was queued, it came to name another edge
      const Quadrilateral q = quadrilateral(h);
      if (!improves(h, q)) continue;
      flip(h);
      if constexpr (requires { better_.flipped(q); }) better_.flipped(q);
      any = true;
    }
    return any;
  }
  /// For what depends on all that is around the corners, where a flip can make another one better
  /// that is further away than run() looks.
  void run_to_the_end(const Deadline& deadline) {
    while (run(deadline)) continue;
  }

 private:
  void push(HalfEdgeId h) {
    if (mesh_.is_boundary(h) || queued_[h] || queued_[mesh_.twin(h)]) return;
    queued_[h] = true;
    queue_.push_back(h);
  }

  Quadrilateral quadrilateral(HalfEdgeId h) const {
    return {mesh_.origin(h), mesh_.target(h), mesh_.apex(h), mesh_.apex(mesh_.twin(h))};
  }

  bool improves(HalfEdgeId h, const Quadrilateral& q) {
    const Point &a = graph_.point(q.a), &b = graph_.point(q.b);
    const Point &c = graph_.point(q.c), &d = graph_.point(q.d);
    if (orient(a, d, c) <= 0 || orient(b, c, d) <= 0) return false;  // not convex
    if (graph_.is_wall(q.a, q.b)) return false;
    return better_(mesh_, h, q) && counter_.count(q.a, q.d, q.c, k_) <= k_ &&
           counter_.count(q.b, q.c, q.d, k_) <= k_;
  }

  void flip(HalfEdgeId h) {
    const HalfEdgeId diagonal = mesh_.flip(h);
    for (const HalfEdgeId inner : {diagonal, mesh_.twin(diagonal)}) {
      for (const HalfEdgeId side : {TriangleMesh::next(inner), TriangleMesh::prev(inner)}) {
        push(side);
        // What flipping these would change includes the sides.
        if (mesh_.is_boundary(side)) continue;
        push(TriangleMesh::next(mesh_.twin(side)));
        push(TriangleMesh::prev(mesh_.twin(side)));
      }
    }
  }

  const DelaunayGraph& graph_;
  const Index k_;
  Better& better_;
  TriangleMesh& mesh_;
  CircleCounter counter_;
  std::vector<bool> queued_;
  std::vector<HalfEdgeId> queue_;
};

}  // namespace hodt
