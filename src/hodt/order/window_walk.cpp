#include "hodt/order/window_walk.h"

#include <algorithm>

#include "hodt/base/lanes.h"
#include "hodt/geometry/predicates.h"

namespace hodt {

/// The neighbours get places, and theirs.
template <Index N>
HODT_INLINE void WindowWalk::begin_at(VertexId u) {
  if (++round_ == 1u << 26) {
    places_.fill(0);
    round_ = 1;
  }
  points_.clear(graph_.nearest(u));
  vertices_[0] = u;
  places_[u] = round_ * NearPoints::kMost;
  size_ = 1;
  expanded_ = 0;
  is_full_ = false;
  open_count_ = 0;
  open_.resize(std::max(open_.size(), std::size_t{NearPoints::kMost}));
  expand(0);
  const Index degree = size_;
  for (Index i = 1; i < degree && !is_full_; ++i) expand(i);
  take_up<N>();
}

/// The place of a vertex, a new one if it has none. (No floating point in here: what is called from
/// code in lanes had better be made for the same processor, or do without.)
Index WindowWalk::place_of(VertexId v) {
  const std::uint32_t known = places_[v];
  if (known / NearPoints::kMost == round_) return known % NearPoints::kMost;
  // Searches had better not go through hubs, and those that do not want a set that goes around.
  if (size_ == NearPoints::kMost || graph_.is_hub(v)) {
    is_full_ = true;
    return 0;
  }
  vertices_[size_] = v;
  places_[v] = round_ * NearPoints::kMost + size_;
  return size_++;
}

/// To be taken up afterwards.
void WindowWalk::expand(Index place) {
  expanded_ |= only(place);
  graph_.for_each_neighbour(vertices_[place], [&](VertexId w) { place_of(w); });
}

/// The points of new places.
template <Index N>
HODT_INLINE void WindowWalk::take_up() {
  const Point& u = point(0);
  for (Index i = points_.size(); i < size_; ++i)
    points_.set(i, {point(i).x - u.x, point(i).y - u.y});
  if (!points_.add<N>(size_)) is_full_ = true;
}

/// Adds a window unless nothing can come of it. That is a matter of chance: so no branch on it.
HODT_INLINE void WindowWalk::open(const Window& window) {
  const bool is_open = (count(window.inside_left) <= k_) & (count(window.inside_right) <= k_) &
                       // What is between two rays to smaller vertices is smaller itself.
                       (is_sought(window.left_ray) | is_sought(window.right_ray)) &
                       window.beyond.valid();
  open_[open_count_] = window;
  open_count_ += static_cast<std::size_t>(is_open);
}

template <Index N>
HODT_INLINE void WindowWalk::open_first_windows() {
  const TriangleMesh& mesh = graph_.mesh;
  const HalfEdgeId start = graph_.outgoing[vertices_[0]];
  HalfEdgeId h = start;
  do {
    const Index right = place_of(mesh.target(h)), left = place_of(mesh.apex(h));
    if (is_sought(left) || is_sought(right)) {
      const auto [by_left, by_right] =
          points_.split<N>(std::array{points_.left_of(left), points_.left_of(right)});
      open({.beyond = mesh.twin(TriangleMesh::next(h)),
            .left = left,
            .right = right,
            .left_ray = left,
            .right_ray = right,
            .beyond_left = by_left.in,
            .within = by_left.out & by_right.in,
            .beyond_right = by_right.out,
            .inside_left = only(left),
            .inside_right = only(right)});
    }
    h = mesh.rotate_ccw(h);
  } while (h.valid() && h != start);
}

/// 0 if the point is seen through the window, else +1 or -1: on its left ray or further left, on
/// its right ray or further right.
HODT_INLINE int WindowWalk::side_of(const Window& window, Index place) const {
  const PlaceSet it = only(place);
  if ((window.within & it) != 0) return 0;
  if ((window.beyond_left & it) != 0) return 1;
  if ((window.beyond_right & it) != 0) return -1;
  const Point &u = point(0), &p = point(place);
  if (orient(u, point(window.left_ray), p) >= 0) return 1;
  return orient(u, point(window.right_ray), p) <= 0 ? -1 : 0;
}

/// Goes on to the triangle beyond, with apex w: through its other two edges goes what is on either
/// side of it.
template <Index N>
HODT_INLINE void WindowWalk::pass(const Window& window) {
  const TriangleMesh& mesh = graph_.mesh;
  const VertexId vertex = mesh.apex(window.beyond);
  const Index w = place_of(vertex);
  if (w == points_.size()) take_up<N>();
  if (is_full_) return;
  const auto open_left = [&](Index right_ray, PlaceSet within, PlaceSet beyond_right,
                             PlaceSet inside) HODT_INLINE_LAMBDA {
    open({.beyond = mesh.twin(TriangleMesh::prev(window.beyond)),
          .left = window.left,
          .right = w,
          .left_ray = window.left_ray,
          .right_ray = right_ray,
          .beyond_left = window.beyond_left,
          .within = within,
          .beyond_right = beyond_right,
          .inside_left = window.inside_left | (inside & window.beyond_left),
          .inside_right = window.inside_right | (inside & beyond_right) | only(w)});
  };
  const auto open_right = [&](Index left_ray, PlaceSet beyond_left, PlaceSet within,
                              PlaceSet inside) HODT_INLINE_LAMBDA {
    open({.beyond = mesh.twin(TriangleMesh::next(window.beyond)),
          .left = w,
          .right = window.right,
          .left_ray = left_ray,
          .right_ray = window.right_ray,
          .beyond_left = beyond_left,
          .within = within,
          .beyond_right = window.beyond_right,
          .inside_left = window.inside_left | (inside & beyond_left) | only(w),
          .inside_right = window.inside_right | (inside & window.beyond_right)});
  };
  const int side = side_of(window, w);
  if (side > 0)
    return open_right(window.left_ray, window.beyond_left, window.within,
                      points_.split<N>(points_.inside(window.right, w)).in);
  if (side < 0)
    return open_left(window.right_ray, window.within, window.beyond_right,
                     points_.split<N>(points_.inside(w, window.left)).in);

  const auto [right_circle, left_circle, ray] = points_.split<N>(std::array{
      points_.inside(window.right, w), points_.inside(w, window.left), points_.left_of(w)});
  const PlaceSet inside_right = window.inside_right | (left_circle.in & ray.out);
  const PlaceSet inside_left = window.inside_left | (right_circle.in & ray.in);
  if (std::max(count(inside_left), count(inside_right)) <= k_ && is_sought(w))
    candidate_ = {vertex, w, window.left, window.right, ray};
  open_left(w, window.within & ray.in, ray.out, left_circle.in);
  open_right(w, ray.in, window.within & ray.out, right_circle.in);
}

bool WindowWalk::begin(VertexId u, Index k, Towards towards) {
  k_ = k;
  towards_ = towards;
  run_in_lanes([&]<Index N>() HODT_INLINE_LAMBDA {
    begin_at<N>(u);
    if (!is_full_) open_first_windows<N>();
  });
  return !is_full_;
}

bool WindowWalk::find_next() {
  candidate_.vertex = VertexId();
  run_in_lanes([&]<Index N>() HODT_INLINE_LAMBDA {
    while (open_count_ > 0 && !is_full_ && !candidate_.vertex.valid()) {
      // One is taken, two come at the most.
      if (open_.size() < open_count_ + 2) open_.resize(2 * open_.size());
      const Window window = open_[--open_count_];
      pass<N>(window);
    }
  });
  return candidate_.vertex.valid() && !is_full_;
}

/// The points inside the circle through u, the candidate v and the first point on a side, all of
/// them on the other side. `first` is any point of that side to begin with.
template <Index N, WindowWalk::Side side>
HODT_INLINE Index WindowWalk::count_across(Index first) {
  constexpr bool on_left = side == Side::left;
  const Index v = candidate_.place;
  const Point &u = point(0), &p = point(v);
  const auto is_here = [&](Index i) { return orient(u, p, point(i)) == (on_left ? 1 : -1); };
  const auto is_across = [&](Index i) { return orient(u, p, point(i)) == (on_left ? -1 : 1); };
  const auto is_inside = [&](Index i) {
    return on_left ? in_circle(u, p, point(first), point(i))
                   : in_circle(p, u, point(first), point(i));
  };
  for (;;) {
    const auto circle =
        points_.split<N>(on_left ? points_.inside(v, first) : points_.inside(first, v));
    const PlaceSet surely_here = on_left ? candidate_.ray.in : candidate_.ray.out;
    const PlaceSet surely_across = on_left ? candidate_.ray.out : candidate_.ray.in;
    const PlaceSet perhaps = points_.all() & ~(circle.out | only(v) | only(first));

    const Index before = first;
    for_each_place(perhaps & ~surely_across, [&](Index i) {
      if (is_here(i) && is_inside(i)) first = i;
    });
    if (first != before) continue;

    PlaceSet inside = circle.in & surely_across;
    for_each_place(perhaps & ~surely_here & ~inside, [&](Index i) {
      if (is_across(i) && is_inside(i)) inside |= only(i);
    });
    if (count(inside) > k_) return k_ + 1;
    // They are connected with u: all are known if the neighbours of all of them are.
    const PlaceSet rest = inside & ~expanded_;
    if (rest == 0) return count(inside);
    for_each_place(rest, [&](Index i) { expand(i); });
    if (!is_full_) take_up<N>();
    if (is_full_) return kNone;
    candidate_.ray = points_.split<N>(points_.left_of(v));
  }
}

Index WindowWalk::useful_order() {
  return run_in_lanes([&]<Index N>() HODT_INLINE_LAMBDA -> Index {
    const Index right = count_across<N, Side::left>(candidate_.left);
    if (right > k_) return right;
    const Index left = count_across<N, Side::right>(candidate_.right);
    return std::max(left, right);
  });
}

}  // namespace hodt
