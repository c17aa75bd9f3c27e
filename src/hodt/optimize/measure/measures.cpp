#include "hodt/optimize/measure/measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

#include "hodt/base/lanes.h"
#include "hodt/base/parallel.h"
#include "hodt/base/prefetch.h"
#include "hodt/geometry/predicates.h"
#include "hodt/geometry/wide_real.h"
#include "hodt/optimize/measure/angle.h"
#include "hodt/optimize/range.h"
#include "hodt/optimize/rounded_sum.h"

namespace hodt {

namespace {

// What is measured of one triangle: the same bits whatever corner comes first. All is inlined into
// loops over many triangles, and these become vector code: selections in place of branches, and no
// calls. With corners of WidePoints the same formulas hold for coordinates of any size.

template <class R>
HODT_INLINE R smaller(R x, R y) {
  return x < y ? x : y;
}

template <class R>
HODT_INLINE R larger(R x, R y) {
  return x > y ? x : y;
}

HODT_INLINE double distance(const Point& a, const Point& b) {
  const double x = b.x - a.x, y = b.y - a.y;
  return std::sqrt(x * x + y * y);
}

HODT_INLINE double cross_at(const Point& a, const Point& b, const Point& c) {
  return std::fabs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

/// Twice the area: of the two sides at each corner, their product with the sine.
HODT_INLINE double cross(const Point& a, const Point& b, const Point& c) {
  return larger(cross_at(a, b, c), larger(cross_at(b, c, a), cross_at(c, a, b)));
}

/// Of the two sides at a, their product with the cosine.
HODT_INLINE double dot(const Point& a, const Point& b, const Point& c) {
  return (b.x - a.x) * (c.x - a.x) + (b.y - a.y) * (c.y - a.y);
}

/// A corner whose differences, squares and products no double need hold.
struct WidePoint {
  Point at;
};

WideReal distance(const WidePoint& a, const WidePoint& b) {
  const WideReal x = WideReal(b.at.x) - a.at.x, y = WideReal(b.at.y) - a.at.y;
  return sqrt(x * x + y * y);
}

/// Exact but for the last place: never 0.
WideReal cross(const WidePoint& a, const WidePoint& b, const WidePoint& c) {
  return fabs(exact_cross(a.at, b.at, c.at));
}

WideReal dot(const WidePoint& a, const WidePoint& b, const WidePoint& c) {
  const auto difference = [](double p, double q) { return WideReal(q) - p; };
  return difference(a.at.x, b.at.x) * difference(a.at.x, c.at.x) +
         difference(a.at.y, b.at.y) * difference(a.at.y, c.at.y);
}

using hodt::angle_rank;
WideReal angle_rank(const WideReal& sine, const WideReal& cosine) {
  return -cosine / sine;
}

/// That of the largest angle, as `cross` is the same at all corners.
constexpr auto smallest_dot = [](const auto& a, const auto& b, const auto& c) HODT_INLINE_LAMBDA {
  return smaller(dot(a, b, c), smaller(dot(b, c, a), dot(c, a, b)));
};

constexpr auto largest_dot = [](const auto& a, const auto& b, const auto& c) HODT_INLINE_LAMBDA {
  return larger(dot(a, b, c), larger(dot(b, c, a), dot(c, a, b)));
};

/// Of the edges.
template <class R>
struct Lengths {
  R shortest, middle, longest;
  HODT_INLINE R perimeter() const { return longest + (middle + shortest); }
};

template <class P>
HODT_INLINE auto lengths_of(const P& a, const P& b, const P& c) {
  const auto x = distance(a, b), y = distance(b, c), z = distance(c, a);
  const auto low = smaller(x, y), high = larger(x, y);
  return Lengths<decltype(distance(a, b))>{smaller(low, z), larger(low, smaller(high, z)),
                                           larger(high, z)};
}

constexpr auto area = [](const auto& a, const auto& b, const auto& c)
                          HODT_INLINE_LAMBDA { return cross(a, b, c) / 2; };

constexpr auto largest_angle = [](const auto& a, const auto& b, const auto& c) HODT_INLINE_LAMBDA {
  return degrees(cross(a, b, c), smallest_dot(a, b, c));
};
constexpr auto smallest_angle = [](const auto& a, const auto& b, const auto& c) HODT_INLINE_LAMBDA {
  return degrees(cross(a, b, c), largest_dot(a, b, c));
};
/// These grow with the angles, and take a tenth of the time.
constexpr auto largest_angle_rank =
    [](const auto& a, const auto& b, const auto& c)
        HODT_INLINE_LAMBDA { return angle_rank(cross(a, b, c), smallest_dot(a, b, c)); };
constexpr auto smallest_angle_rank =
    [](const auto& a, const auto& b, const auto& c)
        HODT_INLINE_LAMBDA { return angle_rank(cross(a, b, c), largest_dot(a, b, c)); };

constexpr auto longest_edge = [](const auto& a, const auto& b, const auto& c)
                                  HODT_INLINE_LAMBDA { return lengths_of(a, b, c).longest; };
constexpr auto shortest_edge = [](const auto& a, const auto& b, const auto& c)
                                   HODT_INLINE_LAMBDA { return lengths_of(a, b, c).shortest; };
/// The edges count half: each but those of the hull is in two triangles.
constexpr auto half_perimeter = [](const auto& a, const auto& b, const auto& c) HODT_INLINE_LAMBDA {
  return lengths_of(a, b, c).perimeter() / 2;
};

constexpr auto circumradius = [](const auto& a, const auto& b, const auto& c) HODT_INLINE_LAMBDA {
  const auto lengths = lengths_of(a, b, c);
  return lengths.shortest * lengths.middle * lengths.longest / (2 * cross(a, b, c));
};
constexpr auto enclosing_radius = [](const auto& a, const auto& b,
                                     const auto& c) HODT_INLINE_LAMBDA {
  const auto if_obtuse = longest_edge(a, b, c) / 2, if_acute = circumradius(a, b, c);
  return smallest_dot(a, b, c) <= 0 ? if_obtuse : if_acute;
};
constexpr auto inradius = [](const auto& a, const auto& b, const auto& c) HODT_INLINE_LAMBDA {
  return cross(a, b, c) / lengths_of(a, b, c).perimeter();
};

/// Calls f with the function of the objective's measure, or for angles of their ranks. Flat areas
/// as if all triangles were flat.
template <bool ranks, class F>
void with_measure(TriangleMeasure measure, Aggregate aggregate, const F& f) {
  switch (measure.kind) {
    case TriangleMeasure::area:
    case TriangleMeasure::flat_area:
      return f(area);
    case TriangleMeasure::angle:
      if constexpr (ranks)
        return f(largest_angle_rank);
      else
        return f(largest_angle);
    case TriangleMeasure::small_angle:
      if constexpr (ranks)
        return f(smallest_angle_rank);
      else
        return f(smallest_angle);
    case TriangleMeasure::circumradius:
      return f(circumradius);
    case TriangleMeasure::enclosing_radius:
      return f(enclosing_radius);
    case TriangleMeasure::inradius:
      return f(inradius);
    case TriangleMeasure::length:
      if (aggregate == Aggregate::sum) return f(half_perimeter);
      return aggregate == Aggregate::max ? f(longest_edge) : f(shortest_edge);
    case TriangleMeasure::own:
      break;  // one by one
  }
}

/// better_pair; `sign` is 1 to minimize and -1 to maximize.
template <Aggregate kAggregate>
HODT_INLINE bool is_better_pair(double sign, double a1, double a2, double b1, double b2) {
  if constexpr (kAggregate == Aggregate::sum) {
    // What rounding can have made of equal sums is no gain. No value is negative, and half of each
    // sum is finite.
    const double a = a1 / 2 + a2 / 2, b = b1 / 2 + b2 / 2;
    return sign * (b - a) > 1e-14 * a + 1e-14 * b;
  } else {
    constexpr bool kMax = kAggregate == Aggregate::max;
    const double low_a = sign * smaller(a1, a2), high_a = sign * larger(a1, a2);
    const double low_b = sign * smaller(b1, b2), high_b = sign * larger(b1, b2);
    const double first_a = kMax ? high_a : low_a, first_b = kMax ? high_b : low_b;
    const double second_a = kMax ? low_a : high_a, second_b = kMax ? low_b : high_b;
    return (first_a < first_b) | ((first_a == first_b) & (second_a < second_b));
  }
}

/// What the first pair gains by sums, rounded up; 0 if that is nothing.
HODT_INLINE double gain_of_pair(double sign, double a1, double a2, double b1, double b2) {
  const double a = a1 + a2, b = b1 + b2;
  const double rest = lost_in_sum(b1, b2, b) - lost_in_sum(a1, a2, a);
  const double gain = sign * ((b - a) + rest);
  return larger(gain + 0x1p-50 * (std::fabs(gain) + std::fabs(rest)), 0.0);
}

/// Calls f with the comparison that the objective makes.
template <class F>
void with_better_pair(const Aggregator& aggregator, const F& f) {
  const double sign = aggregator.sign();
  switch (aggregator.objective().aggregate) {
    case Aggregate::sum:
      return f([sign](auto... values)
                   HODT_INLINE_LAMBDA { return is_better_pair<Aggregate::sum>(sign, values...); });
    case Aggregate::max:
      return f([sign](auto... values)
                   HODT_INLINE_LAMBDA { return is_better_pair<Aggregate::max>(sign, values...); });
    case Aggregate::min:
      return f([sign](auto... values)
                   HODT_INLINE_LAMBDA { return is_better_pair<Aggregate::min>(sign, values...); });
  }
}

/// Triangles or quadrilaterals side by side.
template <int kCorners>
class CornerBlock {
 public:
  static constexpr std::size_t kSize =
      248;  // no power of two: see order/first_order/nearest_beyond.cpp

  void set(std::size_t i, const std::array<Point, kCorners>& corners) {
    for (int c = 0; c < kCorners; ++c) {
      x_[c][i] = corners[c].x;
      y_[c][i] = corners[c].y;
    }
  }
  /// values[i] becomes the measure of these corners of the first so many.
  template <class Measured>
  void measure(const Measured& measure, std::size_t size, int a, int b, int c,
               double* values) const {
    run_in_lanes([&]<Index>() HODT_INLINE_LAMBDA {
      for (std::size_t i = 0; i < size; ++i)
        values[i] = measure(corner(a, i), corner(b, i), corner(c, i));
    });
  }

 private:
  HODT_INLINE Point corner(int c, std::size_t i) const { return {x_[c][i], y_[c][i]}; }

  std::array<std::array<double, kSize>, kCorners> x_, y_;
};

constexpr std::size_t kBlock = CornerBlock<3>::kSize;

bool is_angle(TriangleMeasure measure) {
  return measure.kind == TriangleMeasure::angle || measure.kind == TriangleMeasure::small_angle;
}

using PairColumns = std::array<const double*, 2>;

/// What the pairs that are not said to be better gain in spite of that.
void add_missed(double sign, std::size_t size, PairColumns fresh, PairColumns old,
                const std::array<bool, kBlock>& is_better, ExactSum& missed) {
  std::array<double, kBlock> gain;
  double any = 0;
  run_in_lanes([&]<Index>() HODT_INLINE_LAMBDA {
    for (std::size_t i = 0; i < size; ++i)
      gain[i] =
          is_better[i] ? 0 : gain_of_pair(sign, fresh[0][i], fresh[1][i], old[0][i], old[1][i]);
  });
  for (std::size_t i = 0; i < size; ++i) any = larger(any, gain[i]);
  if (any > 0) missed.add({gain.data(), size});
}

}  // namespace

TriangleValues::TriangleValues(const Objective& objective, std::span<const Point> xy,
                               std::span<const double> z)
    : Aggregator(objective),
      measure_(std::get<TriangleMeasure>(objective.measure)),
      is_wide_(measure_.kind != TriangleMeasure::own && !is_plain(xy)),
      is_one_by_one_(is_wide_ || measure_.kind == TriangleMeasure::own ||
                     measure_.kind == TriangleMeasure::flat_area),
      xy_(xy),
      z_(z) {}

double TriangleValues::of(VertexId a, VertexId b, VertexId c) const {
  if (measure_.kind == TriangleMeasure::own) return own_value(a, b, c);
  if (measure_.kind == TriangleMeasure::flat_area && !(z_[a] == z_[b] && z_[b] == z_[c])) return 0;
  if (is_wide_) return wide_value(a, b, c);
  double value = 0;
  with_measure<false>(measure_, objective().aggregate,
                      [&](const auto& measure) { value = measure(xy_[a], xy_[b], xy_[c]); });
  // Where rounding leaves no area.
  return is_finite(value) ? value : wide_value(a, b, c);
}

/// Flips are measured before it is asked whether they can be made. What some would make is no
/// triangle.
bool TriangleValues::is_triangle(VertexId a, VertexId b, VertexId c) const {
  return orient(xy_[a], xy_[b], xy_[c]) != 0;
}

/// The worst value there is, so that such a flip is no gain.
double TriangleValues::of_none() const {
  return sign() > 0 ? std::numeric_limits<double>::max() : 0;
}

/// Of numbers of any size, rounded once.
double TriangleValues::wide_value(VertexId a, VertexId b, VertexId c) const {
  if (!is_triangle(a, b, c)) return of_none();
  if (is_angle(measure_)) return degrees_of_rank(wide_rank(a, b, c));
  WideReal value;
  with_measure<true>(measure_, objective().aggregate, [&](const auto& measure) {
    value = measure(WidePoint{xy_[a]}, WidePoint{xy_[b]}, WidePoint{xy_[c]});
  });
  if (!value.is_in_range()) throw_out_of_range(a, b, c, value.is_large());
  return value.to_double();
}

double TriangleValues::wide_rank(VertexId a, VertexId b, VertexId c) const {
  if (!is_triangle(a, b, c)) return worst();
  WideReal rank;
  with_measure<true>(measure_, objective().aggregate, [&](const auto& measure) {
    rank = measure(WidePoint{xy_[a]}, WidePoint{xy_[b]}, WidePoint{xy_[c]});
  });
  const double rounded = rank.to_double();
  if (rounded == -std::numeric_limits<double>::infinity()) throw_out_of_range(a, b, c, false);
  return rounded;
}

double TriangleValues::own_value(VertexId a, VertexId b, VertexId c) const {
  if (orient(xy_[a], xy_[b], xy_[c]) <= 0) return of_none();  // nor is a clockwise one
  const auto corner = [&](VertexId v) {
    return Corner{xy_[v].x, xy_[v].y, z_.empty() ? 0 : z_[v]};
  };
  // The smallest number comes first, so that the order is that of the triangle.
  if (b < a && b < c)
    std::tie(a, b, c) = std::tuple(b, c, a);
  else if (c < a && c < b)
    std::tie(a, b, c) = std::tuple(c, a, b);
  return checked_own_value(measure_.own_measure->of(corner(a), corner(b), corner(c)), objective(),
                           {xy_[a], xy_[b], xy_[c]});
}

void TriangleValues::throw_out_of_range(VertexId a, VertexId b, VertexId c, bool is_large) const {
  hodt::throw_out_of_range(objective(), is_large, {xy_[a], xy_[b], xy_[c]});
}

bool TriangleValues::better_pair(double a1, double a2, double b1, double b2) const {
  bool is_better = false;
  with_better_pair(*this, [&](const auto& better) { is_better = better(a1, a2, b1, b2); });
  return is_better;
}

void TriangleValues::better_pairs(std::size_t count, const double* a1, const double* a2,
                                  const double* b1, const double* b2, bool* is_better) const {
  with_better_pair(*this, [&](const auto& better) {
    run_in_lanes([&]<Index>() HODT_INLINE_LAMBDA {
      for (std::size_t i = 0; i < count; ++i) is_better[i] = better(a1[i], a2[i], b1[i], b2[i]);
    });
  });
}

/// Calls f with the function that ranks.
template <class F>
void TriangleValues::with_rank(const F& f) const {
  if (is_sum())
    with_measure<false>(measure_, objective().aggregate, f);
  else
    with_measure<true>(measure_, objective().aggregate, f);
}

/// By other numbers than the angles.
bool TriangleValues::compares_angles() const {
  return is_angle(measure_) && !is_sum();
}

double TriangleValues::value(double rank) const {
  return compares_angles() ? degrees_of_rank(rank) : rank;
}

double TriangleValues::rank(VertexId a, VertexId b, VertexId c) const {
  return compares_angles() ? wide_rank(a, b, c) : of(a, b, c);
}

/// Those of triangles, or of the triangles at edges, a block at a time.
class TriangleValues::BlockRanks {
 public:
  BlockRanks(const TriangleValues& values, const TriangleMesh& mesh)
      : values_(values), mesh_(mesh) {}

