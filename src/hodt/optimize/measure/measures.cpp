#include "hodt/optimize/measure/measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "hodt/base/lanes.h"
#include "hodt/base/parallel.h"
#include "hodt/base/prefetch.h"
#include "hodt/mesh/boundary.h"
#include "hodt/optimize/measure/angle.h"

namespace hodt {

namespace {

// What is measured of one triangle: the same bits whatever corner comes first. All is inlined into
// loops over many triangles, and these become vector code: selections in place of branches, and no
// calls.

HODT_INLINE double smaller(double x, double y) {
  return x < y ? x : y;
}

HODT_INLINE double larger(double x, double y) {
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

/// That of the largest angle, as `cross` is the same at all corners.
HODT_INLINE double smallest_dot(const Point& a, const Point& b, const Point& c) {
  return smaller(dot(a, b, c), smaller(dot(b, c, a), dot(c, a, b)));
}

HODT_INLINE double largest_dot(const Point& a, const Point& b, const Point& c) {
  return larger(dot(a, b, c), larger(dot(b, c, a), dot(c, a, b)));
}

/// Of the edges.
struct Lengths {
  double shortest, middle, longest;

  HODT_INLINE Lengths(const Point& a, const Point& b, const Point& c) {
    const double x = distance(a, b), y = distance(b, c), z = distance(c, a);
    const double low = smaller(x, y), high = larger(x, y);
    shortest = smaller(low, z);
    middle = larger(low, smaller(high, z));
    longest = larger(high, z);
  }
  HODT_INLINE double perimeter() const { return longest + (middle + shortest); }
};

using P = const Point&;

constexpr auto area = [](P a, P b, P c) HODT_INLINE_LAMBDA { return cross(a, b, c) / 2; };

constexpr auto largest_angle = [](P a, P b, P c) HODT_INLINE_LAMBDA {
  return degrees(cross(a, b, c), smallest_dot(a, b, c));
};
constexpr auto smallest_angle = [](P a, P b, P c) HODT_INLINE_LAMBDA {
  return degrees(cross(a, b, c), largest_dot(a, b, c));
};
/// These grow with the angles, and take a tenth of the time.
constexpr auto largest_angle_rank = [](P a, P b, P c) HODT_INLINE_LAMBDA {
  return angle_rank(cross(a, b, c), smallest_dot(a, b, c));
};
constexpr auto smallest_angle_rank = [](P a, P b, P c) HODT_INLINE_LAMBDA {
  return angle_rank(cross(a, b, c), largest_dot(a, b, c));
};

constexpr auto longest_edge = [](P a, P b, P c)
                                  HODT_INLINE_LAMBDA { return Lengths(a, b, c).longest; };
constexpr auto shortest_edge = [](P a, P b, P c)
                                   HODT_INLINE_LAMBDA { return Lengths(a, b, c).shortest; };
/// The edges count half: each but those of the hull is in two triangles.
constexpr auto half_perimeter = [](P a, P b, P c)
                                    HODT_INLINE_LAMBDA { return Lengths(a, b, c).perimeter() / 2; };

constexpr auto circumradius = [](P a, P b, P c) HODT_INLINE_LAMBDA {
  const Lengths lengths(a, b, c);
  return lengths.shortest * lengths.middle * lengths.longest / (2 * cross(a, b, c));
};
constexpr auto enclosing_radius = [](P a, P b, P c) HODT_INLINE_LAMBDA {
  const double if_obtuse = longest_edge(a, b, c) / 2, if_acute = circumradius(a, b, c);
  return smallest_dot(a, b, c) <= 0 ? if_obtuse : if_acute;
};
constexpr auto inradius = [](P a, P b, P c) HODT_INLINE_LAMBDA {
  return cross(a, b, c) / Lengths(a, b, c).perimeter();
};

/// Calls f with the function of the objective's measure, or for angles of their ranks. Flat areas
/// as if all triangles were flat.
template <bool ranks, class F>
void with_measure(const Objective& objective, const F& f) {
  switch (objective.measure) {
    case Measure::area:
    case Measure::flat_area:
      return f(area);
    case Measure::angle:
      if constexpr (ranks)
        return f(largest_angle_rank);
      else
        return f(largest_angle);
    case Measure::small_angle:
      if constexpr (ranks)
        return f(smallest_angle_rank);
      else
        return f(smallest_angle);
    case Measure::circumradius:
      return f(circumradius);
    case Measure::enclosing_radius:
      return f(enclosing_radius);
    case Measure::inradius:
      return f(inradius);
    case Measure::length:
      if (objective.aggregate == Aggregate::sum) return f(half_perimeter);
      return objective.aggregate == Aggregate::max ? f(longest_edge) : f(shortest_edge);
    case Measure::abn:
    case Measure::jnd:
    case Measure::wabn:
      return;  // of edges
  }
}

/// better_pair; `sign` is 1 to minimize and -1 to maximize.
template <Aggregate kAggregate>
HODT_INLINE bool is_better_pair(double sign, double a1, double a2, double b1, double b2) {
  if constexpr (kAggregate == Aggregate::sum) {
    // What rounding can have made of equal sums is no gain.
    const double size = std::fabs(a1) + std::fabs(a2) + std::fabs(b1) + std::fabs(b2);
    return sign * ((b1 + b2) - (a1 + a2)) > 1e-14 * size;
  } else {
    constexpr bool kMax = kAggregate == Aggregate::max;
    const double low_a = sign * smaller(a1, a2), high_a = sign * larger(a1, a2);
    const double low_b = sign * smaller(b1, b2), high_b = sign * larger(b1, b2);
    const double first_a = kMax ? high_a : low_a, first_b = kMax ? high_b : low_b;
    const double second_a = kMax ? low_a : high_a, second_b = kMax ? low_b : high_b;
    return (first_a < first_b) | ((first_a == first_b) & (second_a < second_b));
  }
}

/// Calls f with the comparison that the objective makes.
template <class F>
void with_better_pair(const Combination& combination, const F& f) {
  const double sign = combination.sign();
  switch (combination.objective().aggregate) {
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
class Block {
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
        values[i] = finite(measure(corner(a, i), corner(b, i), corner(c, i)));
    });
  }

 private:
  HODT_INLINE Point corner(int c, std::size_t i) const { return {x_[c][i], y_[c][i]}; }

  std::array<std::array<double, kSize>, kCorners> x_, y_;
};

constexpr std::size_t kBlock = Block<3>::kSize;

}  // namespace

double TriangleValues::of(VertexId a, VertexId b, VertexId c) const {
  if (is_flat_area_ && !(z_[a] == z_[b] && z_[b] == z_[c])) return 0;
  double value = 0;
  with_measure<false>(
      objective(), [&](const auto& measure) { value = finite(measure(xy_[a], xy_[b], xy_[c])); });
  return value;
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
  if (objective().aggregate == Aggregate::sum)
    with_measure<false>(objective(), f);
  else
    with_measure<true>(objective(), f);
}

double TriangleValues::value(double rank) const {
  const Objective o = objective();
  const bool is_angle = o.measure == Measure::angle || o.measure == Measure::small_angle;
  return is_angle && o.aggregate != Aggregate::sum ? degrees_of_rank(rank) : rank;
}

/// Those of triangles, or of the triangles at edges, a block at a time.
class TriangleValues::Ranks {
 public:
  Ranks(const TriangleValues& values, const TriangleMesh& mesh) : values_(values), mesh_(mesh) {}

