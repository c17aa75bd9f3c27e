// The order of an edge where there are walls.
// Tested by tests/order/constrained_order_test.cpp.
#pragma once

#include <array>
#include <vector>

#include "hodt/base/round_marks.h"
#include "hodt/order/delaunay_graph.h"
#include "hodt/order/search/passing.h"

namespace hodt {

/// Sweeps the circles through two vertices that see each other, from the half-plane on the right of
/// the edge uv to the one on the left. What is inside on the left grows, and so does what is
/// reached there, as a path that leaves the left side comes back across uv: each vertex on the left
/// has a place from which on it is reached, and each on the right one up to which it is. These are
/// found by going outward from the ends of the edges that uv crosses, always on from the vertex
/// that is inside first: its place, or the last one that had to be waited for before.
///
/// Holds scratch memory for one thread.
class SightOrder {
 public:
  explicit SightOrder(const DelaunayGraph& graph) : graph_(graph), seen_(graph.xy.size()) {}

  /// The fewest vertices that are inside a circle through u and v and reached from uv, or limit + 1
  /// if there are more. REQUIRES that uv is no edge, and neither a wall nor a vertex is on it.
  Index operator()(VertexId u, VertexId v, Index limit);

 private:
  enum Side { kLeft, kRight };
  /// A vertex beside uv.
  struct Passed {
    Passing at;
    VertexId vertex;
    Side side;
    HalfEdgeId from;  // leaves it, in a triangle that is reached
  };
  /// A vertex, and the one after whose passing it is reached: that one or itself.
  struct Reached {
    VertexId vertex;
    Passed after;
  };

  bool is_before(const Passed& p, const Passed& q) const;
  /// Of two on the same side.
  bool is_inside_first(const Passed& p, const Passed& q) const {
    return p.side == kLeft ? is_before(p, q) : is_before(q, p);
  }
  void cross(VertexId u, VertexId v);
  void take_ends(Side side);
  void find_reached(Side side, Index limit);
  void wait_for(const Passed& p);
  bool is_among(const std::vector<Reached>& reached, VertexId v) const;
  Index fewest() const;

  const DelaunayGraph& graph_;
  Point u_, v_;
  /// By side, the ends of the edges that uv crosses; one can come several times.
  std::array<std::vector<Passed>, 2> ends_;
  /// By side, in the order in which they are reached while that side grows; each once.
  std::array<std::vector<Reached>, 2> reached_;
  // Scratch of find_reached().
  std::vector<Passed> waiting_;  // a heap, the first one inside at the top
  RoundMarks seen_;
  std::vector<HalfEdgeId> gone_around_;  // at parted vertices
};

}  // namespace hodt