  /// Of the triangles from `first` on.
  const double* of_triangles(std::size_t first, std::size_t size) {
    const std::span<const Point> xy = values_.xy_;
    const auto corners = [&](std::size_t i) { return mesh_.corners(TriangleId(Index(first + i))); };
    if (!values_.is_one_by_one_) {
      // The points come from somewhere near in memory: asked for in time.
      const Index* const corner = &mesh_.origins()[3 * first];
      const std::size_t known = mesh_.halfedge_count() - 3 * first;
      constexpr std::size_t kAhead = 3 * 64;
      for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t e = 0; e < 3; ++e)
          prefetch(&xy[corner[std::min(3 * i + e + kAhead, known - 1)]]);
        triangles_.set(i, {xy[corner[3 * i]], xy[corner[3 * i + 1]], xy[corner[3 * i + 2]]});
      }
    }
    rank(triangles_, size, {0, 1, 2}, corners, now_[0]);
    return now_[0].data();
  }

  /// Takes up the two triangles at each edge, and the two that its flip makes.
  void at_edges(std::span<const HalfEdgeId> edges) {
    gather(edges);
    rank_corners(edges.size(), {0, 1, 2}, now_[0]);
    rank_corners(edges.size(), {1, 0, 3}, now_[1]);
    rank_flipped(edges.size());
  }
  /// Only the latter.
  void of_flips(std::span<const HalfEdgeId> edges) {
    gather(edges);
    rank_flipped(edges.size());
  }
  const double* now(int side) const { return now_[side].data(); }
  const double* flipped(int side) const { return flipped_[side].data(); }

