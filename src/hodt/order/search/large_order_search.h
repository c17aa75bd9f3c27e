// The useful edges of a vertex for orders in the hundreds and more.
#pragma once

#include <algorithm>
#include <vector>

#include "hodt/base/deadline.h"
#include "hodt/base/round_marks.h"
#include "hodt/order/delaunay_graph.h"
#include "hodt/order/search/angular_hulls.h"
#include "hodt/order/search/k_level.h"
#include "hodt/order/search/point_tree.h"

namespace hodt {

/// Inverts the plane at u: circles through u become lines, and the points inside a circle those
/// beyond its line, seen from the origin. First points show on hulls, and whether a circle holds
/// too many on the k-level. Edges that this does not rule out are few; the tree counts for them,
/// exactly. docs/design/useful-edges.md tells why nothing is missed and what it costs. Holds
/// scratch memory for one thread.
class LargeOrderSearch {
 public:
  LargeOrderSearch(const DelaunayGraph& graph, const PointTree& tree);
  /// From then on searches throw TimeIsUp.
  void end_at(const Deadline& deadline) { deadline_ = deadline; }

  /// Calls found(v, order) for every useful edge uv of order 1 to `limit` with wanted(v), in no
  /// particular order.
  template <class Wanted, class Found>
  void from(VertexId u, Index limit, const Wanted& wanted, const Found& found) {
    u_ = u;
    limit_ = limit;
    gather();
    sort_by_direction();
    build_hulls();
    for_each_candidate([&](VertexId v, VertexId first_left, VertexId first_right) {
      deadline_.check();
      if (!wanted(v)) return;
      const Index order = tree_.useful_order(u_, v, first_left, first_right, limit_);
      if (order <= limit_) found(v, order);
    });
  }

 private:
  struct Neighbour {
    VertexId vertex;
    bool is_ruled_out;  // a Delaunay neighbour, or no k-OD neighbour
  };

  void gather();
  void sort_by_direction();
  void build_hulls();
  template <class Candidate>
  void for_each_candidate(const Candidate& candidate) const;
  bool may_hold_few(Index i, Index first) const;
  Point image_of(VertexId v) const;

  const DelaunayGraph& graph_;
  const PointTree& tree_;
  Deadline deadline_;
  VertexId u_;
  Index limit_ = 0;
  double scale_ = 1;  // a power of two that brings offsets from u close to 1
  std::vector<Neighbour> around_;
  std::vector<Point> all_images_;       // parallel while it is being gathered
  std::vector<Point> points_, images_;  // parallel in the end
  KLevel level_;
  AngularHulls hulls_;
  RoundMarks seen_;
};

/// Goes around u, with the ends of the left and right sides turning along.
template <class Candidate>
void LargeOrderSearch::for_each_candidate(const Candidate& candidate) const {
  const auto n = static_cast<Index>(around_.size());
  Index left_end = 0, right_begin = 0;
  for (Index i = 0; i < n; ++i) {
    const auto turn_to = [&](Index j) {
      return orient(graph_.point(u_), points_[i], points_[j % n]);
    };
    deadline_.check();
    left_end = std::max(left_end, i + 1);
    while (left_end < i + n && turn_to(left_end) > 0) ++left_end;
    right_begin = std::max(right_begin, left_end);
    while (right_begin < i + n && turn_to(right_begin) == 0) ++right_begin;
    if (around_[i].is_ruled_out || left_end == i + 1 || right_begin == i + n) continue;
    const Index first_left = hulls_.first_on_left(i, i + 1, left_end);
    if (!may_hold_few(i, first_left)) continue;
    const Index first_right = hulls_.first_on_right(i, right_begin, i + n);
    if (!may_hold_few(i, first_right)) continue;
    candidate(around_[i].vertex, around_[first_left].vertex, around_[first_right].vertex);
  }
}

}  // namespace hodt
