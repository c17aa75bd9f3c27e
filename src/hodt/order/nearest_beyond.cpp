#include "hodt/order/nearest_beyond.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "hodt/base/lanes.h"
#include "hodt/geometry/predicate_stages.h"

namespace hodt {

namespace {

HODT_INLINE double smaller(double a, double b) {
  return a < b ? a : b;
}

/// What rounded determinants, all of which have to be positive, tell together.
struct Least {
  double low = DBL_MAX, high = DBL_MAX;  // the least there is is between these
  double size = 0;                       // infinite or NaN if any of them is

  HODT_INLINE void add(const exact::Filtered& f) {
    low = smaller(low, f.value - f.bound);
    high = smaller(high, f.value + f.bound);
    size += std::fabs(f.value);
  }
  /// As a number, for loops over doubles.
  HODT_INLINE double verdict() const {
    constexpr double kInside = NearestBeyond::kInside, kUnknown = NearestBeyond::kUnknown,
                     kOutside = NearestBeyond::kOutside;
    const double if_none_inside = low > 0 ? kOutside : kUnknown;
    const double if_finite = high < 0 ? kInside : if_none_inside;
    return size <= DBL_MAX ? if_finite : kUnknown;
  }
};

/// Triangles side by side, with the apexes across their edges.
class Block {
 public:
  /// No power of two: the columns would compete for the same places of the cache.
  static constexpr std::size_t kSize = 124;

  /// Sets the verdicts on the left of each triangle's half-edges.
  void judge(const DelaunayGraph& graph, std::size_t first, std::size_t size,
             std::uint8_t* verdicts) {
    gather(graph, first, size);
    judge(size, verdicts);
  }

 private:
  void gather(const DelaunayGraph& graph, std::size_t first, std::size_t size);
  void judge(std::size_t size, std::uint8_t* verdicts);
  template <int e>
  HODT_INLINE double verdict_on_left(std::size_t i) const;
  HODT_INLINE Point at(int corner, std::size_t i) const { return {x_[corner][i], y_[corner][i]}; }

  // Corners 0, 1, 2, and what is across the edges that leave them.
  std::array<std::array<Index, kSize>, 6> vertex_;
  std::array<std::array<double, kSize>, 6> x_, y_;
  std::array<double, kSize> verdict_;
};

void Block::gather(const DelaunayGraph& graph, std::size_t first, std::size_t size) {
  const TriangleMesh& mesh = graph.mesh;
  // The triangles come from memory one after another, their neighbours from somewhere near.
  constexpr std::size_t kAhead = 64;
  const auto last = static_cast<Index>(mesh.halfedge_count() - 1);
  // Which vertices first, then where they are: loads that do not wait for each other.
  for (std::size_t i = 0; i < size; ++i) {
    const Index* const ahead =
        &mesh.twins()[3 * std::min(first + i + kAhead, mesh.triangle_count() - 1)];
    for (std::size_t e = 0; e < 3; ++e) {
      prefetch(&mesh.origins()[std::min(ahead[e], last)]);
      const HalfEdgeId h(static_cast<Index>(3 * (first + i) + e)), twin = mesh.twin(h);
      // On the boundary, the apex itself: it is on the circles, and leaves them undecided.
      const VertexId across = mesh.apex(twin.valid() ? twin : h);
      vertex_[e][i] = mesh.origin(h);
      vertex_[3 + e][i] = across;
      prefetch(&graph.point(across));
    }
  }
  for (int corner = 0; corner < 6; ++corner)
    for (std::size_t i = 0; i < size; ++i) {
      const Point& p = graph.xy[vertex_[corner][i]];
      x_[corner][i] = p.x;
      y_[corner][i] = p.y;
    }
}

/// Of the edge s y with the apexes v and u: the circle of what the flip makes at s holds y, and
/// beyond_vy is to be outside; likewise beyond_sv at y.
template <int e>
HODT_INLINE double Block::verdict_on_left(std::size_t i) const {
  constexpr int e1 = (e + 1) % 3, e2 = (e + 2) % 3;
  const Point s = at(e, i), y = at(e1, i), v = at(e2, i), u = at(3 + e, i);
  const exact::CircleFilter around_y(u, v, s), around_s(v, u, y);
  Least least;
  least.add(exact::orient_rounded(v, s, u));
  least.add(exact::orient_rounded(u, y, v));
  least.add(around_y(at(3 + e1, i)));
  least.add(around_s(at(3 + e2, i)));
  return least.verdict();
}

void Block::judge(std::size_t size, std::uint8_t* verdicts) {
  run_in_lanes([&]<Index>() HODT_INLINE_LAMBDA {
    for (std::size_t i = 0; i < size; ++i)
      verdict_[i] = verdict_on_left<0>(i) + 4 * verdict_on_left<1>(i) + 16 * verdict_on_left<2>(i);
  });
  for (std::size_t i = 0; i < size; ++i) verdicts[i] = static_cast<std::uint8_t>(verdict_[i]);
}

}  // namespace

void NearestBeyond::judge(std::size_t first, std::size_t count) {
  first_ = first;
  count_ = count;
  Block block;
  for (std::size_t t = 0; t < count; t += Block::kSize)
    block.judge(graph_, first + t, std::min(Block::kSize, count - t), &verdicts_[t]);
}

}  // namespace hodt