 private:
  using Column = std::array<double, kBlock>;

  void gather(std::span<const HalfEdgeId> edges) {
    // Which triangles first, then which vertices, then where they are: loads that do not wait for
    // each other.
    for (const HalfEdgeId h : edges) {
      prefetch(&mesh_.origins()[h]);
      prefetch(&mesh_.origins()[mesh_.twin(h)]);
    }
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const HalfEdgeId h = edges[i], twin = mesh_.twin(h);
      corner_[i] = {mesh_.origin(h), mesh_.origin(twin), mesh_.apex(h), mesh_.apex(twin)};
      for (const VertexId v : corner_[i]) prefetch(&values_.xy_[v]);
    }
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const auto [a, b, c, d] = corner_[i];
      quadrilaterals_.set(i, {values_.xy_[a], values_.xy_[b], values_.xy_[c], values_.xy_[d]});
    }
  }
  void rank_flipped(std::size_t size) {
    rank_corners(size, {0, 3, 2}, flipped_[0]);
    rank_corners(size, {1, 2, 3}, flipped_[1]);
  }
  /// The triangle of these corners of each quadrilateral.
  void rank_corners(std::size_t size, std::array<int, 3> at, Column& ranks) const {
    rank(
        quadrilaterals_, size, at,
        [&](std::size_t i) {
          return std::array{corner_[i][at[0]], corner_[i][at[1]], corner_[i][at[2]]};
        },
        ranks);
  }
  /// `corners(i)` are the vertices `at` which the block has its corners.
  template <class Block, class Corners>
  void rank(const Block& block, std::size_t size, std::array<int, 3> at, const Corners& corners,
            Column& ranks) const {
    if (!values_.is_one_by_one_) {
      values_.with_rank([&](const auto& measure) {
        block.measure(measure, size, at[0], at[1], at[2], ranks.data());
      });
      // Infinite ranks are those of angles without area.
      if (values_.compares_angles() || are_finite({ranks.data(), size})) return;
    }
    for (std::size_t i = 0; i < size; ++i) {
      if (!values_.is_one_by_one_ && is_finite(ranks[i])) continue;
      const auto [a, b, c] = corners(i);
      ranks[i] = values_.rank(a, b, c);
    }
  }

  const TriangleValues& values_;
  const TriangleMesh& mesh_;
  CornerBlock<3> triangles_;
  std::array<std::array<VertexId, 4>, kBlock> corner_;
  CornerBlock<4> quadrilaterals_;
  std::array<Column, 2> now_, flipped_;
};

