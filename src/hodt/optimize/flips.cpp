#include "hodt/optimize/flips.h"

#include <vector>

#include "hodt/geometry/predicates.h"
#include "hodt/order/circle_counter.h"

namespace hodt {

namespace {

class Flipper {
 public:
  Flipper(const DelaunayGraph& graph, const TriangleValues& values, Index k, TriangleMesh& mesh)
      : graph_(graph),
        values_(values),
        k_(k),
        mesh_(mesh),
        counter_(graph),
        queued_(mesh.halfedge_count(), false) {}

  void run(const Deadline& deadline) {
    for (Index h = 0; h < mesh_.halfedge_count(); ++h) push(HalfEdgeId(h));
    for (std::size_t steps = 0; !queue_.empty(); ++steps) {
      if (steps % 1024 == 0 && deadline.passed()) return;
      const HalfEdgeId h = queue_.back();
      queue_.pop_back();
      queued_[h] = false;
      if (improves(h)) flip(h);
    }
  }

 private:
  void push(HalfEdgeId h) {
    if (mesh_.is_boundary(h) || queued_[h] || queued_[mesh_.twin(h)]) return;
    queued_[h] = true;
    queue_.push_back(h);
  }

  bool improves(HalfEdgeId h) {
    const HalfEdgeId twin = mesh_.twin(h);
    const VertexId a = mesh_.origin(h), b = mesh_.target(h);
    const VertexId c = mesh_.apex(h), d = mesh_.apex(twin);
    const Point &pa = graph_.point(a), &pb = graph_.point(b);
    const Point &pc = graph_.point(c), &pd = graph_.point(d);
    if (orient(pa, pd, pc) <= 0 || orient(pb, pc, pd) <= 0) return false;  // not convex
    if (!values_.better_pair(values_.of(a, d, c), values_.of(b, c, d), values_.of(a, b, c),
                             values_.of(b, a, d)))
      return false;
    return counter_.count(a, d, c, k_) <= k_ && counter_.count(b, c, d, k_) <= k_;
  }

  void flip(HalfEdgeId h) {
    const HalfEdgeId diagonal = mesh_.flip(h);
    const HalfEdgeId twin = mesh_.twin(diagonal);
    for (const HalfEdgeId side : {TriangleMesh::next(diagonal), TriangleMesh::prev(diagonal),
                                  TriangleMesh::next(twin), TriangleMesh::prev(twin)})
      push(side);
  }

  const DelaunayGraph& graph_;
  const TriangleValues& values_;
  const Index k_;
  TriangleMesh& mesh_;
  CircleCounter counter_;
  std::vector<bool> queued_;
  std::vector<HalfEdgeId> queue_;
};

}  // namespace

void improve_by_flips(const DelaunayGraph& graph, const TriangleValues& values, Index k,
                      const Deadline& deadline, TriangleMesh& mesh) {
  Flipper(graph, values, k, mesh).run(deadline);
}

}  // namespace hodt
