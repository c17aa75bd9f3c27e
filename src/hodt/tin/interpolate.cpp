// All places are known beforehand, so one sweep from left to right finds all triangles. It keeps
// the edges that the sweep line meets, sorted from bottom to top: only the lower edges of
// triangles, so that each edge leads to the one triangle above it. A place belongs to the triangle
// above the highest edge that is below or through the place, or to none.
//
// Points are passed in lexicographic order, as if the line leaned a little: no edge is vertical.
// Where edges end and others start in one vertex, those that end stay until the line has left the
// vertex: so a place in the vertex finds one of either. Which are taken to be lower does not
// matter.
#include "hodt/tin/interpolate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

#include "hodt/geometry/predicates.h"
#include "hodt/tin/counter_clockwise.h"

namespace hodt {

namespace {

using Triangle = std::array<Index, 3>;

struct LowerEdge {
  Point left;  ///< lexicographically smaller than right
  Point right;
  Index triangle = 0;  ///< the one above
};

/// From bottom to top, of edges that meet in ends only and points that the sweep line passes.
struct IsBelow {
  using is_transparent = void;

  bool operator()(const LowerEdge& e, const LowerEdge& f) const {
    return lexicographically_less(f.left, e.left) ? side(f, e) < 0 : side(e, f) > 0;
  }
  bool operator()(const Point& p, const LowerEdge& e) const {
    return orient(e.left, e.right, p) < 0;
  }

 private:
  /// +1 if `later`, which does not start before `e`, is above it; -1 if it is below.
  static int side(const LowerEdge& e, const LowerEdge& later) {
    const int start = orient(e.left, e.right, later.left);
    if (start != 0) return start;
    return e.left == later.left ? orient(e.left, e.right, later.right) : 1;
  }
};

/// Sorted by their left ends.
std::vector<LowerEdge> lower_edges(const Tin& tin) {
  const std::vector<Point>& xy = tin.points.xy;
  std::vector<LowerEdge> edges;
  for (Index t = 0; t < tin.triangles.size(); ++t) {
    const Triangle corners = counter_clockwise(xy, tin.triangles[t]);
    for (int i = 0; i < 3; ++i) {
      const Point &from = xy[corners[i]], &to = xy[corners[(i + 1) % 3]];
      if (lexicographically_less(from, to)) edges.push_back({from, to, t});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const LowerEdge& e, const LowerEdge& f) {
    return lexicographically_less(e.left, f.left);
  });
  return edges;
}

class Sweep {
 public:
  explicit Sweep(const Tin& tin) : edges_(lower_edges(tin)), ending_(edges_.size()) {
    std::iota(ending_.begin(), ending_.end(), std::size_t{0});
    std::sort(ending_.begin(), ending_.end(), [&](std::size_t i, std::size_t j) {
      return lexicographically_less(edges_[i].right, edges_[j].right);
    });
    at_.resize(edges_.size());
  }

  /// The triangle above the highest edge below or through p; kNone if there is no such edge.
  /// Requires that p is not before the points asked for earlier.
  Index triangle_above_edge_below(const Point& p) {
    advance(p);
    const auto above = status_.upper_bound(p);
    return above == status_.begin() ? Index{kNone} : std::prev(above)->triangle;
  }

 private:
  void advance(const Point& p) {
    for (; started_ < edges_.size() && !lexicographically_less(p, edges_[started_].left);
         ++started_) {
      remove_ended_before(edges_[started_].left);
      at_[started_] = status_.insert(edges_[started_]);
    }
    remove_ended_before(p);
  }

  void remove_ended_before(const Point& p) {
    for (; ended_ < ending_.size() && lexicographically_less(edges_[ending_[ended_]].right, p);
         ++ended_)
      status_.erase(at_[ending_[ended_]]);
  }

  using Status = std::multiset<LowerEdge, IsBelow>;

  std::vector<LowerEdge> edges_;
  std::vector<std::size_t> ending_;  ///< places in edges_, sorted by right ends
  std::vector<Status::const_iterator> at_;
  Status status_;
  std::size_t started_ = 0;
  std::size_t ended_ = 0;
};

bool contains(const Tin& tin, Index t, const Point& p) {
  const std::vector<Point>& xy = tin.points.xy;
  const auto [a, b, c] = counter_clockwise(xy, tin.triangles[t]);
  return orient(xy[a], xy[b], p) >= 0 && orient(xy[b], xy[c], p) >= 0 &&
         orient(xy[c], xy[a], p) >= 0;
}

/// Twice the area of the triangle p, a, b.
double doubled_area(const Point& p, const Point& a, const Point& b) {
  return std::fabs((a.x - p.x) * (b.y - p.y) - (a.y - p.y) * (b.x - p.x));
}

}  // namespace

std::vector<Index> triangles_at(const Tin& tin, std::span<const Point> places) {
  std::vector<std::size_t> order(places.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return lexicographically_less(places[i], places[j]);
  });
  Sweep sweep(tin);
  std::vector<Index> triangles(places.size(), kNone);
  for (const std::size_t i : order) {
    const Index t = sweep.triangle_above_edge_below(places[i]);
    if (t != kNone && contains(tin, t, places[i])) triangles[i] = t;
  }
  return triangles;
}

double height_in(const PointSet& points, const std::array<Index, 3>& corners, const Point& p) {
  const auto& [a, b, c] = corners;
  const std::vector<Point>& xy = points.xy;
  for (const Index v : corners)
    if (p == xy[v]) return points.z[v];
  const double weights[3] = {doubled_area(p, xy[b], xy[c]), doubled_area(p, xy[c], xy[a]),
                             doubled_area(p, xy[a], xy[b])};
  // From the corner with the largest weight: there nothing is added, so nothing is rounded, and
  // what is added elsewhere never leads beyond the other corners' heights.
  const auto main = std::max_element(weights, weights + 3) - weights;
  const double base = points.z[corners[main]];
  const double sum = weights[0] + weights[1] + weights[2];
  double rise = 0;
  for (int i = 0; i < 3; ++i) rise += weights[i] * (points.z[corners[i]] - base);
  // The area of a needle can round to nothing, that of a giant overflow.
  if (!(sum > 0) || !std::isfinite(sum) || !std::isfinite(rise)) return base;
  return base + rise / sum;
}

std::vector<double> interpolate(const Tin& tin, std::span<const Point> places) {
  const std::vector<Index> triangles = triangles_at(tin, places);
  std::vector<double> heights(places.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < places.size(); ++i)
    if (triangles[i] != kNone)
      heights[i] = height_in(tin.points, tin.triangles[triangles[i]], places[i]);
  return heights;
}

}  // namespace hodt
