// Why checking edges and the boundary is enough.
//
// Let all triangles be counter-clockwise and no directed edge be used twice. The number of
// triangles over a point p (on no edge) is the winding number around p of the sum of the triangles'
// outlines, in which every edge used in both directions cancels: so of the boundary alone, the
// edges with one triangle. If boundary edges meet only in shared ends, this number is constant
// between them; if the region is on the left of each and nothing on its right, it is 0 or 1
// everywhere: no two triangles overlap. Now let triangles T and S without overlap share a point p
// that is not in a shared corner or edge.
//  - p lies within an edge e of T. If e had two triangles, they would fill p's surroundings and S
//    would overlap one of them; so e is on the boundary. If p lies within an edge of S, likewise,
//    and both boundary edges run along each other. If p is a corner of S, the triangles around it
//    lie in a half-plane, so they do not close and some edge at p is on the boundary: it meets e
//    within e. Either way two boundary edges meet elsewhere than in shared ends.
//  - p is a corner of both, but two vertices. If all edges at one of them have two triangles, its
//    triangles fill p's surroundings and the other's overlap them; so both are on the boundary.
// The sweep over the boundary finds all of this. Conversely, whatever it finds is a violation.
#include "hodt/tin/embedding.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "hodt/base/buffer.h"
#include "hodt/geometry/predicates.h"
#include "hodt/tin/boundary_sweep.h"

namespace hodt {

namespace {

using Triangle = std::array<Index, 3>;

/// A triangle's side, filed under its lower vertex.
struct Side {
  Index high = 0;
  Index triangle = 0;
  bool upward = false;  ///< runs from the lower vertex to the higher

  friend bool operator<(const Side& a, const Side& b) {
    return std::tie(a.high, a.upward, a.triangle) < std::tie(b.high, b.upward, b.triangle);
  }
};

/// All sides, grouped by edge: first by their lower vertex, then by their higher.
class Sides {
 public:
  Sides(std::span<const Triangle> triangles, std::size_t vertices)
      : starts_(vertices + 1, std::size_t{0}), sides_(3 * triangles.size()) {
    for (const Triangle& corners : triangles) {
      for (int i = 0; i < 3; ++i) ++starts_[low(corners, i)];
    }
    std::size_t sum = 0;
    for (std::size_t& start : starts_) sum += std::exchange(start, sum);
    for (Index t = 0; t < triangles.size(); ++t) {
      for (int i = 0; i < 3; ++i) {
        const Index from = triangles[t][i], to = triangles[t][(i + 1) % 3];
        sides_[starts_[std::min(from, to)]++] = {std::max(from, to), t, from < to};
      }
    }
    // Filling moved each start to the next one's place.
    for (std::size_t v = vertices; v > 0; --v) starts_[v] = starts_[v - 1];
    starts_[0] = 0;
  }

  /// Calls f(low vertex, sides) for every edge, until one call returns false.
  template <class F>
  void for_each_edge(const F& f) {
    for (Index v = 0; v + 1 < starts_.size(); ++v) {
      Side* const end = sides_.data() + starts_[v + 1];
      Side* first = sides_.data() + starts_[v];
      std::sort(first, end);
      while (first != end) {
        Side* last = first + 1;
        while (last != end && last->high == first->high) ++last;
        if (!f(v, std::span<const Side>(first, last))) return;
        first = last;
      }
    }
  }

 private:
  static Index low(const Triangle& corners, int i) {
    return std::min(corners[i], corners[(i + 1) % 3]);
  }

  Buffer<std::size_t> starts_;
  Buffer<Side> sides_;
};

/// Triangles that hang together.
class Pieces {
 public:
  explicit Pieces(std::size_t triangles) : parents_(triangles), count_(triangles) {
    std::iota(parents_.begin(), parents_.end(), Index{0});
  }
  void join(Index s, Index t) {
    s = find(s);
    t = find(t);
    if (s == t) return;
    parents_[std::max(s, t)] = std::min(s, t);
    --count_;
  }
  std::size_t count() const { return count_; }

 private:
  Index find(Index t) {
    while (parents_[t] != t) t = parents_[t] = parents_[parents_[t]];
    return t;
  }

