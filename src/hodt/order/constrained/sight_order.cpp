#include "hodt/order/constrained/sight_order.h"

#include <algorithm>

#include "hodt/geometry/predicates.h"
#include "hodt/order/constrained/around.h"
#include "hodt/order/segment_walk.h"

namespace hodt {

Index SightOrder::operator()(VertexId u, VertexId v, Index limit) {
  u_ = graph_.point(u);
  v_ = graph_.point(v);
  cross(u, v);
  // The ends alone are mostly enough to see that there are too many.
  take_ends(kLeft);
  take_ends(kRight);
  if (fewest() > limit) return limit + 1;
  find_reached(kLeft, limit);
  find_reached(kRight, limit);
  return std::min(fewest(), limit + 1);
}

/// Whether the circles pass p before q.
bool SightOrder::is_before(const Passed& p, const Passed& q) const {
  if (p.at.is_surely_before(q.at)) return true;
  if (q.at.is_surely_before(p.at)) return false;
  const Point &at_p = graph_.point(p.vertex), &at_q = graph_.point(q.vertex);
  if (at_p == at_q) return false;
  // Where q is passed, p on the left is inside already, or p on the right is outside.
  const bool is_inside =
      q.side == kLeft ? in_circle(u_, v_, at_q, at_p) : in_circle(v_, u_, at_q, at_p);
  return is_inside == (p.side == kLeft);
}

/// Finds the ends of the edges that uv crosses.
void SightOrder::cross(VertexId u, VertexId v) {
  for (auto& ends : ends_) ends.clear();
  const TriangleMesh& mesh = graph_.mesh;
  const auto add = [&](HalfEdgeId from) {
    const VertexId w = mesh.origin(from);
    const Point& p = graph_.point(w);
    const Side side = orient(u_, v_, p) > 0 ? kLeft : kRight;
    if (ends_[side].empty() || ends_[side].back().vertex != w)
      ends_[side].push_back({Passing::of(u_, v_, p), w, side, from});
  };
  for_each_crossed(mesh, graph_.xy, graph_.outgoing.all(), u, v, [&](HalfEdgeId h) {
    add(h);
    add(TriangleMesh::next(h));
  });
}

bool SightOrder::is_among(const std::vector<Reached>& reached, VertexId v) const {
  const VertexId place = graph_.place_of(v);
  return std::any_of(reached.begin(), reached.end(),
                     [&](const Reached& each) { return graph_.place_of(each.vertex) == place; });
}

/// As if nothing else were reached.
void SightOrder::take_ends(Side side) {
  auto& reached = reached_[side];
  reached.clear();
  for (const Passed& end : ends_[side])
    if (!is_among(reached, end.vertex)) reached.push_back({end.vertex, end});
  std::sort(reached.begin(), reached.end(),
            [&](const Reached& p, const Reached& q) { return is_inside_first(p.after, q.after); });
}

/// Finds those reached first, at most limit + 1 of them.
void SightOrder::find_reached(Side side, Index limit) {
  const TriangleMesh& mesh = graph_.mesh;
  auto& reached = reached_[side];
  reached.clear();
  waiting_.clear();
  gone_around_.clear();
  seen_.begin_round();
  for (const Passed& end : ends_[side]) wait_for(end);
  Passed after{};
  while (!waiting_.empty() && reached.size() <= limit) {
    std::pop_heap(waiting_.begin(), waiting_.end(),
                  [&](const Passed& p, const Passed& q) { return is_inside_first(q, p); });
    const Passed next = waiting_.back();
    waiting_.pop_back();
    if (!after.vertex.valid() || is_inside_first(after, next)) after = next;
    const bool is_parted = graph_.is_parted(next.vertex);
    if (!is_parted || !is_among(reached, next.vertex)) reached.push_back({next.vertex, after});
    for_each_reached_around(
        graph_, next.from,
        [&](HalfEdgeId h) {
          if (is_parted) gone_around_.push_back(h);
        },
        [&](HalfEdgeId h) {
          const VertexId w = mesh.origin(h);
          const Point& p = graph_.point(w);
          if (orient(u_, v_, p) == (side == kLeft ? 1 : -1))
            wait_for({Passing::of(u_, v_, p), w, side, h});
        });
  }
}

/// Unless it does already, or has been gone around.
void SightOrder::wait_for(const Passed& p) {
  if (!seen_.mark(p.vertex)) {
    if (!graph_.is_parted(p.vertex)) return;
    // Perhaps from another side.
    if (std::find(gone_around_.begin(), gone_around_.end(), p.from) != gone_around_.end()) return;
  }
  waiting_.push_back(p);
  std::push_heap(waiting_.begin(), waiting_.end(),
                 [&](const Passed& q, const Passed& r) { return is_inside_first(r, q); });
}

/// Of all circles: where the next one on the left would be reached, or all of them are.
Index SightOrder::fewest() const {
  const auto &left = reached_[kLeft], &right = reached_[kRight];
  std::size_t still = right.size(), fewest = left.size();
  for (std::size_t i = 0; i < left.size(); ++i) {
    while (still > 0 && !is_before(left[i].after, right[still - 1].after)) --still;
    fewest = std::min(fewest, i + still);
  }
  return static_cast<Index>(fewest);
}

}  // namespace hodt
