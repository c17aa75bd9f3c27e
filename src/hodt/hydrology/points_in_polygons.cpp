// The points are a tree of runs: a node is two runs that follow each other, with their box. A
// polygon goes down the tree. Each node keeps the sides that can meet its box, and one place in the
// box that is known to be inside or outside. From there to any point of the box a segment stays in
// the box, so the sides that are left tell how often it goes in or out. Where none is left, all
// points are as the known place is.
//
// Where few points are in a polygon's box, the way down would take longer than asking for each.
#include "hodt/hydrology/points_in_polygons.h"

#include <algorithm>
#include <atomic>
#include <optional>
#include <vector>

#include "hodt/base/parallel.h"
#include "hodt/geometry/predicates.h"
#include "hodt/hydrology/run_tree.h"

namespace hodt {

namespace {

struct Side {
  Point a, b;

  Box box() const { return joined({a, a}, {b, b}); }
};

/// May be wrong only in saying yes: of sides that pass close by the box.
bool may_meet(const Side& side, const Box& box) {
  const auto& [a, b] = side;
  const Box own = side.box();
  if (!meet(own, box)) return false;
  if (contains(box, own)) return true;
  // The two corners that are farthest to the left and to the right of a line that rises or falls.
  const bool rises = (a.x < b.x) == (a.y < b.y);
  const Point left{box.low.x, rises ? box.high.y : box.low.y};
  const Point right{box.high.x, rises ? box.low.y : box.high.y};
  return orient(a, b, left) * orient(a, b, right) <= 0;
}

/// A place that is not on a ring.
struct Known {
  Point place;
  bool inside = false;
};

enum class Position { outside, inside, on_ring };

/// A ray to the right meets one side more, or p is on the side.
Position beyond(const Side& side, const Point& p, Position so_far) {
  const auto& [a, b] = side;
  const int turn = orient(a, b, p);
  if (turn == 0 && contains(side.box(), {p, p})) return Position::on_ring;
  const bool meets = (a.y > p.y) != (b.y > p.y) && (turn > 0) == (b.y > a.y);
  return meets == (so_far == Position::outside) ? Position::inside : Position::outside;
}

/// All sides of a polygon, to ask for one place after another.
class AllSides {
 public:
  explicit AllSides(const Polygon& polygon) {
    for (const auto& ring : polygon.rings)
      for (std::size_t i = 0; i < ring.size(); ++i)
        sides_.push_back({ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]});
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      if (i % kBlock == 0) boxes_.push_back(sides_[i].box());
      boxes_.back() = joined(boxes_.back(), sides_[i].box());
    }
  }

  const std::vector<Side>& list() const { return sides_; }

  Box box() const {
    Box box = boxes_[0];
    for (const Box& other : boxes_) box = joined(box, other);
    return box;
  }

  Position position(const Point& p) const {
    Position position = Position::outside;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      if (!is_met(boxes_[i], p)) continue;
      const std::size_t end = std::min((i + 1) * kBlock, sides_.size());
      for (std::size_t j = i * kBlock; j < end; ++j) {
        if (!is_met(sides_[j].box(), p)) continue;
        position = beyond(sides_[j], p, position);
        if (position == Position::on_ring) return position;
      }
    }
    return position;
  }

 private:
  static constexpr std::size_t kBlock = 8;

  /// By the ray from p to the right.
  static bool is_met(const Box& box, const Point& p) {
    return (box.low.y <= p.y) & (p.y <= box.high.y) & (p.x <= box.high.x);
  }

  std::vector<Side> sides_;
  std::vector<Box> boxes_;  // of so many sides that follow each other
};

/// By the number of sides that the segment from a known place meets; `sides` are all that it can
/// meet. A corner that it passes through counts as being to its left: as if it were moved a little,
/// which is allowed because neither end is on a ring.
Position position(std::span<const Side> sides, const Known& known, const Point& p) {
  bool inside = known.inside;
  const Box way = Side{known.place, p}.box();
  for (const Side& side : sides) {
    if (!meet(side.box(), way)) continue;
    const auto& [a, b] = side;
    const int from = orient(known.place, p, a), to = orient(known.place, p, b);
    if (from * to > 0) continue;
    const int turn = orient(a, b, p);
    if (turn == 0 && contains(side.box(), {p, p})) return Position::on_ring;
    if ((from >= 0) != (to >= 0) && (turn > 0) != (orient(a, b, known.place) > 0)) inside = !inside;
  }
  return inside ? Position::inside : Position::outside;
}

/// One polygon and all points.
class Search {
 public:
  Search(const RunTree& tree, const Polygon& polygon, Buffer<bool>& is_inside)
      : tree_(tree), is_inside_(is_inside), sides_(polygon) {}

  /// Whether a point is inside.
  bool run() {
    if (sides_.list().empty()) return false;
    box_ = sides_.box();
    if (std::vector<Node> few; add_runs(tree_.root(), few)) {
      for (const Node& node : few) mark_points(node, {}, std::nullopt);
    } else {
      std::vector<Side> kept = sides_.list();
      descend(tree_.root(), kept, 0, std::nullopt);
    }
    return found_.load(std::memory_order_relaxed);
  }