  /// Of the triangles from `first` on.
  const double* of_triangles(std::size_t first, std::size_t size) {
    const std::span<const Point> xy = values_.xy_;
    if (values_.is_flat_area_) {
      for (std::size_t i = 0; i < size; ++i) {
        const auto [a, b, c] = mesh_.corners(TriangleId(Index(first + i)));
        now_[0][i] = values_.of(a, b, c);
      }
      return now_[0].data();
    }
    // The points come from somewhere near in memory: asked for in time.
    const Index* const corner = &mesh_.origins()[3 * first];
    const std::size_t known = mesh_.halfedge_count() - 3 * first;
    constexpr std::size_t kAhead = 3 * 64;
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t e = 0; e < 3; ++e)
        prefetch(&xy[corner[std::min(3 * i + e + kAhead, known - 1)]]);
      triangles_.set(i, {xy[corner[3 * i]], xy[corner[3 * i + 1]], xy[corner[3 * i + 2]]});
    }
    values_.with_rank(
        [&](const auto& measure) { triangles_.measure(measure, size, 0, 1, 2, now_[0].data()); });
    return now_[0].data();
  }

  /// Takes up the two triangles at each edge, and the two that its flip makes.
  void at_edges(std::span<const HalfEdgeId> edges) {
    gather(edges);
    measure(edges.size(), 0, 1, 2, now_[0]);
    measure(edges.size(), 1, 0, 3, now_[1]);
    measure_flipped(edges.size());
  }
  /// Only the latter.
  void of_flips(std::span<const HalfEdgeId> edges) {
    gather(edges);
    measure_flipped(edges.size());
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
  void measure_flipped(std::size_t size) {
    measure(size, 0, 3, 2, flipped_[0]);
    measure(size, 1, 2, 3, flipped_[1]);
  }
  /// The triangle of these corners of each quadrilateral.
  void measure(std::size_t size, int a, int b, int c, Column& ranks) const {
    if (values_.is_flat_area_) {
      for (std::size_t i = 0; i < size; ++i)
        ranks[i] = values_.of(corner_[i][a], corner_[i][b], corner_[i][c]);
      return;
    }
    values_.with_rank([&](const auto& measure) {
      quadrilaterals_.measure(measure, size, a, b, c, ranks.data());
    });
  }

  const TriangleValues& values_;
  const TriangleMesh& mesh_;
  Block<3> triangles_;
  std::array<std::array<VertexId, 4>, kBlock> corner_;
  Block<4> quadrilaterals_;
  std::array<Column, 2> now_, flipped_;
};

