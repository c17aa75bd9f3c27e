#include "hodt/delaunay/divide_and_conquer.h"

#include <algorithm>
#include <bit>
#include <utility>
#include <vector>

#include "hodt/base/parallel.h"
#include "hodt/geometry/predicates.h"

// Divide and conquer after Guibas and Stolfi, on triangles after Shewchuk: beyond every hull edge
// lies a ghost triangle with the corner "infinity", so that a triangulation of m vertices, however
// degenerate, has exactly 2m - 2 triangles. Vertices [lo, hi) use the slots [2 lo, 2 hi - 2). A
// merge adds the two slots in between, turns the ghosts of the two facing chains into the triangles
// that join them, and deletes edges by flips with a ghost. So nothing is ever allocated or freed,
// every range of vertices has its own range of memory, and halves can be solved in parallel.
//
// Ghost of the hull edge a -> b (counter-clockwise, the triangulation to its left), in slots
// 3t, 3t + 1, 3t + 2, always in this rotation:
//
//          infinity
//           *                   3t      b -> a         its twin is the hull half-edge a -> b
//          / \                  3t + 1  a -> infinity  the handle of the ghost, and of vertex a
//         / t \                 3t + 2  infinity -> b
//      a *-----* b
//         hull                  twin(3t + 2) is the handle of the following ghost, which starts at
//         b.
//
// Collinear points need no special case: their triangulation is a path with ghosts on both sides.

namespace hodt {

namespace {

constexpr Index kInfinity = kNone;      // the ghosts' third corner
constexpr Index kNoGhost = kNone;       // of a single point, which has no hull edge
constexpr Index kParallelSize = 10000;  // smaller ranges are not worth a task

/// A triangulated range of vertices: two of its ghosts, or a single point and no ghost.
struct Part {
  Index low = kNoGhost;   ///< handle of the ghost below (of the last merge; any ghost will do)
  Index high = kNoGhost;  ///< handle of the ghost above
  Index single = kNone;   ///< the vertex, if there is only one
};

/// The direction in which a range is cut: x cuts left from right, y below from above.
enum class Axis { x, y };

/// Later along the axis. Ties go by the other coordinate, in the sense that makes a cut along y the
/// cut along x turned by a quarter.
bool is_beyond(Axis axis, const Point& p, const Point& q) {
  if (axis == Axis::x) return p.x > q.x || (p.x == q.x && p.y > q.y);
  return p.y > q.y || (p.y == q.y && p.x < q.x);
}

class Triangulator {
 public:
  Triangulator(const Point* points, const std::uint64_t* keys, Index* origin, Index* twin)
      : points_(points), keys_(keys), origin_(origin), twin_(twin) {}

  Part solve(Index lo, Index hi) const;

 private:
  struct Cut {
    Index at;
    Axis axis;
  };