std::size_t TriangleValues::keep_better_flips(const TriangleMesh& mesh, std::span<HalfEdgeId> edges,
                                              ExactSum& missed) const {
  BlockRanks ranks(*this, mesh);
  std::array<bool, kBlock> is_better;
  std::size_t kept = 0;
  for (std::size_t begin = 0; begin < edges.size(); begin += kBlock) {
    const auto part = edges.subspan(begin, std::min(kBlock, edges.size() - begin));
    ranks.at_edges(part);
    better_pairs(part.size(), ranks.flipped(0), ranks.flipped(1), ranks.now(0), ranks.now(1),
                 is_better.data());
    if (is_sum())
      add_missed(sign(), part.size(), {ranks.flipped(0), ranks.flipped(1)},
                 {ranks.now(0), ranks.now(1)}, is_better, missed);
    for (std::size_t i = 0; i < part.size(); ++i) {
      edges[kept] = part[i];
      kept += std::size_t{is_better[i]};
    }
  }
  return kept;
}

struct TriangleValues::Totals {
  explicit Totals(const Aggregator& aggregator) : before(aggregator), after(aggregator) {}

  Total before, after;
  ExactSum replaced;  // for sums: the difference of what flips make to this is what changes
};

/// What a run of triangles combines to, and for largest and smallest values, without those that are
/// flipped.
TriangleValues::Totals TriangleValues::fold(const TriangleMesh& mesh, std::size_t first,
                                            std::size_t last, const Buffer<bool>& flipped) const {
  BlockRanks ranks(*this, mesh);
  Totals totals(*this);
  std::array<double, kBlock> staying;
  for (std::size_t begin = first; begin < last; begin += kBlock) {
    const std::size_t size = std::min(kBlock, last - begin);
    const double* const rank = ranks.of_triangles(begin, size);
    totals.before.add({rank, size});
    if (is_sum()) continue;
    const bool* const is_flipped = &flipped[begin];
    run_in_lanes([&]<Index>() HODT_INLINE_LAMBDA {
      for (std::size_t i = 0; i < size; ++i) staying[i] = is_flipped[i] ? identity() : rank[i];
    });
    totals.after.add({staying.data(), size});
  }
  return totals;
}

