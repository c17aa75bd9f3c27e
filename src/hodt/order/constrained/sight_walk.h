// What a vertex sees where there are walls, as far as edges of some order can lead.
// Tested by tests/order/constrained_order_test.cpp.
#pragma once

#include <array>
#include <vector>

#include "hodt/base/buffer.h"
#include "hodt/base/deadline.h"
#include "hodt/order/delaunay_graph.h"
#include "hodt/order/search/search_policy.h"

namespace hodt {

/// Walks outward from a vertex u, from triangle to triangle, with the window of directions still in
/// sight; a wall ends it, and so does what is certainly inside all circles that go further:
///
/// Of the ends of an edge that uv crosses one is inside any circle through u and v. (Otherwise u or
/// v would be inside the circle of the triangle on its side of the edge, and reached: see
/// reachable.h.) So the ends that are inside cover the crossed edges, and there are as many as the
/// smallest cover has. Each window carries that number for the covers that hold both ends of its
/// edge, or just one.
///
/// Holds scratch memory for one thread.
class SightWalk {
 public:
  explicit SightWalk(const DelaunayGraph& graph) : graph_(graph) {}
  /// From then on walks throw TimeIsUp.
  void end_at(const Deadline& deadline) { deadline_ = deadline; }

  /// Calls found(v) for every vertex v that u sees across edges, unless all circles through both
  /// hold more than `limit` vertices that are reached from uv; for some others, too.
  template <class Found>
  void from(VertexId u, Index limit, Towards towards, const Found& found) {
    begin(u, limit, towards);
    while (find_next()) found(candidate_);
    end();
  }

 private:
  /// An edge, what can be seen through it, and how many ends of edges crossed so far are inside.
  struct Window {
    HalfEdgeId edge;  // on the side of u; from its right end to its left one
    VertexId left_ray, right_ray;
    std::array<VertexId, 2> joined;  // the ends that the window before this one does not have
    Index left_only, right_only, both;
  };

  void begin(VertexId u, Index limit, Towards towards);
  void end();
  bool find_next();
  void look_through(const Window& window);
  void pass_on_left(const Window& window, HalfEdgeId edge, VertexId left_ray, VertexId w);
  void pass_on_right(const Window& window, HalfEdgeId edge, VertexId right_ray, VertexId w);
  void add(const Window& window);
  Index count_of(VertexId v) const { return is_passed_[graph_.place_of(v)] ? 0 : 1; }
  void mark_joined(const Window& window);
  void unmark_joined(const Window& window);

  const DelaunayGraph& graph_;
  Deadline deadline_;
  VertexId u_;
  Index limit_ = 0;
  Towards towards_ = Towards::all;
  VertexId candidate_;
  /// To look through; without an edge, that all beyond the window of `joined` is done.
  std::vector<Window> windows_;
  /// By place, the ends of the edges that lead to the window looked through: where crossed edges
  /// come back to one, it counts once.
  Buffer<bool> is_passed_;
};

}  // namespace hodt