  static Index prev(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
  const Point& point(Index v) const { return points_[v]; }
  int turn(Index a, Index b, Index c) const { return orient(point(a), point(b), point(c)); }
  bool inside(Index a, Index b, Index c, Index d) const {
    return in_circle(point(a), point(b), point(c), point(d));
  }

  // Ghosts by their handles.
  Index start_of(Index ghost) const { return origin_[ghost]; }
  Index end_of(Index ghost) const { return origin_[ghost - 1]; }
  Index following(Index ghost) const { return twin_[ghost + 1]; }
  Index preceding(Index ghost) const { return twin_[ghost] - 1; }
  Index hull_halfedge(Index ghost) const { return twin_[ghost - 1]; }

  void glue(Index h, Index g) const {
    twin_[h] = g;
    twin_[g] = h;
  }
  void chain(Index ghost, Index next_ghost) const { glue(ghost + 1, next_ghost); }
  Index make_ghost(Index slot, Index a, Index b) const {
    origin_[3 * slot] = b;
    origin_[3 * slot + 1] = a;
    origin_[3 * slot + 2] = kInfinity;
    return 3 * slot + 1;
  }

  Cut cut(Index lo, Index hi) const;
  Part solve_two(Index lo) const;
  Part solve_three(Index lo) const;
  Part solve_path(Index a, Index b, Index c, Index slot) const;
  Index extreme(Index ghost, Axis axis, bool beyond) const;
  Part merge(Part left, Part right, Axis axis, Index free_slot) const;
  void advance_left(Index ghost, Index l, Index r) const;
  void advance_right(Index ghost, Index l, Index r) const;

  const Point* points_;
  const std::uint64_t* keys_;
  Index* origin_;
  Index* twin_;
};

/// Cuts where the highest differing bit of the keys changes. Equal keys are in lexicographic order,
/// where any place is a cut along x.
Triangulator::Cut Triangulator::cut(Index lo, Index hi) const {
  const std::uint64_t first = keys_[lo], last = keys_[hi - 1];
  if (first == last) return {lo + (hi - lo) / 2, Axis::x};
  const int bit = 63 - std::countl_zero(first ^ last);
  const std::uint64_t border = last >> bit << bit;
  const auto at = std::lower_bound(keys_ + lo, keys_ + hi, border);
  return {static_cast<Index>(at - keys_), bit % 2 == 1 ? Axis::y : Axis::x};
}

Part Triangulator::solve(Index lo, Index hi) const {
  switch (hi - lo) {
    case 1:
      return {.single = lo};
    case 2:
      return solve_two(lo);
    case 3:
      return solve_three(lo);
  }
  const Cut c = cut(lo, hi);
  Part below, above;
  if (hi - lo < kParallelSize) {
    below = solve(lo, c.at);
    above = solve(c.at, hi);
  } else {
    parallel_invoke([&] { below = solve(lo, c.at); }, [&] { above = solve(c.at, hi); });
  }
  return merge(below, above, c.axis, 2 * c.at - 2);
}

Part Triangulator::solve_two(Index lo) const {
  const Index there = make_ghost(2 * lo, lo, lo + 1);
  const Index back = make_ghost(2 * lo + 1, lo + 1, lo);
  glue(there - 1, back - 1);
  chain(there, back);
  chain(back, there);
  return {.low = there, .high = back};
}

Part Triangulator::solve_three(Index lo) const {
  Index a = lo, b = lo + 1, c = lo + 2;
  const int sign = turn(a, b, c);
  const Index slot = 2 * lo;
  if (sign == 0) {
    const auto less = [&](Index p, Index q) { return lexicographically_less(point(p), point(q)); };
    if (less(b, a)) std::swap(a, b);
    if (less(c, b)) std::swap(b, c);
    if (less(b, a)) std::swap(a, b);
    return solve_path(a, b, c, slot);
  }
  if (sign < 0) std::swap(b, c);
  const Index h = 3 * slot;
  origin_[h] = a;
  origin_[h + 1] = b;
  origin_[h + 2] = c;
  const Index ab = make_ghost(slot + 1, a, b);
  const Index bc = make_ghost(slot + 2, b, c);
  const Index ca = make_ghost(slot + 3, c, a);
  glue(h, ab - 1);
  glue(h + 1, bc - 1);
  glue(h + 2, ca - 1);
  chain(ab, bc);
  chain(bc, ca);
  chain(ca, ab);
  return {.low = ab, .high = ca};
}

Part Triangulator::solve_path(Index a, Index b, Index c, Index slot) const {
  const Index ab = make_ghost(slot, a, b), bc = make_ghost(slot + 1, b, c);
  const Index cb = make_ghost(slot + 2, c, b), ba = make_ghost(slot + 3, b, a);
  glue(ab - 1, ba - 1);
  glue(bc - 1, cb - 1);
  chain(ab, bc);
  chain(bc, cb);
  chain(cb, ba);
  chain(ba, ab);
  return {.low = ab, .high = cb};
}

/// The handle of the hull vertex that is farthest along the axis (or least far). Along a convex
/// chain the order rises once and falls once, so climbing from anywhere ends at the top.
Index Triangulator::extreme(Index ghost, Axis axis, bool beyond) const {
  const auto better = [&](Index p, Index q) {
    return is_beyond(axis, point(start_of(p)), point(start_of(q))) == beyond;
  };
  for (Index g = following(ghost); better(g, ghost); g = following(g)) ghost = g;
  for (Index g = preceding(ghost); better(g, ghost); g = preceding(g)) ghost = g;
  return ghost;
}

/// Deletes the edges of the left part that start at l and are not Delaunay beside the base l r:
/// while the apex x behind the hull edge l -> u lies in the circle (l, r, u), a flip with the ghost
/// takes the edge away, and l -> x is the hull edge. The slot of `ghost` stays the ghost that
/// starts at l.
///
///        u                   u
///        |\  .               | .   ghost of x -> u
///      T | \   .  ghost      |   .
///        |  \    .           x    .
///        x   |    *    =>     \    *
///         \  |                 \      ghost of l -> x
///          \ |                  \.
///           \l                   l
void Triangulator::advance_left(Index ghost, Index l, Index r) const {
  for (;;) {
    const Index e = hull_halfedge(ghost);  // l -> u
    const Index xl = prev(e);
    const Index u = end_of(ghost), x = origin_[xl];
    if (x == kInfinity || !inside(l, r, u, x)) return;
    const Index ux = prev(xl);
    const Index behind_xl = twin_[xl], behind_ux = twin_[ux];
    const Index after = following(ghost);
    origin_[ghost - 1] = x;
    const Index freed = make_ghost(e / 3, x, u);
    glue(ghost - 1, behind_xl);
    glue(freed - 1, behind_ux);
    chain(ghost, freed);
    chain(freed, after);
  }
}

/// The mirror image: deletes edges of the right part that end at r. The slot of `ghost` stays the
/// ghost that ends at r.
void Triangulator::advance_right(Index ghost, Index l, Index r) const {
  for (;;) {
    const Index e = hull_halfedge(ghost);  // u -> r
    const Index xu = prev(e);
    const Index u = start_of(ghost), x = origin_[xu];
    if (x == kInfinity || !inside(l, r, u, x)) return;
    const Index rx = prev(xu);
    const Index behind_xu = twin_[xu], behind_rx = twin_[rx];
    const Index before = preceding(ghost);
    origin_[ghost] = x;
    const Index freed = make_ghost(e / 3, u, x);
    glue(ghost - 1, behind_rx);
    glue(freed - 1, behind_xu);
    chain(freed, ghost);
    chain(before, freed);
  }
}

/// Joins two parts with a straight line between them, `left` before it along the axis. From the
/// lower common tangent upwards, each base edge l r gets the triangle with the next vertex of the
/// left or the right chain, whichever has the empty circle, and that triangle's upper edge becomes
/// the base.
///
/// Seen along the axis, "lower" is to the right of the way from left to right.
Part Triangulator::merge(Part left, Part right, Axis axis, Index free_slot) const {
  const bool single_left = left.single != kNone, single_right = right.single != kNone;
  // The ghost that starts at l, and the one that starts at r: from the vertices that face each
  // other, down to the lower common tangent. What the last merge left lies close to where it is
  // needed if cuts alternate.
  Index at_l = axis == Axis::x ? left.low : left.high;
  Index at_r = axis == Axis::x ? right.high : right.low;
  if (!single_left) at_l = extreme(at_l, axis, true);
  if (!single_right) at_r = extreme(at_r, axis, false);
  Index l = single_left ? left.single : start_of(at_l);
  Index r = single_right ? right.single : start_of(at_r);
  for (bool moved = true; moved;) {
    moved = false;
    while (!single_left && turn(l, r, start_of(preceding(at_l))) < 0) {
      at_l = preceding(at_l);
      l = start_of(at_l);
      moved = true;
    }
    while (!single_right && turn(l, r, end_of(at_r)) < 0) {
      at_r = following(at_r);
      r = start_of(at_r);
      moved = true;
    }
  }

  const Index bottom = make_ghost(free_slot, l, r);
  Index ghost_l = single_left ? kNoGhost : at_l;              // l -> u, up the left chain
  Index ghost_r = single_right ? kNoGhost : preceding(at_r);  // u -> r, down the right chain
  if (!single_left) chain(preceding(at_l), bottom);
  if (!single_right) chain(bottom, at_r);

  Index base = bottom - 1;  // r -> l, seen from below
  for (;;) {
    const bool left_rises = !single_left && turn(l, r, end_of(ghost_l)) > 0;
    const bool right_rises = !single_right && turn(l, r, start_of(ghost_r)) > 0;
    if (left_rises) advance_left(ghost_l, l, r);
    if (right_rises) advance_right(ghost_r, l, r);
    if (!left_rises && !right_rises) break;
    const bool take_left =
        left_rises && (!right_rises || !inside(l, r, end_of(ghost_l), start_of(ghost_r)));
    if (take_left) {  // the ghost (u, l, infinity) becomes (u, l, r)
      const Index next_ghost = following(ghost_l);
      origin_[ghost_l + 1] = r;
      glue(ghost_l, base);
      base = ghost_l + 1;
      l = end_of(ghost_l);
      ghost_l = next_ghost;
    } else {  // the ghost (r, u, infinity) becomes (r, u, l)
      const Index next_ghost = preceding(ghost_r);
      origin_[ghost_r + 1] = l;
      glue(ghost_r + 1, base);
      base = ghost_r;
      r = start_of(ghost_r);
      ghost_r = next_ghost;
    }
  }

  const Index top = make_ghost(free_slot + 1, r, l);
  glue(top - 1, base);
  chain(top, single_left ? bottom : ghost_l);
  chain(single_right ? bottom : ghost_r, top);
  return {.low = bottom, .high = top};
}

/// Takes the ghosts out: their slots are filled with the last triangles.
void drop_ghosts(Buffer<Index>& origin, Buffer<Index>& twin, Index some_ghost) {
  std::vector<Index> holes;
  for (Index ghost = some_ghost;;) {
    holes.push_back(ghost / 3);
    if (const Index inner = twin[ghost - 1]; inner != kNone) twin[inner] = kNone;
    ghost = twin[ghost + 1];
    if (ghost == some_ghost) break;
  }
  std::sort(holes.begin(), holes.end());
  const Index all = static_cast<Index>(origin.size() / 3);
  const Index kept = all - static_cast<Index>(holes.size());
  auto last_hole = std::lower_bound(holes.begin(), holes.end(), kept);
  auto hole = holes.begin();
  for (Index t = kept; t < all; ++t) {
    if (last_hole != holes.end() && *last_hole == t) {
      ++last_hole;
      continue;
    }
    for (Index i = 0; i < 3; ++i) {
      const Index from = 3 * t + i, to = 3 * *hole + i;
      origin[to] = origin[from];
      twin[to] = twin[from];
      if (twin[to] != kNone) twin[twin[to]] = to;
    }
    ++hole;
  }
  origin.shrink(3 * std::size_t{kept});
  twin.shrink(3 * std::size_t{kept});
}

}  // namespace

TriangleMesh divide_and_conquer(const SpatialOrder& order) {
  const Index n = static_cast<Index>(order.vertices.size());
  Buffer<Index> origin(3 * (2 * std::size_t{n} - 2)), twin(origin.size());
  const Triangulator triangulator(order.vertices.xy.data(), order.key.data(), origin.data(),
                                  twin.data());
  const Part whole = triangulator.solve(0, n);
  drop_ghosts(origin, twin, whole.low);
  return TriangleMesh(n, std::move(origin), std::move(twin));
}

}  // namespace hodt
