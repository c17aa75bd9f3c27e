#include "hodt/order/constrained/wall_walk.h"

#include <algorithm>

#include "hodt/geometry/circle.h"
#include "hodt/geometry/predicates.h"
#include "hodt/order/constrained/around.h"

namespace hodt {

void WallWalk::begin(VertexId u, Index limit, Towards towards) {
  u_ = u;
  limit_ = limit;
  towards_ = towards;
  links_.clear();
  windows_.clear();
  const TriangleMesh& mesh = graph_.mesh;
  for_each_outgoing(mesh, graph_.outgoing[u], [&](HalfEdgeId h) {
    const VertexId right = mesh.target(h), left = mesh.apex(h);
    constexpr Chain none{kNone, 0};
    add({TriangleMesh::next(h), left, right, longer(none, left), longer(none, right)}, Side::both);
  });
}

bool WallWalk::find_next() {
  candidate_ = VertexId();
  while (!windows_.empty() && !candidate_.valid()) {
    deadline_.check();
    const Window window = windows_.back();
    windows_.pop_back();
    look_through(window);
  }
  return candidate_.valid();
}

/// An edge can dangle between crossed triangles on both of its sides: then the crossed edges come
/// back to its other end.
WallWalk::Chain WallWalk::longer(const Chain& chain, VertexId v) {
  const VertexId place = graph_.place_of(v);
  for (Index i = chain.last; i != kNone; i = links_[i].before)
    if (graph_.place_of(links_[i].vertex) == place) return chain;
  links_.push_back({v, chain.last});
  return {static_cast<Index>(links_.size() - 1), chain.size + 1};
}

/// Adds a window unless nothing can come of it. Looks around on the side of the last vertex only:
/// on the other one little is new.
void WallWalk::add(const Window& window, Side side) {
  if (is_closed(graph_, window.edge)) return;
  // What is between two rays to larger vertices is larger itself.
  if (!leads(graph_, u_, window.left_ray, towards_) &&
      !leads(graph_, u_, window.right_ray, towards_))
    return;
  const TriangleMesh& mesh = graph_.mesh;
  const Point &u = graph_.point(u_), &left_ray = graph_.point(window.left_ray),
              &right_ray = graph_.point(window.right_ray);
  const Circle circle(u, graph_.point(mesh.origin(window.edge)),
                      graph_.point(mesh.target(window.edge)));
  const auto is_right = [&](const Point& p) { return orient(u, right_ray, p) < 0; };
  const auto is_left = [&](const Point& p) { return orient(u, left_ray, p) > 0; };
  if (side != Side::left && holds_more(window.right, window.edge, circle, is_right)) return;
  if (side != Side::right &&
      holds_more(window.left, TriangleMesh::next(window.edge), circle, is_left))
    return;
  windows_.push_back(window);
}

/// Whether more than the limit are in the chain, or inside the circle and beyond the window on that
/// side, reached from the chain's last one through points of that kind. `from` leaves that one.
template <class IsBeyond>
bool WallWalk::holds_more(const Chain& chain, HalfEdgeId from, const Circle& circle,
                          const IsBeyond& is_beyond) {
  Index count = chain.size;
  if (count > limit_) return true;
  seen_.begin_round();
  seen_.mark(graph_.place_of(u_));
  for (Index i = chain.last; i != kNone; i = links_[i].before)
    seen_.mark(graph_.place_of(links_[i].vertex));
  reached_.assign(1, from);
  for (std::size_t i = 0; i < reached_.size() && count <= limit_; ++i)
    for_each_reached_around(
        graph_, reached_[i], [](HalfEdgeId) {},
        [&](HalfEdgeId h) {
          const VertexId v = graph_.mesh.origin(h);
          if (!seen_.mark(graph_.place_of(v))) return;
          const Point& p = graph_.point(v);
          if (!is_beyond(p) || !circle.contains(p)) return;
          ++count;
          reached_.push_back(h);
        });
  return count > limit_;
}

/// Goes on to the triangle beyond, with apex w: through its other two edges goes what is on either
/// side of it.
void WallWalk::look_through(const Window& window) {
  const TriangleMesh& mesh = graph_.mesh;
  const HalfEdgeId beyond = mesh.twin(window.edge);  // from left to right
  const HalfEdgeId to_right = TriangleMesh::next(beyond), to_left = TriangleMesh::prev(beyond);
  const VertexId w = mesh.origin(to_left);
  const Point &u = graph_.point(u_), &p = graph_.point(w);
  if (orient(u, graph_.point(window.left_ray), p) >= 0) {
    add({to_right, window.left_ray, window.right_ray, longer(window.left, w), window.right},
        Side::left);
  } else if (orient(u, graph_.point(window.right_ray), p) <= 0) {
    add({to_left, window.left_ray, window.right_ray, window.left, longer(window.right, w)},
        Side::right);
  } else {
    if (leads(graph_, u_, w, towards_)) {
      candidate_ = w;
      candidate_left_ = window.left;
      candidate_right_ = window.right;
    }
    add({to_left, window.left_ray, w, window.left, longer(window.right, w)}, Side::right);
    add({to_right, w, window.right_ray, longer(window.left, w), window.right}, Side::left);
  }
}

/// Of the chain's vertices the one whose circle holds none of the others.
template <class IsInside>
VertexId WallWalk::first_of(const Chain& chain, const IsInside& is_inside) const {
  VertexId first = links_[chain.last].vertex;
  for (Index i = links_[chain.last].before; i != kNone; i = links_[i].before)
    if (is_inside(first, links_[i].vertex)) first = links_[i].vertex;
  return first;
}

/// By Lemma 4. The first points are among the chains, as the triangles beside uv in the constrained
/// Delaunay triangulation with uv take the place of those that uv crosses.
Index WallWalk::useful_order() {
  const VertexId u = u_, v = candidate_;
  const Point &a = graph_.point(u), &b = graph_.point(v);
  const VertexId left = first_of(candidate_left_, [&](VertexId first, VertexId w) {
    return in_circle(a, b, graph_.point(first), graph_.point(w));
  });
  const Index on_right = reachable_.count(u, v, left, limit_);
  if (on_right > limit_) return on_right;
  const VertexId right = first_of(candidate_right_, [&](VertexId first, VertexId w) {
    return in_circle(b, a, graph_.point(first), graph_.point(w));
  });
  return std::max(on_right, reachable_.count(v, u, right, limit_));
}

}  // namespace hodt