std::size_t TriangleValues::keep_better_flips(const TriangleMesh& mesh,
                                              std::span<HalfEdgeId> edges) const {
  Ranks ranks(*this, mesh);
  std::array<bool, kBlock> is_better;
  std::size_t kept = 0;
  for (std::size_t begin = 0; begin < edges.size(); begin += kBlock) {
    const auto part = edges.subspan(begin, std::min(kBlock, edges.size() - begin));
    ranks.at_edges(part);
    better_pairs(part.size(), ranks.flipped(0), ranks.flipped(1), ranks.now(0), ranks.now(1),
                 is_better.data());
    for (std::size_t i = 0; i < part.size(); ++i) {
      edges[kept] = part[i];
      kept += std::size_t{is_better[i]};
    }
  }
  return kept;
}

/// What a run of triangles combines to, and without those that are flipped.
TriangleValues::BeforeAfter TriangleValues::fold(const TriangleMesh& mesh, std::size_t first,
                                                 std::size_t last,
                                                 const Buffer<bool>& flipped) const {
  Ranks ranks(*this, mesh);
  BeforeAfter result{neutral(), neutral()};
  std::array<double, kBlock> staying;
  for (std::size_t begin = first; begin < last; begin += kBlock) {
    const std::size_t size = std::min(kBlock, last - begin);
    const double* const rank = ranks.of_triangles(begin, size);
    const bool* const is_flipped = &flipped[begin];
    run_in_lanes([&]<Index>() HODT_INLINE_LAMBDA {
      for (std::size_t i = 0; i < size; ++i) staying[i] = is_flipped[i] ? neutral() : rank[i];
    });
    result.before = combine(result.before, combine({rank, size}));
    result.after = combine(result.after, combine({staying.data(), size}));
  }
  return result;
}

/// What the triangles that flips make combine to. Marks those that they take the place of.
double TriangleValues::fold_flipped(const TriangleMesh& mesh, std::span<const HalfEdgeId> flips,
                                    Buffer<bool>& flipped) const {
  Ranks ranks(*this, mesh);
  double result = neutral();
  for (std::size_t begin = 0; begin < flips.size(); begin += kBlock) {
    const auto part = flips.subspan(begin, std::min(kBlock, flips.size() - begin));
    ranks.of_flips(part);
    for (const int side : {0, 1})
      result = combine(result, combine({ranks.flipped(side), part.size()}));
    for (const HalfEdgeId h : part)
      for (const HalfEdgeId side : {h, mesh.twin(h)}) flipped[TriangleMesh::triangle(side)] = true;
  }
  return result;
}

TriangleValues::BeforeAfter TriangleValues::with_flips(const TriangleMesh& mesh,
                                                       std::span<const HalfEdgeId> flips) const {
  constexpr std::size_t kGrain = 1 << 13;
  Buffer<bool> flipped(mesh.triangle_count(), false);
  BeforeAfter all{neutral(), neutral()};
  const auto add = [&](std::size_t size, const auto& part) {
    const auto find = [&](std::size_t first, std::size_t last, std::vector<BeforeAfter>& found) {
      found.push_back(part(first, last));
    };
    for (const auto& [before, after] : parallel_collect<BeforeAfter>(0, size, kGrain, find))
      all = {combine(all.before, before), combine(all.after, after)};
  };
  add(flips.size(), [&](std::size_t first, std::size_t last) {
    return BeforeAfter{neutral(), fold_flipped(mesh, flips.subspan(first, last - first), flipped)};
  });
  add(flipped.size(),
      [&](std::size_t first, std::size_t last) { return fold(mesh, first, last, flipped); });
  all = {value(all.before), value(all.after)};
  if (objective().measure == Measure::length && objective().aggregate == Aggregate::sum) {
    const double missing = half_boundary_length(mesh);
    all = {all.before + missing, all.after + missing};
  }
  return all;
}

/// What is missing when the edges of all triangles count half: that of the hull.
double TriangleValues::half_boundary_length(const TriangleMesh& mesh) const {
  double sum = 0;
  const HalfEdgeId start = first_on_boundary(mesh);
  HalfEdgeId h = start;
  do {
    sum += finite(distance(xy_[mesh.origin(h)], xy_[mesh.target(h)])) / 2;
    h = following_on_boundary(mesh, h);
  } while (h != start);
  return sum;
}

}  // namespace hodt
