#include "hodt/order/search/window_walk.h"

#include <algorithm>
#include <utility>

#include "hodt/base/lanes.h"
#include "hodt/geometry/circle.h"
#include "hodt/geometry/predicates.h"

namespace hodt {

/// Not in the code in lanes (see place_of).
template <Index kWords>
void WindowWalk<kWords>::look_at_the_time() const {
  deadline_.check();
}

/// No points but u.
template <Index kWords>
void WindowWalk<kWords>::forget() {
  if (first_place_ < kPlaces) {
    places_ = Buffer<std::uint32_t>(graph_.xy.size(), kNone);
    first_place_ = kNone;
  }
  first_place_ -= kPlaces;
  places_[u_] = first_place_;
  vertices_[0] = u_;
  size_ = 1;
  expanded_ = {};
  is_full_ = false;
}

/// The place of a vertex, a new one if it has none. (No floating point in here: what is called from
/// code in lanes had better be made for the same processor, or do without.)
template <Index kWords>
Index WindowWalk<kWords>::place_of(VertexId v) {
  const Index known = places_[v] - first_place_;
  if (known < kPlaces) return known;
  if (size_ == Set::kMost) {
    is_full_ = true;
    return 0;
  }
  vertices_[size_] = v;
  places_[v] = first_place_ + size_;
  return size_++;
}

/// Its neighbours get places, to be taken up afterwards. False if they are too many.
template <Index kWords>
bool WindowWalk<kWords>::expand(Index place) {
  if (graph_.has_many_neighbours(vertices_[place])) return false;
  expanded_ |= Set::only(place);
  // Which of them have places is a matter of chance: so no branch on it.
  std::uint32_t* const places = places_.data();
  VertexId* const vertices = vertices_.data();
  const std::uint32_t first = first_place_;
  Index size = size_;
  graph_.for_each_neighbour_and_more(vertices_[place], [&](VertexId w, bool is_neighbour) {
    if (size > Set::kMost) return;
    const std::uint32_t known = places[w], next = (first + size) | (Index{is_neighbour} - 1);
    vertices[size] = w;
    places[w] = std::min(known, next);
    size += Index{known > next};
  });
  is_full_ |= size > Set::kMost;
  size_ = std::min(size, Set::kMost);
  return true;
}

/// The points of new places.
template <Index kWords>
template <Index N>
HODT_INLINE void WindowWalk<kWords>::add_new_points() {
  const Point& u = point(0);
  for (Index i = points_.size(); i < size_; ++i)
    points_.set(i, {point(i).x - u.x, point(i).y - u.y});
  if (!points_.template add<N>(size_)) is_full_ = true;
  const Set larger = points_.larger(), all = Set::first(Set::kMost);
  sought_ = towards_ == Towards::all ? all : towards_ == Towards::larger ? larger : all - larger;
}

/// For two more windows, where those passed were.
template <Index kWords>
void WindowWalk<kWords>::make_room() {
  std::copy(windows_.data() + passed_, windows_.data() + opened_, windows_.data());
  opened_ -= std::exchange(passed_, 0);
  if (opened_ + 2 > windows_.size() / 2) windows_.resize(2 * windows_.size());
}

/// Adds a window unless nothing can come of it. That is a matter of chance: so no branch on it.
template <Index kWords>
HODT_INLINE void WindowWalk<kWords>::add_window(const Window& window) {
  const bool is_open = (window.inside_left.count() <= k_) & (window.inside_right.count() <= k_) &
                       // What is between two rays to larger vertices is larger itself.
                       (is_sought(window.sector.left_ray) | is_sought(window.sector.right_ray)) &
                       window.beyond.valid();
  windows_[opened_] = window;
  opened_ += static_cast<std::size_t>(is_open);
}

/// The window through the edge across from u in the triangle that h, from u, belongs to.
template <Index kWords>
HODT_INLINE void WindowWalk<kWords>::add_first_window(HalfEdgeId h, const Ray& right,
                                                      const Ray& left) {
  const TriangleMesh& mesh = graph_.mesh;
  add_window({.beyond = mesh.twin(TriangleMesh::next(h)),
              .left = left.place,
              .right = right.place,
              .sector = {left.place, right.place, left.sides.in, left.sides.out & right.sides.in,
                         right.sides.out},
              .inside_left = Set::only(left.place),
              .inside_right = Set::only(right.place)});
}

/// Opens windows in all directions. The more points are known, the earlier the walk can end: to
/// begin with, the neighbours and theirs.
template <Index kWords>
template <Index N>
HODT_INLINE void WindowWalk<kWords>::begin_at_all() {
  const Index degree = size_ - 1;
  for (Index i = 1; i <= degree && size_ <= Set::kMost / 2; ++i) expand(i);
  add_new_points<N>();
  if (is_full_) return;
  // The neighbours have places 1, 2, ... around u.
  Ray right = ray_to<N>(1);
  const HalfEdgeId start = graph_.outgoing[u_];
  HalfEdgeId h = start;
  do {
    const Ray left = ray_to<N>(right.place < degree ? right.place + 1 : 1);
    add_first_window(h, right, left);
    right = left;
    h = graph_.mesh.rotate_ccw(h);
  } while (h.valid() && h != start);
}

/// Opens the window of the next triangle only. Of a vertex with very many neighbours each triangle
/// has its own points.
template <Index kWords>
template <Index N>
HODT_INLINE void WindowWalk<kWords>::begin_at_next() {
  look_at_the_time();
  const TriangleMesh& mesh = graph_.mesh;
  const HalfEdgeId h = next_;
  next_ = mesh.rotate_ccw(h);
  if (next_ == graph_.outgoing[u_]) next_ = HalfEdgeId();
  forget();
  points_.clear(nearest_);
  const Index right = place_of(mesh.target(h)), left = place_of(mesh.apex(h));
  for (const Index end : {right, left}) expand(end);
  add_new_points<N>();
  if (!is_full_) add_first_window(h, ray_to<N>(right), ray_to<N>(left));
}

/// 0 if the point is seen, else +1 or -1: on its left ray or further left, on
/// its right ray or further right.
template <Index kWords>
HODT_INLINE int WindowWalk<kWords>::side_of(const Sector& sector, Index place) const {
  if (sector.within.has(place)) return 0;
  if (sector.beyond_left.has(place)) return 1;
  if (sector.beyond_right.has(place)) return -1;
  const Point &u = point(0), &p = point(place);
  if (orient(u, point(sector.left_ray), p) >= 0) return 1;
  return orient(u, point(sector.right_ray), p) <= 0 ? -1 : 0;
}

/// Adds what is inside the circle through u and the ends of the edge although rounding leaves it in
/// doubt, until the window is seen to be no use. Where many points are close to one circle nothing
/// else ends the walk in time.
template <Index kWords>
void WindowWalk<kWords>::look_closer(Window& window, const Split& circle) const {
  const Circle exact(point(0), point(window.right), point(window.left));
  const Set doubtful = Set::first(size_) - circle.in - circle.out - Set::only(0) -
                       Set::only(window.left) - Set::only(window.right);
  bool is_open = std::max(window.inside_left.count(), window.inside_right.count()) <= k_;
  const auto add = [&](const Set& beyond, Set& inside) {
    if (!is_open) return;
    Index count = inside.count();
    is_open = !((doubtful & beyond) - inside).any_of([&](Index p) {
      if (exact.contains(point(p))) {
        inside |= Set::only(p);
        ++count;
      }
      return count > k_;
    });
  };
  add(window.sector.beyond_left, window.inside_left);
  add(window.sector.beyond_right, window.inside_right);
}

/// Goes on to the triangle beyond, with apex w: through its other two edges goes what is on either
/// side of it.
template <Index kWords>
template <Index N>
HODT_INLINE void WindowWalk<kWords>::look_through(const Window& window) {
  const TriangleMesh& mesh = graph_.mesh;
  const VertexId vertex = mesh.apex(window.beyond);
  const Index w = place_of(vertex);
  if (w == points_.size()) add_new_points<N>();
  if (is_full_) return;
  const auto add_through = [&](HalfEdgeId edge, Index left, Index right, const Sector& sector,
                               const Split& circle) HODT_INLINE_LAMBDA {
    Window next{
        .beyond = mesh.twin(edge),
        .left = left,
        .right = right,
        .sector = sector,
        .inside_left = window.inside_left | (circle.in & sector.beyond_left) | Set::only(left),
        .inside_right = window.inside_right | (circle.in & sector.beyond_right) | Set::only(right)};
    if constexpr (kWords > 1) look_closer(next, circle);
    add_window(next);
  };
  const HalfEdgeId to_left = TriangleMesh::prev(window.beyond);
  const HalfEdgeId to_right = TriangleMesh::next(window.beyond);
  const Sector& sector = window.sector;
  const int side = side_of(sector, w);
  if (side > 0)
    return add_through(to_right, w, window.right, sector,
                       points_.template split<N>(points_.inside(window.right, w)));
  if (side < 0)
    return add_through(to_left, window.left, w, sector,
                       points_.template split<N>(points_.inside(w, window.left)));

  const auto [right_circle, left_circle, ray] = points_.template split<N>(std::array{
      points_.inside(window.right, w), points_.inside(w, window.left), points_.left_of(w)});
  const Set inside_right = window.inside_right | (left_circle.in & ray.out);
  const Set inside_left = window.inside_left | (right_circle.in & ray.in);
  if (std::max(inside_left.count(), inside_right.count()) <= k_ && is_sought(w))
    candidate_ = {vertex, w, window.left, window.right, size_, left_circle, right_circle, ray};
  add_through(to_left, window.left, w,
              {sector.left_ray, w, sector.beyond_left, sector.within & ray.in, ray.out},
              left_circle);
  add_through(to_right, w, window.right,
              {w, sector.right_ray, ray.in, sector.within & ray.out, sector.beyond_right},
              right_circle);
}

template <Index kWords>
void WindowWalk<kWords>::begin(VertexId u, Index k, Towards towards) {
  u_ = u;
  k_ = k;
  towards_ = towards;
  nearest_ = graph_.nearest(u);
  passed_ = opened_ = 0;
  forget();
  if (windows_.empty()) windows_.resize(Set::kMost);
  if (expand(0) && !is_full_) {
    next_ = HalfEdgeId();
    points_.clear(nearest_);
    run_in_lanes([&]<Index N>() HODT_INLINE_LAMBDA { begin_at_all<N>(); });
  } else {
    is_full_ = false;
    next_ = graph_.outgoing[u];
  }
}

template <Index kWords>
bool WindowWalk<kWords>::find_next() {
  candidate_.vertex = VertexId();
  run_in_lanes([&]<Index N>() HODT_INLINE_LAMBDA {
    while (!is_full_ && !candidate_.vertex.valid()) {
      if (passed_ == opened_) {
        passed_ = opened_ = 0;
        if (!next_.valid()) break;
        begin_at_next<N>();
        continue;
      }
      if (opened_ + 2 > windows_.size()) [[unlikely]]
        make_room();
      const Window window = windows_[passed_++];
      look_through<N>(window);
    }
  });
  return candidate_.vertex.valid();
}

/// The points inside the circle through u, the candidate v and the first point on a side, all of
/// them on the other side. `first` is any point of that side to begin with.
template <Index kWords>
template <Index N, typename WindowWalk<kWords>::Side side>
HODT_INLINE Index WindowWalk<kWords>::count_in_first_circle(Index first, Split circle) {
  constexpr bool on_left = side == Side::left;
  const Index v = candidate_.place;
  const Set itself = Set::only(v);
  const Point &u = point(0), &p = point(v);
  const auto is_here = [&](Index i) { return orient(u, p, point(i)) == (on_left ? 1 : -1); };
  const auto is_across = [&](Index i) { return orient(u, p, point(i)) == (on_left ? -1 : 1); };
  const auto is_inside = [&](Index i) {
    return on_left ? in_circle(u, p, point(first), point(i))
                   : in_circle(p, u, point(first), point(i));
  };
  const auto through_first = [&]() HODT_INLINE_LAMBDA {
    return on_left ? points_.inside(v, first) : points_.inside(first, v);
  };
  // The points inside are connected with u, and with v: all are known if the neighbours of all of
  // them are, and those of u or of v.
  Set rest = expanded_.has(0) || expanded_.has(v) ? Set() : itself;
  Index known = candidate_.known;
  for (;;) {
    bool is_known = true;
    rest.for_each([&](Index i) { is_known &= expand(i); });
    if (points_.size() < size_ && !is_full_) add_new_points<N>();
    if (is_full_ || !is_known) return kNone;
    if (known < size_) {
      known = size_;
      const auto [new_circle, new_ray] =
          points_.template split<N>(std::array{through_first(), points_.left_of(v)});
      circle = new_circle;
      candidate_.ray = new_ray;
    }
    const Set& surely_here = on_left ? candidate_.ray.in : candidate_.ray.out;
    const Set& surely_across = on_left ? candidate_.ray.out : candidate_.ray.in;
    const Set perhaps = Set::first(size_) - circle.out - itself - Set::only(first);

    const Index before = first;
    (perhaps - surely_across).for_each([&](Index i) {
      if (is_here(i) && is_inside(i)) first = i;
    });
    rest = {};
    if (first != before) {
      circle = points_.template split<N>(through_first());
      continue;
    }

    Set inside = circle.in & surely_across;
    (perhaps - surely_here - inside).for_each([&](Index i) {
      if (is_across(i) && is_inside(i)) inside |= Set::only(i);
    });
    const Index count = inside.count();
    if (count > k_) return k_ + 1;
    rest = inside - expanded_;
    if (rest.is_empty()) return count;
  }
}

template <Index kWords>
Index WindowWalk<kWords>::useful_order() {
  return run_in_lanes([&]<Index N>() HODT_INLINE_LAMBDA -> Index {
    const Index right =
        count_in_first_circle<N, Side::left>(candidate_.left, candidate_.left_circle);
    if (right > k_) return right;
    const Index left =
        count_in_first_circle<N, Side::right>(candidate_.right, candidate_.right_circle);
    return std::max(left, right);
  });
}

template class WindowWalk<1>;
template class WindowWalk<4>;
template class WindowWalk<16>;

}  // namespace hodt
