// The useful edges of a vertex where there are walls: a walk over the triangles that segments from
// it can cross.
// Tested by tests/order/constrained_order_test.cpp.
#pragma once

#include <vector>

#include "hodt/base/deadline.h"
#include "hodt/base/round_marks.h"
#include "hodt/order/constrained/reachable.h"
#include "hodt/order/delaunay_graph.h"
#include "hodt/order/search/search_policy.h"

namespace hodt {

/// Walks outward from u, from triangle to triangle, with the window of directions still in sight; a
/// wall ends it. Takes up points by what is reached from the ends of the edges that it crosses:
///
/// Of an edge uv of useful order k, let A be the circle through u, v and the first point on the
/// left (Lemma 4). The edges that uv crosses have their right ends inside A: their left ends are
/// not, and no triangle crosses an edge of the constrained Delaunay triangulation with both ends
/// outside its circle (see reachable.h). What is right of the window and inside the circle through
/// u and the ends of a crossed edge is inside A too (docs/design/useful-edges.md), and if a chain
/// of edges leads there from the edge's right end through points of that kind, it is reached, as A
/// holds all of the chain. So more than k such points on a side end the walk.
///
/// Holds scratch memory for one thread.
class WallWalk {
 public:
  explicit WallWalk(const DelaunayGraph& graph)
      : graph_(graph), reachable_(graph), seen_(graph.xy.size()) {}
  /// From then on walks throw TimeIsUp.
  void end_at(const Deadline& deadline) { deadline_ = deadline; }

  /// Calls found(v, order) for every useful edge uv of order 1 to `limit` with wanted(v).
  template <class Wanted, class Found>
  void from(VertexId u, Index limit, Towards towards, const Wanted& wanted, const Found& found) {
    begin(u, limit, towards);
    while (find_next()) {
      if (!wanted(candidate_)) continue;
      const Index order = useful_order();
      if (order <= limit) found(candidate_, order);
    }
  }

 private:
  /// The ends of the edges crossed so far on one side, each once: the last of them, in a tree.
  struct Chain {
    Index last, size;
  };
  struct Link {
    VertexId vertex;
    Index before;
  };
  /// An edge and what can be seen through it.
  struct Window {
    HalfEdgeId edge;  // on the side of u; from its right end to its left one
    VertexId left_ray, right_ray;
    Chain left, right;
  };

  /// Where a vertex has come up last.
  enum class Side { left, right, both };

  void begin(VertexId u, Index limit, Towards towards);
  bool find_next();
  void look_through(const Window& window);
  void add(const Window& window, Side side);
  Index useful_order();
  Chain longer(const Chain& chain, VertexId v);
  template <class IsBeyond>
  bool holds_more(const Chain& chain, HalfEdgeId from, const Circle& circle,
                  const IsBeyond& is_beyond);
  template <class IsInside>
  VertexId first_of(const Chain& chain, const IsInside& is_inside) const;

  const DelaunayGraph& graph_;
  Reachable reachable_;
  RoundMarks seen_;
  Deadline deadline_;
  VertexId u_;
  Index limit_ = 0;
  Towards towards_ = Towards::all;
  std::vector<Link> links_;
  std::vector<Window> windows_;
  std::vector<HalfEdgeId> reached_;  // scratch of holds_more()
  VertexId candidate_;
  Chain candidate_left_, candidate_right_;
};

}  // namespace hodt