/// What the triangles that flips make combine to. Marks those that they take the place of.
TriangleValues::Totals TriangleValues::fold_flipped(const TriangleMesh& mesh,
                                                    std::span<const HalfEdgeId> flips,
                                                    Buffer<bool>& flipped) const {
  BlockRanks ranks(*this, mesh);
  Totals totals(*this);
  for (std::size_t begin = 0; begin < flips.size(); begin += kBlock) {
    const auto part = flips.subspan(begin, std::min(kBlock, flips.size() - begin));
    if (is_sum())
      ranks.at_edges(part);
    else
      ranks.of_flips(part);
    for (const int side : {0, 1}) {
      totals.after.add({ranks.flipped(side), part.size()});
      if (is_sum()) totals.replaced.add({ranks.now(side), part.size()});
    }
    for (const HalfEdgeId h : part)
      for (const HalfEdgeId side : {h, mesh.twin(h)}) flipped[TriangleMesh::triangle(side)] = true;
  }
  return totals;
}

TriangleValues::BeforeAfter TriangleValues::with_flips(const TriangleMesh& mesh,
                                                       std::span<const HalfEdgeId> flips,
                                                       const ExactSum& missed) const {
  constexpr std::size_t kGrain = 1 << 13;
  Buffer<bool> flipped(mesh.triangle_count(), false);
  Totals all(*this);
  const auto add = [&](std::size_t size, const auto& part) {
    const auto find = [&](std::size_t first, std::size_t last, std::vector<Totals>& found) {
      found.push_back(part(first, last));
    };
    for (const Totals& totals : parallel_collect<Totals>(0, size, kGrain, find)) {
      all.before.add(totals.before);
      all.after.add(totals.after);
      all.replaced.add(totals.replaced);
    }
  };
  add(flips.size(), [&](std::size_t first, std::size_t last) {
    return fold_flipped(mesh, flips.subspan(first, last - first), flipped);
  });
  add(flipped.size(),
      [&](std::size_t first, std::size_t last) { return fold(mesh, first, last, flipped); });
  if (!is_sum()) {
    const double after = value(all.after.value());
    return {value(all.before.value()), after, after};
  }
  if (is_total_length(objective())) all.before.add(half_boundary_length(mesh));
  all.after.add(all.before);
  all.after.sum().subtract(all.replaced);
  const double after = all.after.value();
  if (sign() > 0)
    all.after.sum().subtract(missed);
  else
    all.after.sum().add(missed);
  return {all.before.value(), after, all.after.bound()};
}

Total TriangleValues::half_boundary_length(const TriangleMesh& mesh) const {
  Total total(*this);
  for (Index i = 0; i < mesh.halfedge_count(); ++i) {
    const HalfEdgeId h(i);
    if (!mesh.is_boundary(h)) continue;
    const Point &a = xy_[mesh.origin(h)], &b = xy_[mesh.target(h)];
    total.add(is_wide_ ? (distance(WidePoint{a}, WidePoint{b}) / 2).to_double()
                       : distance(a, b) / 2);
  }
  return total;
}

}  // namespace hodt
