// Useful edges from a vertex: the edges that some triangulation of order k contains (Lemma 4).
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

#include "hodt/order/first_order.h"
#include "hodt/order/window_walk.h"

namespace hodt {

/// Finds the useful edges of a vertex beyond its Delaunay edges. Holds scratch memory for one
/// thread.
class UsefulEdgeSearch {
 public:
  explicit UsefulEdgeSearch(const DelaunayGraph& graph) : graph_(graph) {}

  /// Lets each search end early after this many steps. For orders in the hundreds, where a search
  /// can visit a large part of the plane; complete() then tells whether the last one found all.
  void limit_effort(std::size_t steps) { effort_ = steps; }
  bool complete() const { return complete_; }

  /// All edges from u of useful order 1 to `limit` whose other end `wanted` accepts; sorted by
  /// order, then by vertex. The result lives until the next call.
  template <class Wanted>
  const std::vector<UsefulEdge>& from(VertexId u, Index limit, const Wanted& wanted) {
    return walk(u, limit, wanted, [](VertexId) { return false; });
  }

  /// The same for the other ends that are lexicographically larger than u: asked of every vertex,
  /// each edge is found once. Windows that only lead to smaller ones are not entered.
  const std::vector<UsefulEdge>& to_larger(VertexId u, Index limit) {
    const Point& p = graph_.point(u);
    const auto larger = [&](VertexId v) { return lexicographically_less(p, graph_.point(v)); };
    return walk(u, limit, larger, [&](VertexId v) { return !larger(v); });
  }

 private:
  template <class Wanted, class Behind>
  const std::vector<UsefulEdge>& walk(VertexId u, Index limit, const Wanted& wanted,
                                      const Behind& behind) {
    if (limit == 0) return first_order_.clear(), first_order_;
    if (limit == 1) return across_one_edge(u, wanted);
    // Four slots an order cut the walk well.
    if (limit <= 12) return walk_with(small_, u, limit, wanted, behind);
    if (limit <= 60) return walk_with(medium_, u, limit, wanted, behind);
    return walk_with(large_, u, limit, wanted, behind);
  }

  /// Corollary 3: an edge of useful order 1 crosses one Delaunay edge, and is its flip.
  template <class Wanted>
  const std::vector<UsefulEdge>& across_one_edge(VertexId u, const Wanted& wanted) {
    first_order_.clear();
    complete_ = true;
    for_each_outgoing(graph_.mesh, graph_.outgoing[u], [&](HalfEdgeId h) {
      const HalfEdgeId opposite = TriangleMesh::next(h);
      if (graph_.mesh.is_boundary(opposite)) return;
      const VertexId v = graph_.mesh.apex(graph_.mesh.twin(opposite));
      if (wanted(v) && is_first_order_flippable(graph_, opposite)) first_order_.push_back({v, 1});
    });
    std::sort(first_order_.begin(), first_order_.end(),
              [](const UsefulEdge& a, const UsefulEdge& b) { return a.to < b.to; });
    return first_order_;
  }

  template <class Walk, class Wanted, class Behind>
  const std::vector<UsefulEdge>& walk_with(std::unique_ptr<Walk>& walk, VertexId u, Index limit,
                                           const Wanted& wanted, const Behind& behind) {
    if (!walk) walk = std::make_unique<Walk>(graph_);
    const auto& found = walk->walk(u, limit, effort_, wanted, behind);
    complete_ = walk->complete();
    return found;
  }

  const DelaunayGraph& graph_;
  std::size_t effort_ = std::numeric_limits<std::size_t>::max();
  bool complete_ = true;
  std::vector<UsefulEdge> first_order_;
  std::unique_ptr<WindowWalk<1>> small_;
  std::unique_ptr<WindowWalk<4>> medium_;
  std::unique_ptr<WindowWalk<16>> large_;
};

}  // namespace hodt
