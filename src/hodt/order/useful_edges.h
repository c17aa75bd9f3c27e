// Useful edges from a vertex: the edges that some triangulation of order k contains (Lemma 4).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hodt/order/circle_counter.h"
#include "hodt/order/delaunay_graph.h"
#include "hodt/order/slots.h"

namespace hodt {

/// An edge from a vertex that was asked about, with its useful order.
struct UsefulEdge {
  VertexId to;
  Index order = 0;
};

/// Finds the useful edges of a vertex beyond its Delaunay edges. Holds scratch memory for one
/// thread. docs/design/useful-edges.md tells how it works and why it is exact.
class UsefulEdgeSearch {
 public:
  explicit UsefulEdgeSearch(const DelaunayGraph& graph)
      : graph_(graph), counter_(graph), slot_of_(graph.xy.size(), kNoSlot) {}

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
  using Mask = Slots::Mask;
  using Sides = Slots::Sides;
  static constexpr Index kSlots = Slots::kCapacity;
  static constexpr std::uint8_t kNoSlot = 255;

  /// Segments from u across `edge` into directions strictly between two rays.
  struct Node {
    HalfEdgeId edge;  // crossed, seen from u: its origin on the right, target on the left
    VertexId left_ray, right_ray;
    Mask inside_left, inside_right;   // proven inside every later circle on that side
    Sides left_sides, right_sides;    // of the two rays
    Index passed_left, passed_right;  // the chains' lengths
    // A segment can pass the same vertex more than once, around the end of an edge that it does not
    // cross. The cut counts vertices once.
    Index distinct_left, distinct_right;
  };

  template <class Wanted, class Behind>
  const std::vector<UsefulEdge>& walk(VertexId u, Index limit, const Wanted& wanted,
                                      const Behind& behind) {
    begin(u, limit);
    for_each_outgoing(graph_.mesh, graph_.outgoing[u], [&](HalfEdgeId h) {
      enter(TriangleMesh::next(h));
      while (!stack_.empty()) step(wanted, behind);
    });
    finish();
    return found_;
  }

  void begin(VertexId u, Index limit);
  void finish();
  void gather_neighbourhood();
  void enter(HalfEdgeId opposite);
  Mask bit(VertexId v) const { return slot_of_[v] == kNoSlot ? 0 : Mask{1} << slot_of_[v]; }
  Mask proven_inside(VertexId right, VertexId left) const;
  Sides proven_sides(VertexId v) const;
  void push_if_hopeful(Node& child, Mask inside);
  bool too_many(Mask mask, Index passed) const;
  bool was_passed(VertexId v, Mask inside, const std::vector<VertexId>& chain, Index length) const;
  Index useful_order(VertexId v, Index passed_left, Index passed_right);
  VertexId first_point(const std::vector<VertexId>& chain, Index length, VertexId a,
                       VertexId b) const;

  template <class Wanted, class Behind>
  void step(const Wanted& wanted, const Behind& behind);

  const DelaunayGraph& graph_;
  CircleCounter counter_;
  VertexId u_;
  Index limit_ = 0;
  std::vector<Node> stack_;
  // Vertices passed on the way to the node at hand; a node knows how many of them are its own.
  std::vector<VertexId> left_, right_;
  std::vector<UsefulEdge> found_;

  // The neighbourhood of u.
  Buffer<std::uint8_t> slot_of_;
  std::array<VertexId, kSlots> vertex_;
  Slots slots_;
};

/// `behind` says of a vertex that it lies in a half-plane without wanted ends. If both rays'
/// vertices do, so does the whole window.
template <class Wanted, class Behind>
void UsefulEdgeSearch::step(const Wanted& wanted, const Behind& behind) {
  const Node node = stack_.back();
  stack_.pop_back();
  if (behind(node.left_ray) && behind(node.right_ray)) return;
  const HalfEdgeId across = graph_.mesh.twin(node.edge);
  if (!across.valid()) return;
  const VertexId right = graph_.mesh.origin(node.edge), left = graph_.mesh.origin(across);
  const VertexId w = graph_.mesh.apex(across);
  left_.resize(node.passed_left);
  right_.resize(node.passed_right);
  left_.back() = left;  // a popped sibling may have written its own vertex here
  right_.back() = right;

  const Point &pu = graph_.point(u_), &pw = graph_.point(w);
  const bool left_of_right_ray = orient(pu, graph_.point(node.right_ray), pw) > 0;
  const bool right_of_left_ray = orient(pu, pw, graph_.point(node.left_ray)) > 0;
  const bool visible = left_of_right_ray && right_of_left_ray;
  const bool try_left = left_of_right_ray && !too_many(node.inside_left | bit(w), 0);
  const bool try_right = right_of_left_ray && !too_many(node.inside_right | bit(w), 0);
  const bool try_w = visible && wanted(w);
  if (!try_left && !try_right && !try_w) return;

  const Mask in_rw = try_left || try_w ? proven_inside(right, w) : 0;
  const Mask in_wl = try_right || try_w ? proven_inside(w, left) : 0;
  const Sides sides_of_w = visible ? proven_sides(w) : Sides{0, 0};
  if (try_w && !too_many(node.inside_right | (in_wl & sides_of_w.right), 0) &&
      !too_many(node.inside_left | (in_rw & sides_of_w.left), 0)) {
    const Index order = useful_order(w, node.passed_left, node.passed_right);
    if (order <= limit_) found_.push_back({w, order});
  }
  if (try_left) {  // on across right -> w; w is passed on the left
    Node child = node;
    child.edge = TriangleMesh::next(across);
    if (visible) {
      child.left_ray = w;
      child.left_sides = sides_of_w;
    }
    child.inside_left |= bit(w);
    child.distinct_left += !was_passed(w, node.inside_left, left_, node.passed_left);
    ++child.passed_left;
    push_if_hopeful(child, in_rw);
  }
  if (try_right) {  // on across w -> left; w is passed on the right
    Node child = node;
    child.edge = TriangleMesh::prev(across);
    if (visible) {
      child.right_ray = w;
      child.right_sides = sides_of_w;
    }
    child.inside_right |= bit(w);
    child.distinct_right += !was_passed(w, node.inside_right, right_, node.passed_right);
    ++child.passed_right;
    push_if_hopeful(child, in_wl);
  }
}

}  // namespace hodt
