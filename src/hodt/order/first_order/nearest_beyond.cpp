#include "hodt/order/first_order/nearest_beyond.h"

#include <algorithm>

#include "hodt/base/lanes.h"
#include "hodt/base/prefetch.h"
#include "hodt/geometry/predicate_stages.h"

namespace hodt {

namespace {

/// Triangles side by side, with the apexes across their edges.
class TriangleBlock {
 public:
  /// No power of two: the columns would compete for the same places of the cache.
  static constexpr std::size_t kSize = 124;

  /// Sets the bits of each triangle's edges.
  void judge(const DelaunayGraph& graph, std::size_t first, std::size_t size,
             std::uint8_t* ruled_out) {
    if (graph.has_walls())
      gather<true>(graph, first, size);
    else
      gather<false>(graph, first, size);
    judge(size, ruled_out);
  }

 private:
  template <bool kWalls>
  void gather(const DelaunayGraph& graph, std::size_t first, std::size_t size);
  void judge(std::size_t size, std::uint8_t* ruled_out);
  template <int e>
  HODT_INLINE bool is_ruled_out(std::size_t i) const;
  HODT_INLINE Point at(int corner, std::size_t i) const { return {x_[corner][i], y_[corner][i]}; }

  // Corners 0, 1, 2, and what is across the edges that leave them.
  std::array<std::array<Index, kSize>, 6> vertex_;
  std::array<std::array<double, kSize>, 6> x_, y_;
  std::array<double, kSize> bits_;
};

template <bool kWalls>
void TriangleBlock::gather(const DelaunayGraph& graph, std::size_t first, std::size_t size) {
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
      // At the boundary or a wall, the apex itself: it is on the circles, and leaves them
      // undecided.
      const bool is_open = twin.valid() && !(kWalls && graph.walls[h]);
      const VertexId across = mesh.apex(is_open ? twin : h);
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
HODT_INLINE bool TriangleBlock::is_ruled_out(std::size_t i) const {
  constexpr int e1 = (e + 1) % 3, e2 = (e + 2) % 3;
  const Point s = at(e, i), y = at(e1, i), v = at(e2, i), u = at(3 + e, i);
  const exact::CircleFilter around_y(u, v, s), around_s(v, u, y);
  exact::AllPositive all;
  all.add(exact::orient_rounded(v, s, u));
  all.add(exact::orient_rounded(u, y, v));
  all.add(around_y(at(3 + e1, i)));
  all.add(around_s(at(3 + e2, i)));
  return all.is_impossible();
}

void TriangleBlock::judge(std::size_t size, std::uint8_t* ruled_out) {
  run_in_lanes([&]<Index>() HODT_INLINE_LAMBDA {
    // As numbers like those that they come from, else the loop does not become vector code.
    for (std::size_t i = 0; i < size; ++i)
      bits_[i] = (is_ruled_out<0>(i) ? 1.0 : 0.0) + (is_ruled_out<1>(i) ? 2.0 : 0.0) +
                 (is_ruled_out<2>(i) ? 4.0 : 0.0);
  });
  for (std::size_t i = 0; i < size; ++i) ruled_out[i] = static_cast<std::uint8_t>(bits_[i]);
}

}  // namespace

void NearestBeyond::judge(std::size_t first, std::size_t count) {
  first_ = first;
  count_ = count;
  TriangleBlock block;
  for (std::size_t t = 0; t < count; t += TriangleBlock::kSize)
    block.judge(graph_, first + t, std::min(TriangleBlock::kSize, count - t), &ruled_out_[t]);
}

}  // namespace hodt
