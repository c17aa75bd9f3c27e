// The walk behind useful_edges.h: from a vertex outward through the triangles that segments cross.
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

/// Walks from one vertex after another. Up to 64 * kWords vertices nearby serve to cut the walk;
/// more of them pay for larger orders. Holds scratch memory for one thread.
/// docs/design/useful-edges.md tells how it works and why it is exact.
template <int kWords>
class WindowWalk {
 public:
  explicit WindowWalk(const DelaunayGraph& graph)
      : graph_(graph), counter_(graph), slot_of_(graph.xy.size(), kNoSlot) {}

  /// All edges from u of useful order 1 to `limit` whose other end `wanted` accepts; sorted by
  /// order, then by vertex. The result lives until the next call. `behind` says of a vertex that it
  /// lies in a half-plane without wanted ends. If both rays' vertices do, so does a window.
  /// After `effort` (steps, and points counted) the walk ends early; complete() tells.
  template <class Wanted, class Behind>
  const std::vector<UsefulEdge>& walk(VertexId u, Index limit, std::size_t effort,
                                      const Wanted& wanted, const Behind& behind) {
    begin(u, limit, effort);
    for_each_outgoing(graph_.mesh, graph_.outgoing[u], [&](HalfEdgeId h) {
      enter(TriangleMesh::next(h));
      for (; !stack_.empty() && effort_ > 0; --effort_) step(wanted, behind);
    });
    finish();
    return found_;
  }
  bool complete() const { return stack_.empty(); }

 private:
  using Mask = SlotMask<kWords>;
  using Sides = typename Slots<kWords>::Sides;
  static constexpr Index kSlots = Slots<kWords>::kCapacity;
  static constexpr std::uint16_t kNoSlot = 0xFFFF;

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

  void begin(VertexId u, Index limit, std::size_t effort);
  void finish();
  void gather_neighbourhood();
  void enter(HalfEdgeId opposite);
  Mask bit(VertexId v) const { return slot_of_[v] == kNoSlot ? Mask{} : Mask::only(slot_of_[v]); }
  Point offset_of(VertexId v) const {
    return {graph_.point(v).x - graph_.point(u_).x, graph_.point(v).y - graph_.point(u_).y};
  }
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
  std::size_t effort_ = 0;  // what is left
  std::vector<Node> stack_;
  // Vertices passed on the way to the node at hand; a node knows how many of them are its own.
  std::vector<VertexId> left_, right_;
  std::vector<UsefulEdge> found_;

  // The neighbourhood of u.
  Buffer<std::uint16_t> slot_of_;
  std::array<VertexId, kSlots> vertex_;
  Slots<kWords> slots_;
  double scale_ = 1;  // a power of two that brings coordinates relative to u close to 1
};

template <int kWords>
template <class Wanted, class Behind>
void WindowWalk<kWords>::step(const Wanted& wanted, const Behind& behind) {
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

  const Mask in_rw = try_left || try_w ? proven_inside(right, w) : Mask{};
  const Mask in_wl = try_right || try_w ? proven_inside(w, left) : Mask{};
  const Sides sides_of_w = visible ? proven_sides(w) : Sides{};
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

extern template class WindowWalk<1>;
extern template class WindowWalk<4>;
extern template class WindowWalk<16>;

}  // namespace hodt
