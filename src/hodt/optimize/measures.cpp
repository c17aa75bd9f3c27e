#include "hodt/optimize/measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "hodt/base/lanes.h"
#include "hodt/base/parallel.h"
#include "hodt/mesh/boundary.h"
#include "hodt/optimize/angle.h"

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
constexpr auto largest_half_tangent = [](P a, P b, P c) HODT_INLINE_LAMBDA {
  return half_tangent(cross(a, b, c), smallest_dot(a, b, c));
};
constexpr auto smallest_half_tangent = [](P a, P b, P c) HODT_INLINE_LAMBDA {
  return half_tangent(cross(a, b, c), largest_dot(a, b, c));
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

/// Calls f with the function of the objective's measure, angles as half tangents if so asked for.
/// Flat areas as if all triangles were flat.
template <bool half_tangents, class F>
void with_measure(const Objective& objective, const F& f) {
  switch (objective.measure) {
    case Measure::area:
    case Measure::flat_area:
      return f(area);
    case Measure::angle:
      if constexpr (half_tangents)
        return f(largest_half_tangent);
      else
        return f(largest_angle);
    case Measure::small_angle:
      if constexpr (half_tangents)
        return f(smallest_half_tangent);
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
    const double low_a = smaller(a1, a2), high_a = larger(a1, a2);
    const double low_b = smaller(b1, b2), high_b = larger(b1, b2);
    const double gain = sign * (kMax ? high_b - high_a : low_b - low_a);
    const double second_gain = sign * (kMax ? low_b - low_a : high_b - high_a);
    return (gain > 0) | ((gain == 0) & (second_gain > 0));
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
  static constexpr std::size_t kSize = 248;  // no power of two: see order/first_order.cpp

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

}  // namespace

double TriangleValues::of(VertexId a, VertexId b, VertexId c) const {
  if (is_flat_area_ && !(z_[a] == z_[b] && z_[b] == z_[c])) return 0;
  double value = 0;
  with_measure<false>(
      objective(), [&](const auto& measure) { value = finite(measure(xy_[a], xy_[b], xy_[c])); });
  return value;
}

/// Calls f with the function that ranks.
template <class F>
void TriangleValues::with_rank(const F& f) const {
  if (objective().aggregate == Aggregate::sum)
    with_measure<false>(objective(), f);
  else
    with_measure<true>(objective(), f);
}

Buffer<double> TriangleValues::ranks(const TriangleMesh& mesh) const {
  Buffer<double> ranks(mesh.triangle_count());
  parallel_for(0, ranks.size(), 1 << 14, [&](std::size_t first, std::size_t last) {
    Block<3> block;
    for (std::size_t begin = first; begin < last; begin += block.kSize) {
      const std::size_t size = std::min(last - begin, block.kSize);
      if (is_flat_area_) {
        for (std::size_t t = begin; t < begin + size; ++t) {
          const auto [a, b, c] = mesh.corners(TriangleId(Index(t)));
          ranks[t] = of(a, b, c);
        }
        continue;
      }
      for (std::size_t i = 0; i < size; ++i) {
        const auto [a, b, c] = mesh.corners(TriangleId(Index(begin + i)));
        block.set(i, {xy_[a], xy_[b], xy_[c]});
      }
      with_rank([&](const auto& measure) { block.measure(measure, size, 0, 1, 2, &ranks[begin]); });
    }
  });
  return ranks;
}

void TriangleValues::ranks_flipped(const TriangleMesh& mesh, std::span<const HalfEdgeId> edges,
                                   double* left, double* right) const {
  Block<4> block;
  for (std::size_t begin = 0; begin < edges.size(); begin += block.kSize) {
    const std::size_t size = std::min(edges.size() - begin, block.kSize);
    for (std::size_t i = 0; i < size; ++i) {
      const HalfEdgeId h = edges[begin + i];
      const VertexId a = mesh.origin(h), b = mesh.target(h);
      const VertexId c = mesh.apex(h), d = mesh.apex(mesh.twin(h));
      if (is_flat_area_) {
        left[begin + i] = of(a, d, c);
        right[begin + i] = of(b, c, d);
      } else {
        block.set(i, {xy_[a], xy_[b], xy_[c], xy_[d]});
      }
    }
    if (is_flat_area_) continue;
    with_rank([&](const auto& measure) {
      block.measure(measure, size, 0, 3, 2, left + begin);
      block.measure(measure, size, 1, 2, 3, right + begin);
    });
  }
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

double TriangleValues::of(const TriangleMesh& mesh, std::span<const double> ranks) const {
  if (ranks.empty()) return neutral();
  if (objective().aggregate != Aggregate::sum) {
    std::size_t decisive = 0;
    for (std::size_t t = 1; t < ranks.size(); ++t)
      if (combine(ranks[t], ranks[decisive]) != ranks[decisive]) decisive = t;
    const auto [a, b, c] = mesh.corners(TriangleId(Index(decisive)));
    return of(a, b, c);
  }
  const double sum =
      parallel_sum(0, ranks.size(), 1 << 16, [&](std::size_t first, std::size_t last) {
        return std::accumulate(ranks.data() + first, ranks.data() + last, 0.0);
      });
  return objective().measure == Measure::length ? sum + half_boundary_length(mesh) : sum;
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