 private:
  using Node = RunTree::Node;

  /// Adds the runs that meet the polygon's box, unless they are many.
  bool add_runs(const Node& node, std::vector<Node>& runs) const {
    constexpr std::size_t many = 64;
    if (!meet(tree_.box(node), box_)) return true;
    if (node.level == 0) {
      runs.push_back(node);
      return runs.size() < many;
    }
    const auto upper = tree_.upper_child(node);
    return add_runs(RunTree::lower_child(node), runs) && (!upper || add_runs(*upper, runs));
  }

  /// The last of the kept sides, from `first` on, are those that can meet the node's box or what
  /// leads there from the known place. Without such a place they are all.
  void descend(const Node& node, std::vector<Side>& kept, std::size_t first,
               std::optional<Known> known) {
    const Box& box = tree_.box(node);
    if (!meet(box, box_)) return;
    const std::size_t end = kept.size();
    if (!contains(box, box_)) {
      const std::span<const Side> sides = std::span(kept).subspan(first);
      if (const std::optional<Known> nearer = known_in(node, sides, known)) {
        known = nearer;
        first = keep_those_at(box, kept, first);
      }
      if (first == kept.size()) {
        if (known->inside) mark_all(node);
        return;
      }
    }
    if (node.level == 0)
      mark_points(node, std::span(kept).subspan(first), known);
    else
      descend_to_children(node, kept, first, known);
    kept.resize(end);
  }

  void descend_to_children(const Node& node, std::vector<Side>& kept, std::size_t first,
                           const std::optional<Known>& known) {
    const auto upper = tree_.upper_child(node);
    constexpr std::size_t many = 1 << 16;
    if (upper && tree_.points_of(node).size() + kept.size() - first > many) {
      std::vector<Side> copy(kept.begin() + std::ptrdiff_t(first), kept.end());
      parallel_invoke([&] { descend(RunTree::lower_child(node), kept, first, known); },
                      [&] { descend(*upper, copy, 0, known); });
      return;
    }
    descend(RunTree::lower_child(node), kept, first, known);
    if (upper) descend(*upper, kept, first, known);
  }

  /// Adds those of the sides from `first` on that can meet the box; returns where they begin.
  static std::size_t keep_those_at(const Box& box, std::vector<Side>& kept, std::size_t first) {
    const std::size_t end = kept.size();
    for (std::size_t i = first; i < end; ++i)
      if (const Side side = kept[i]; may_meet(side, box)) kept.push_back(side);
    return end;
  }

  Position position_of(std::span<const Side> sides, const std::optional<Known>& known,
                       const Point& p) const {
    return known ? position(sides, *known, p) : sides_.position(p);
  }

  /// A place in the node's box that is not on a ring. Of points that lie on rings, or in one line
  /// with a side, there may be none that is found: then the known place goes on to serve.
  std::optional<Known> known_in(const Node& node, std::span<const Side> sides,
                                const std::optional<Known>& known) const {
    const auto try_at = [&](const Point& p) -> std::optional<Known> {
      const Position found = position_of(sides, known, p);
      if (found == Position::on_ring) return std::nullopt;
      return Known{p, found == Position::inside};
    };
    const std::span<const Point> points = tree_.points_of(node);
    for (const Point& p : {points.front(), points.back(), points[points.size() / 2]})
      if (const auto found = try_at(p)) return found;
    const Box& box = tree_.box(node);
    const auto between = [](double low, double high, double share) {
      return std::clamp(low * (1 - share) + high * share, low, high);
    };
    for (const double share : {0.381, 0.707, 0.144})
      if (const auto found = try_at({between(box.low.x, box.high.x, share),
                                     between(box.low.y, box.high.y, 0.927 - share)}))
        return found;
    return std::nullopt;
  }

  void mark_points(const Node& node, std::span<const Side> sides,
                   const std::optional<Known>& known) {
    const std::span<const Point> points = tree_.points_of(node);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (contains(box_, {points[i], points[i]}) &&
          position_of(sides, known, points[i]) != Position::outside)
        mark(tree_.first_point(node) + i);
  }

  void mark_all(const Node& node) {
    const std::size_t first = tree_.first_point(node);
    for (std::size_t i = 0; i < tree_.points_of(node).size(); ++i) mark(first + i);
  }

  /// Other polygons may mark it at the same time.
  void mark(std::size_t point) {
    std::atomic_ref(is_inside_[point]).store(true, std::memory_order_relaxed);
    found_.store(true, std::memory_order_relaxed);
  }

  const RunTree& tree_;
  Buffer<bool>& is_inside_;
  AllSides sides_;
  Box box_;
  std::atomic<bool> found_ = false;
};

}  // namespace

PointsInPolygons points_in_polygons(std::span<const Point> points,
                                    std::span<const Polygon> polygons) {
  PointsInPolygons result{Buffer<bool>(points.size(), false), Buffer<bool>(polygons.size(), false)};
  if (points.empty() || polygons.empty()) return result;
  const RunTree tree(points);
  parallel_for(0, polygons.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      result.holds_point[i] = Search(tree, polygons[i], result.is_inside).run();
  });
  return result;
}

}  // namespace hodt