  Buffer<Index> parents_;
  std::size_t count_;
};

class Checker {
 public:
  Checker(std::span<const Point> points, std::span<const Triangle> triangles)
      : points_(points), given_(triangles), triangles_(triangles.begin(), triangles.end()) {}

  Embedding check() {
    mark_used();
    orient_triangles();
    if (result_.problem.empty()) match_sides();
    if (result_.problem.empty()) check_boundary();
    result_.embedded = result_.problem.empty();
    if (result_.embedded) result_.covers_hull = covers_hull();
    return result_;
  }

 private:
  void mark_used() {
    used_.resize(points_.size());
    for (const Triangle& corners : triangles_) {
      for (const Index v : corners) used_[v] = true;
    }
    result_.unused_vertices =
        static_cast<std::size_t>(std::count(used_.begin(), used_.end(), false));
  }

  /// Makes all triangles counter-clockwise.
  void orient_triangles() {
    for (Index t = 0; t < triangles_.size(); ++t) {
      auto& [a, b, c] = triangles_[t];
      const int turn = orient(points_[a], points_[b], points_[c]);
      if (turn == 0 && result_.problem.empty()) {
        result_.problem = fmt::format("{} has no inside: its corners lie on a line", name(t));
      }
      if (turn < 0) {
        std::swap(b, c);
        ++result_.clockwise;
      }
    }
  }

  void match_sides() {
    Sides sides(triangles_, points_.size());
    Pieces pieces(triangles_.size());
    sides.for_each_edge([&](Index low, std::span<const Side> uses) {
      const Side& first = uses[0];
      if (uses.size() == 1) {
        boundary_.push_back(first.upward ? BoundaryEdge{low, first.high, first.triangle}
                                         : BoundaryEdge{first.high, low, first.triangle});
      } else if (uses.size() == 2 && first.upward != uses[1].upward) {
        pieces.join(first.triangle, uses[1].triangle);
      } else {
        // Of three, two run the same way; sorted, they stand together.
        const std::size_t i = first.upward == uses[1].upward ? 0 : 1;
        result_.problem =
            fmt::format("{} and {} overlap: they are on the same side of edge {}-{}",
                        name(uses[i].triangle), name(uses[i + 1].triangle), low, first.high);
      }
      return result_.problem.empty();
    });
    result_.components = pieces.count();
    result_.boundary_edges = boundary_.size();
  }

  void check_boundary() {
    const auto problem = sweep_boundary(points_, boundary_);
    if (!problem) return;
    result_.components = result_.boundary_edges = 0;
    // Equal vertices explain most other problems.
    const auto equal = equal_vertices();
    result_.problem = equal ? fmt::format("vertices {} and {} have the same coordinates",
                                          equal->first, equal->second)
                            : describe(*problem);
  }

  /// Two corners with the same coordinates, the first such vertex in the input's order.
  std::optional<std::pair<Index, Index>> equal_vertices() const {
    std::vector<Index> order;
    for (Index v = 0; v < points_.size(); ++v) {
      if (used_[v]) order.push_back(v);
    }
    std::stable_sort(order.begin(), order.end(), [&](Index u, Index v) {
      return lexicographically_less(points_[u], points_[v]);
    });
    std::optional<std::pair<Index, Index>> first;
    for (std::size_t i = 0; i + 1 < order.size(); ++i) {
      const std::pair pair(order[i], order[i + 1]);
      if (points_[pair.first] == points_[pair.second] && (!first || pair < *first)) first = pair;
    }
    return first;
  }

  std::string describe(const BoundaryProblem& problem) const {
    const BoundaryEdge &e = problem.first, &f = problem.second;
    if (problem.kind == BoundaryProblem::Kind::doubled) {
      return fmt::format("triangles overlap: {} has others on its edge {}-{} or beyond it",
                         name(e.triangle), e.from, e.to);
    }
    for (const auto& [edge, other] : {std::pair(e, f), std::pair(f, e)}) {
      for (const Index v : {other.from, other.to}) {
        if (lies_within(v, edge)) {
          return fmt::format("vertex {} of {} lies within edge {}-{} of {}", v,
                             name(other.triangle), edge.from, edge.to, name(edge.triangle));
        }
      }
    }
    return fmt::format("edge {}-{} of {} crosses edge {}-{} of {}", e.from, e.to, name(e.triangle),
                       f.from, f.to, name(f.triangle));
  }

