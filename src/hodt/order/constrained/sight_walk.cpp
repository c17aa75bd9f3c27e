#include "hodt/order/constrained/sight_walk.h"

#include <algorithm>

#include "hodt/geometry/predicates.h"
#include "hodt/order/constrained/around.h"

namespace hodt {

void SightWalk::begin(VertexId u, Index limit, Towards towards) {
  if (is_passed_.empty()) is_passed_ = Buffer<bool>(graph_.xy.size(), false);
  end();  // if the walk before was broken off
  u_ = u;
  limit_ = limit;
  towards_ = towards;
  const TriangleMesh& mesh = graph_.mesh;
  for_each_outgoing(mesh, graph_.outgoing[u], [&](HalfEdgeId h) {
    const VertexId right = mesh.target(h), left = mesh.apex(h);
    add({TriangleMesh::next(h), left, right, {left, right}, 1, 1, 2});
  });
}

void SightWalk::end() {
  for (const Window& window : windows_)
    if (!window.edge.valid()) unmark_joined(window);
  windows_.clear();
}

bool SightWalk::find_next() {
  candidate_ = VertexId();
  while (!windows_.empty() && !candidate_.valid()) {
    deadline_.check();
    const Window window = windows_.back();
    windows_.pop_back();
    if (window.edge.valid())
      look_through(window);
    else
      unmark_joined(window);
  }
  return candidate_.valid();
}

/// Until all beyond the window is done.
void SightWalk::mark_joined(const Window& window) {
  Window done{};
  for (std::size_t i = 0; i < window.joined.size(); ++i) {
    const VertexId v = window.joined[i];
    if (!v.valid() || count_of(v) == 0) continue;
    is_passed_[graph_.place_of(v)] = true;
    done.joined[i] = v;
  }
  windows_.push_back(done);
}

void SightWalk::unmark_joined(const Window& window) {
  for (const VertexId v : window.joined)
    if (v.valid()) is_passed_[graph_.place_of(v)] = false;
}

void SightWalk::add(const Window& window) {
  if (std::min({window.left_only, window.right_only, window.both}) > limit_) return;
  if (is_closed(graph_, window.edge)) return;
  // What is between two rays to larger vertices is larger itself.
  if (!leads(graph_, u_, window.left_ray, towards_) &&
      !leads(graph_, u_, window.right_ray, towards_))
    return;
  windows_.push_back(window);
}

/// Goes on to the triangle beyond, with apex w: through its other two edges goes what is on either
/// side of it.
void SightWalk::look_through(const Window& window) {
  mark_joined(window);
  const TriangleMesh& mesh = graph_.mesh;
  const HalfEdgeId beyond = mesh.twin(window.edge);  // from left to right
  const HalfEdgeId to_right = TriangleMesh::next(beyond), to_left = TriangleMesh::prev(beyond);
  const VertexId w = mesh.origin(to_left);
  const Point &u = graph_.point(u_), &p = graph_.point(w);
  if (orient(u, graph_.point(window.left_ray), p) >= 0)
    return pass_on_left(window, to_right, window.left_ray, w);
  if (orient(u, graph_.point(window.right_ray), p) <= 0)
    return pass_on_right(window, to_left, window.right_ray, w);
  if (leads(graph_, u_, w, towards_)) candidate_ = w;
  pass_on_right(window, to_left, w, w);
  pass_on_left(window, to_right, w, w);
}

/// Through the edge between w, on the left, and the right end. If that end is not inside, the left
/// one of the window is.
void SightWalk::pass_on_left(const Window& window, HalfEdgeId edge, VertexId left_ray, VertexId w) {
  const Index of_w = count_of(w), right = std::min(window.both, window.right_only);
  add({edge, left_ray, window.right_ray, {w, {}}, window.left_only + of_w, right, right + of_w});
}

void SightWalk::pass_on_right(const Window& window, HalfEdgeId edge, VertexId right_ray,
                              VertexId w) {
  const Index of_w = count_of(w), left = std::min(window.both, window.left_only);
  add({edge, window.left_ray, right_ray, {w, {}}, left, window.right_only + of_w, left + of_w});
}

}  // namespace hodt
