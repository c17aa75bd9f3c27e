#include "hodt/order/search/point_tree.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "hodt/base/clones.h"
#include "hodt/geometry/circle.h"
#include "hodt/geometry/predicates.h"

namespace hodt {

/// The inside of the circle through a, b and c, to the right of the line from -> to (if any).
struct PointTree::Region {
  Region(std::span<const Point> points, VertexId a, VertexId b, VertexId c)
      : circle(points[a], points[b], points[c]) {}

  Point from{}, to{};
  bool is_cut = false;
  Circle circle;
};

namespace {

constexpr Index kWidth = 8;
constexpr double kFar = std::numeric_limits<double>::infinity();

/// Masks with all bits set for true, of the width of a double: what compares vectorise to.
using Flag = std::int64_t;

/// The numbers that the loops need, side by side.
struct Numbers {
  double ax, ay, per_r, per_x, per_y, bound, bound_per_r;  // of the circle
  double turn_x, turn_y;                                   // where its parabolas turn
  double fx, fy, dx, dy;                                   // of the line

  Numbers(const exact::CircleFilter& f, const Point& from, const Point& to)
      : ax(f.origin().x),
        ay(f.origin().y),
        per_r(f.per_r()),
        per_x(f.per_x()),
        per_y(f.per_y()),
        // The parabolas must open upwards; a D that is nothing but rounding leaves all in doubt.
        bound(f.per_r() > 0 ? f.bound() : kFar),
        bound_per_r(f.bound_per_r()),
        turn_x(-0.5 / per_r * per_x),
        turn_y(-0.5 / per_r * per_y),
        fx(from.x),
        fy(from.y),
        dx(to.x - from.x),
        dy(to.y - from.y) {}
};

struct Sides {
  Flag inside[kWidth], outside[kWidth];  // surely
};

/// Where boxes are with regard to a circle. Its f (see predicate_stages.h) is the sum of D x² + P x
/// and D y² + Q y: each is largest at an end of its interval, and least there or where the parabola
/// turns. What is computed is f at one point of the box, but that the coordinates are rounded once
/// more; and the turn, which matters in second order only. Twice the bound for the largest r in the
/// box covers that. An overflow makes a number infinite or NaN, and neither side sure.
HODT_CLONES void circle_sides(const double* min_x, const double* min_y, const double* max_x,
                              const double* max_y, const Numbers& f, Sides& sides) {
  for (Index i = 0; i < kWidth; ++i) {
    const double x0 = min_x[i] - f.ax, x1 = max_x[i] - f.ax;
    const double y0 = min_y[i] - f.ay, y1 = max_y[i] - f.ay;
    const double xx0 = x0 * x0, xx1 = x1 * x1, yy0 = y0 * y0, yy1 = y1 * y1;
    const double r = (xx0 > xx1 ? xx0 : xx1) + (yy0 > yy1 ? yy0 : yy1);
    const double bound = 2 * (f.bound + f.bound_per_r * r);
    const double gx0 = x0 * (f.per_r * x0 + f.per_x), gx1 = x1 * (f.per_r * x1 + f.per_x);
    const double gy0 = y0 * (f.per_r * y0 + f.per_y), gy1 = y1 * (f.per_r * y1 + f.per_y);
    const double most = (gx0 > gx1 ? gx0 : gx1) + (gy0 > gy1 ? gy0 : gy1);
    double tx = f.turn_x > x0 ? f.turn_x : x0, ty = f.turn_y > y0 ? f.turn_y : y0;
    tx = tx < x1 ? tx : x1;
    ty = ty < y1 ? ty : y1;
    const double least = tx * (f.per_r * tx + f.per_x) + ty * (f.per_r * ty + f.per_y);
    const Flag finite = bound <= DBL_MAX ? -1 : 0;
    sides.inside[i] = (most < -bound ? -1 : 0) & (most >= -DBL_MAX ? -1 : 0) & finite;
    sides.outside[i] = (least > bound ? -1 : 0) & (least <= DBL_MAX ? -1 : 0) & finite;
  }
}

/// The same for the half-plane to the right of a line, given the corners of the boxes that are
/// furthest to the left and to the right; for points both are the same. As orient_rounded.
HODT_CLONES void line_sides(const double* left_x, const double* left_y, const double* right_x,
                            const double* right_y, const Numbers& f, Sides& sides) {
  for (Index i = 0; i < kWidth; ++i) {
    constexpr double kRelative = 4 * 0x1p-53;
    const double l1 = f.dx * (left_y[i] - f.fy), l2 = f.dy * (left_x[i] - f.fx);
    const double r1 = f.dx * (right_y[i] - f.fy), r2 = f.dy * (right_x[i] - f.fx);
    const double left = l1 - l2, right = r1 - r2;
    const double left_bound = kRelative * ((l1 < 0 ? -l1 : l1) + (l2 < 0 ? -l2 : l2)) + DBL_MIN;
    const double right_bound = kRelative * ((r1 < 0 ? -r1 : r1) + (r2 < 0 ? -r2 : r2)) + DBL_MIN;
    sides.inside[i] &= (left < -left_bound ? -1 : 0) & (left >= -DBL_MAX ? -1 : 0);
    sides.outside[i] |= (right > right_bound ? -1 : 0) & (right <= DBL_MAX ? -1 : 0);
  }
}

HODT_CLONES void point_sides(const double* px, const double* py, const Numbers& f, Sides& sides) {
  for (Index i = 0; i < kWidth; ++i) {
    const double x = px[i] - f.ax, y = py[i] - f.ay;
    const double r = x * x + y * y;
    const double value = f.per_r * r + (f.per_x * x + f.per_y * y);
    const double bound = f.bound + f.bound_per_r * r;
    sides.inside[i] = (value < -bound ? -1 : 0) & (value >= -DBL_MAX ? -1 : 0);
    sides.outside[i] = (value > bound ? -1 : 0) & (value <= DBL_MAX ? -1 : 0);
  }
}

}  // namespace

PointTree::PointTree(std::span<const Point> points)
    : points_(points), leaves_((points.size() + kWidth - 1) / kWidth) {
  for (std::size_t i = 0; i < leaves_.size() * kWidth; ++i) {
    const Point p = i < points.size() ? points[i] : Point{kFar, kFar};
    leaves_[i / kWidth].x[i % kWidth] = p.x;
    leaves_[i / kWidth].y[i % kWidth] = p.y;
  }
  const auto build = [](std::size_t children, const auto& box_of) {
    Buffer<Node> nodes((children + kWidth - 1) / kWidth);
    for (std::size_t i = 0; i < nodes.size() * kWidth; ++i) {
      Node& node = nodes[i / kWidth];
      const std::size_t at = i % kWidth;
      node.min_x[at] = node.min_y[at] = kFar;
      node.max_x[at] = node.max_y[at] = -kFar;
      if (i < children) box_of(i, node, at);
    }
    return nodes;
  };
  const auto of_points = [&](std::size_t child, Node& node, std::size_t at) {
    const std::size_t first = child * kWidth;
    for (std::size_t i = first; i < std::min(points.size(), first + kWidth); ++i) {
      node.min_x[at] = std::min(node.min_x[at], points[i].x);
      node.max_x[at] = std::max(node.max_x[at], points[i].x);
      node.min_y[at] = std::min(node.min_y[at], points[i].y);
      node.max_y[at] = std::max(node.max_y[at], points[i].y);
    }
  };
  levels_.push_back(build(leaves_.size(), of_points));
  while (levels_.back().size() > 1) {
    const Buffer<Node>& below = levels_.back();
    const auto of_nodes = [&](std::size_t child, Node& node, std::size_t at) {
      const Node& c = below[child];
      node.min_x[at] = *std::min_element(c.min_x, c.min_x + kWidth);
      node.min_y[at] = *std::min_element(c.min_y, c.min_y + kWidth);
      node.max_x[at] = *std::max_element(c.max_x, c.max_x + kWidth);
      node.max_y[at] = *std::max_element(c.max_y, c.max_y + kWidth);
    };
    Buffer<Node> above = build(below.size(), of_nodes);
    levels_.push_back(std::move(above));
  }
}

template <class Whole, class Single>
void PointTree::visit(const Region& region, const Whole& whole, const Single& single) const {
  struct Entry {
    Index level, index;  // level 0: a leaf
  };
  std::array<Entry, 16 * kWidth> stack;  // more levels than 32 bits can count
  std::size_t depth = 0;
  const auto n = static_cast<Index>(points_.size());
  stack[depth++] = {static_cast<Index>(levels_.size()), 0};
  Sides sides;
  while (depth > 0) {
    const Numbers f(region.circle.filter(), region.from, region.to);
    const auto [level, index] = stack[--depth];
    if (level == 0) {
      const Leaf& leaf = leaves_[index];
      point_sides(leaf.x, leaf.y, f, sides);
      if (region.is_cut) line_sides(leaf.x, leaf.y, leaf.x, leaf.y, f, sides);
      const Index end = std::min(kWidth, n - index * kWidth);
      for (Index i = 0; i < end; ++i) {
        if (sides.outside[i]) continue;
        if (!single(index * kWidth + i, !sides.inside[i])) return;
      }
      continue;
    }
    const Node& node = levels_[level - 1][index];
    circle_sides(node.min_x, node.min_y, node.max_x, node.max_y, f, sides);
    if (region.is_cut) {
      const bool up = f.dy > 0, ahead = f.dx > 0;
      line_sides(up ? node.min_x : node.max_x, ahead ? node.max_y : node.min_y,
                 up ? node.max_x : node.min_x, ahead ? node.min_y : node.max_y, f, sides);
    }
    const std::size_t count = level == 1 ? leaves_.size() : levels_[level - 2].size();
    const auto end = static_cast<Index>(std::min<std::size_t>(kWidth, count - index * kWidth));
    for (Index i = 0; i < end; ++i) {
      const Index child = index * kWidth + i;
      if (sides.outside[i]) continue;
      if (sides.inside[i]) {
        const Index shift = 3 * level;  // points of a child: 8 ^ level
        if (!whole(child << shift, std::min(n, (child + 1) << shift))) return;
      } else {
        stack[depth++] = {level - 1, child};
      }
    }
  }
}

Index PointTree::count(VertexId a, VertexId b, VertexId c, Index limit) const {
  const Region region(points_, a, b, c);
  Index count = 0;
  const auto whole = [&](Index first, Index last) { return (count += last - first) <= limit; };
  const auto single = [&](Index i, bool doubtful) {
    // What is on the circle would take exact arithmetic to see.
    if (doubtful && (i == a || i == b || i == c || !region.circle.contains(points_[i])))
      return true;
    return ++count <= limit;
  };
  visit(region, whole, single);
  return count;
}

VertexId PointTree::first_on_left(VertexId a, VertexId b, VertexId start) const {
  VertexId first = start;
  Region region(points_, a, b, start);
  region.from = points_[b];
  region.to = points_[a];
  region.is_cut = true;
  // The part of the circle on the left shrinks: what was outside stays outside.
  const auto single = [&](Index i, bool) {
    if (i == a || i == b || i == first) return true;
    if (orient(region.from, region.to, points_[i]) >= 0) return true;
    if (!region.circle.contains(points_[i])) return true;
    first = VertexId(i);
    region.circle = Circle(points_[a], points_[b], points_[i]);
    return true;
  };
  const auto whole = [&](Index begin, Index end) {
    for (Index i = begin; i < end; ++i) single(i, true);
    return true;
  };
  visit(region, whole, single);
  return first;
}

Index PointTree::useful_order(VertexId u, VertexId v, VertexId left, VertexId right,
                              Index limit) const {
  const Index order = count(u, v, first_on_left(u, v, left), limit);
  if (order > limit) return order;
  return std::max(order, count(v, u, first_on_left(v, u, right), limit));
}

}  // namespace hodt