  bool lies_within(Index v, const BoundaryEdge& edge) const {
    const Point &a = points_[edge.from], &b = points_[edge.to], &p = points_[v];
    return p != a && p != b && orient(a, b, p) == 0 &&
           lexicographically_less(a, p) == lexicographically_less(p, b);
  }

  /// "triangle 5 (1, 2, 3)", as given.
  std::string name(Index t) const {
    const auto& [a, b, c] = given_[t];
    return fmt::format("triangle {} ({}, {}, {})", t, a, b, c);
  }

  /// The mesh is embedded. It covers the hull if its boundary is one convex chain and no point is
  /// outside that.
  bool covers_hull() const {
    const std::vector<Index> chain = single_chain();
    if (chain.empty() || !is_convex(chain)) return false;
    for (Index v = 0; v < points_.size(); ++v) {
      if (!used_[v] && !chain_encloses(chain, points_[v])) return false;
    }
    return true;
  }

  /// The boundary's vertices in order, from the lexicographically smallest, if the boundary is one
  /// chain that passes no vertex twice; else nothing.
  std::vector<Index> single_chain() const {
    if (boundary_.empty()) return {};
    std::vector<std::pair<Index, Index>> next;
    for (const BoundaryEdge& edge : boundary_) next.push_back({edge.from, edge.to});
    std::sort(next.begin(), next.end());
    const auto less = [&](const auto& a, const auto& b) {
      return lexicographically_less(points_[a.first], points_[b.first]);
    };
    const Index start = std::min_element(next.begin(), next.end(), less)->first;
    std::vector<Index> chain;
    Index v = start;
    do {
      chain.push_back(v);
      v = std::lower_bound(next.begin(), next.end(), std::pair(v, Index{0}))->second;
    } while (v != start && chain.size() <= next.size());
    if (chain.size() != next.size()) chain.clear();
    return chain;
  }

  bool is_convex(const std::vector<Index>& chain) const {
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const Index a = chain[i], b = chain[(i + 1) % chain.size()],
                  c = chain[(i + 2) % chain.size()];
      if (orient(points_[a], points_[b], points_[c]) < 0) return false;
    }
    return true;
  }

  /// Requires a convex chain that starts at its lexicographically smallest point: it runs up to
  /// the largest below the region, and back above it.
  bool chain_encloses(const std::vector<Index>& chain, const Point& p) const {
    const auto at = [&](std::size_t i) { return points_[chain[i % chain.size()]]; };
    const auto before = [&](Index u, Index v) {
      return lexicographically_less(points_[u], points_[v]);
    };
    const auto turn = std::max_element(chain.begin(), chain.end(), before);
    const auto before_p = [&](Index v) { return lexicographically_less(points_[v], p); };
    const auto not_before_p = [&](Index v) { return !lexicographically_less(points_[v], p); };
    if (p == at(0)) return true;
    if (!before_p(chain[0]) || lexicographically_less(points_[*turn], p)) return false;
    // The edges that p is between the ends of: one below, one above.
    const auto below = std::partition_point(chain.begin(), turn, before_p) - chain.begin();
    const auto above = std::partition_point(turn, chain.end(), not_before_p) - chain.begin();
    const auto is_left = [&](std::size_t i) { return orient(at(i - 1), at(i), p) >= 0; };
    return is_left(static_cast<std::size_t>(below)) && is_left(static_cast<std::size_t>(above));
  }

  std::span<const Point> points_;
  std::span<const Triangle> given_;
  std::vector<Triangle> triangles_;  ///< counter-clockwise
  std::vector<bool> used_;
  std::vector<BoundaryEdge> boundary_;
  Embedding result_;
};

}  // namespace

Embedding check_embedding(std::span<const Point> points,
                          std::span<const std::array<Index, 3>> triangles) {
  return Checker(points, triangles).check();
}

}  // namespace hodt
