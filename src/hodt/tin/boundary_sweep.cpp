#include "hodt/tin/boundary_sweep.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <set>

#include "hodt/geometry/predicates.h"

namespace hodt {

namespace {

/// A boundary edge seen by a sweep from left to right: by (x, y), so that no edge is vertical.
struct Segment {
  Point left;
  Point right;
  /// The region is above: the edge runs from left to right.
  bool region_above = false;
  BoundaryEdge edge;
};

/// From the bottom up, for segments that one sweep line meets and that do not cross.
///
///            b
///   s-------+-----        the segment that begins later, t, begins above or below the other;
///        t---------       if both begin at the same point, its direction decides
///
struct Below {
  bool operator()(const Segment* s, const Segment* t) const {
    return lexicographically_less(s->left, t->left) ? side(*s, *t) > 0 : side(*t, *s) < 0;
  }
  /// On which side of s lies t, which does not begin before s.
  static int side(const Segment& s, const Segment& t) {
    const int beginning = orient(s.left, s.right, t.left);
    return beginning ? beginning : orient(s.left, s.right, t.right);
  }
};

using Status = std::set<const Segment*, Below>;

/// Whether p, on the line of s, lies on s.
bool within(const Segment& s, const Point& p) {
  return !lexicographically_less(p, s.left) && !lexicographically_less(s.right, p);
}

/// Whether the segments have a point in common that is not an end of both.
bool cross(const Segment& s, const Segment& t) {
  const int left = orient(s.left, s.right, t.left), right = orient(s.left, s.right, t.right);
  const int low = orient(t.left, t.right, s.left), high = orient(t.left, t.right, s.right);
  if (left * right < 0 && low * high < 0) return true;
  if (left == 0 && right == 0) {
    // On one line: they overlap unless one ends before, or where, the other begins.
    return lexicographically_less(s.left, t.right) && lexicographically_less(t.left, s.right);
  }
  const auto touches = [](const Segment& a, const Point& p, int side_of_p) {
    return side_of_p == 0 && p != a.left && p != a.right && within(a, p);
  };
  return touches(s, t.left, left) || touches(s, t.right, right) || touches(t, s.left, low) ||
         touches(t, s.right, high);
}

class Sweep {
 public:
  Sweep(std::span<const Point> points, std::span<const BoundaryEdge> edges) : points_(points) {
    segments_.reserve(edges.size());
    for (const BoundaryEdge& edge : edges) {
      const Point a = points[edge.from], b = points[edge.to];
      const bool rightward = lexicographically_less(a, b);
      segments_.push_back({rightward ? a : b, rightward ? b : a, rightward, edge});
    }
    places_.resize(segments_.size());
    for (std::size_t s = 0; s < segments_.size(); ++s) {
      ends_.push_back({segments_[s].left, s, true});
      ends_.push_back({segments_[s].right, s, false});
    }
    std::sort(ends_.begin(), ends_.end(), [](const End& a, const End& b) {
      if (a.at != b.at) return lexicographically_less(a.at, b.at);
      return a.begins != b.begins ? b.begins : a.segment < b.segment;
    });
  }

  std::optional<BoundaryProblem> run() {
    for (std::size_t first = 0, last = 0; first < ends_.size() && !problem_; first = last) {
      while (last < ends_.size() && ends_[last].at == ends_[first].at) ++last;
      pass_point(std::span(ends_).subspan(first, last - first));
    }
    return problem_;
  }

 private:
  struct End {
    Point at;
    std::size_t segment;
    bool begins;
  };

  /// All that happens at one point: edges end, then edges begin.
  void pass_point(std::span<const End> ends) {
    check_one_vertex(ends);
    for (const End& end : ends) {
      if (problem_) return;
      end.begins ? insert(end.segment) : remove(end.segment);
    }
    for (const End& end : ends) {
      if (end.begins && !problem_) check_neighbours(end.segment);
    }
  }

  Index vertex_of(const End& end) const {
    const Segment& segment = segments_[end.segment];
    return segment.region_above == end.begins ? segment.edge.from : segment.edge.to;
  }

  void check_one_vertex(std::span<const End> ends) {
    for (const End& end : ends.subspan(1)) {
      if (vertex_of(end) != vertex_of(ends[0])) {
        report(BoundaryProblem::Kind::equal_points, segments_[ends[0].segment],
               segments_[end.segment]);
        return;
      }
    }
  }

  void remove(std::size_t s) {
    const auto above = status_.erase(places_[s]);
    if (above == status_.begin() || above == status_.end()) return;
    check_crossing(**std::prev(above), **above);
  }

  void insert(std::size_t s) {
    const auto [place, is_new] = status_.insert(&segments_[s]);
    if (!is_new) return report(BoundaryProblem::Kind::crossing, segments_[s], **place);
    places_[s] = place;
  }

  /// Edges that become neighbours must not cross, and from the bottom up they must take turns:
  /// into the region, out of it. (Where edges only end, the turns stay, as the chains are closed.)
  void check_neighbours(std::size_t s) {
    const Segment& segment = segments_[s];
    const auto above = std::next(places_[s]);
    const bool is_top = above == status_.end();
    const bool is_bottom = places_[s] == status_.begin();
    if (!is_top) check_crossing(segment, **above);
    if (!is_bottom) check_crossing(segment, **std::prev(places_[s]));
    if (is_top && segment.region_above) report_doubled(segment, segment);
    if (is_bottom && !segment.region_above) report_doubled(segment, segment);
    if (!is_top && (*above)->region_above == segment.region_above) {
      report_doubled(segment, **above);
    }
    if (!is_bottom && (*std::prev(places_[s]))->region_above == segment.region_above) {
      report_doubled(segment, **std::prev(places_[s]));
    }
  }

  void check_crossing(const Segment& s, const Segment& t) {
    if (cross(s, t)) report(BoundaryProblem::Kind::crossing, s, t);
  }
  void report_doubled(const Segment& s, const Segment& t) {
    report(BoundaryProblem::Kind::doubled, s, t);
  }
  void report(BoundaryProblem::Kind kind, const Segment& s, const Segment& t) {
    if (!problem_) problem_ = BoundaryProblem{kind, s.edge, t.edge};
  }

  std::span<const Point> points_;
  std::vector<Segment> segments_;
  std::vector<End> ends_;
  std::vector<Status::iterator> places_;
  Status status_;
  std::optional<BoundaryProblem> problem_;
};

}  // namespace

std::optional<BoundaryProblem> sweep_boundary(std::span<const Point> points,
                                              std::span<const BoundaryEdge> edges) {
  return Sweep(points, edges).run();
}

}  // namespace hodt
