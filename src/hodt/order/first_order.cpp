#include "hodt/order/first_order.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <span>

#include "hodt/base/clones.h"
#include "hodt/base/parallel.h"
#include "hodt/geometry/predicates.h"
#include "hodt/order/circle_counter.h"

namespace hodt {

namespace {

/// Two Delaunay triangles and what is across their four outer edges.
///
///            beyond_sv      beyond_vy
///                     \ v /              The edge is s y, its half-edge runs from s to y.
///                     s   y
///                     / u \              .
///            beyond_us      beyond_yu
enum Corner { kS, kY, kV, kU, kBeyondSV, kBeyondVY, kBeyondYU, kBeyondUS, kCorners };

/// Edges side by side. Five of six are not flippable, for one of six reasons; asked one after the
/// other, a processor cannot foretell which it will be. So all six are asked about all edges, as
/// far as rounded arithmetic tells.
class Batch {
 public:
  /// No power of two: the columns would compete for the same places of the cache.
  static constexpr std::size_t kSize = kMostFirstOrderEdges;
  enum Verdict { kNo, kPerhaps, kNearestOutside };

  /// Requires edges with triangles on both sides, kSize at most.
  void judge(const DelaunayGraph& graph, std::span<const HalfEdgeId> edges) {
    for (std::size_t i = 0; i < edges.size(); ++i) set(i, graph, edges[i]);
    judge(edges.size());
  }

  Verdict verdict(std::size_t i) const {
    if (!(magnitude_[i] <= DBL_MAX)) return kPerhaps;
    return high_[i] < 0 ? kNo : low_[i] > 0 ? kNearestOutside : kPerhaps;
  }

 private:
  void set(std::size_t i, const DelaunayGraph& graph, HalfEdgeId h);
  void set(std::size_t i, Corner corner, const Point& p) {
    x_[corner][i] = p.x;
    y_[corner][i] = p.y;
  }
  Point at(Corner corner, std::size_t i) const { return {x_[corner][i], y_[corner][i]}; }
  void judge(std::size_t size);

  std::array<std::array<double, kSize>, kCorners> x_, y_;
  std::array<double, kSize> low_, high_, magnitude_;
};

void Batch::set(std::size_t i, const DelaunayGraph& graph, HalfEdgeId h) {
  const TriangleMesh& mesh = graph.mesh;
  const HalfEdgeId twin = mesh.twin(h);
  const VertexId v = mesh.apex(h), u = mesh.apex(twin);
  // On the hull, a point on the circle that it would be asked about: that leaves it open.
  const auto beyond = [&](HalfEdgeId side, VertexId on_circle) -> const Point& {
    const HalfEdgeId across = mesh.twin(side);
    return graph.point(across.valid() ? mesh.apex(across) : on_circle);
  };
  set(i, kS, graph.point(mesh.origin(h)));
  set(i, kY, graph.point(mesh.target(h)));
  set(i, kV, graph.point(v));
  set(i, kU, graph.point(u));
  set(i, kBeyondVY, beyond(TriangleMesh::next(h), v));
  set(i, kBeyondSV, beyond(TriangleMesh::prev(h), v));
  set(i, kBeyondUS, beyond(TriangleMesh::next(twin), u));
  set(i, kBeyondYU, beyond(TriangleMesh::prev(twin), u));
}

double smaller(double a, double b) {
  return a < b ? a : b;
}

/// What six rounded determinants, all of which have to be positive, tell together.
struct Least {
  double low = DBL_MAX, high = DBL_MAX;  // the least there is is between these
  double size = 0;                       // infinite or NaN if any of them is

  void add(const exact::Filtered& f) {
    low = smaller(low, f.value - f.bound);
    high = smaller(high, f.value + f.bound);
    size += std::fabs(f.value);
  }
};

HODT_CLONES void Batch::judge(std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    const Point s = at(kS, i), y = at(kY, i), v = at(kV, i), u = at(kU, i);
    const exact::CircleFilter around_y(u, v, s), around_s(v, u, y);
    Least least;
    least.add(exact::orient_rounded(u, v, s));
    least.add(exact::orient_rounded(v, u, y));
    least.add(around_y(at(kBeyondYU, i)));
    least.add(around_y(at(kBeyondVY, i)));
    least.add(around_s(at(kBeyondSV, i)));
    least.add(around_s(at(kBeyondUS, i)));
    low_[i] = least.low;
    high_[i] = least.high;
    magnitude_[i] = least.size;
  }
}

using Corners = std::array<VertexId, 3>;

/// holds_only for a circle through the other corners of the quadrilateral with this diagonal and
/// its origin, where the points beyond the sides at the origin are outside.
bool holds_only_origin(const DelaunayGraph& graph, const Corners& corners, HalfEdgeId diagonal) {
  const TriangleMesh& mesh = graph.mesh;
  const auto [a, b, c] = corners;
  const Circle circle(graph.point(a), graph.point(b), graph.point(c));
  const HalfEdgeId last_side = mesh.rotate_cw(diagonal);
  const VertexId last = mesh.apex(mesh.twin(last_side));
  HalfEdgeId h = mesh.rotate_ccw(mesh.rotate_ccw(diagonal));
  for (; h.valid() && mesh.target(h) != last && mesh.apex(h) != last; h = mesh.rotate_ccw(h))
    if (circle.contains(graph.point(mesh.apex(h)))) return false;
  // Unless the boundary was in the way.
  return h.valid() || holds_only(graph, corners, mesh.origin(diagonal));
}

bool is_flippable_beyond_nearest(const DelaunayGraph& graph, HalfEdgeId h) {
  const TriangleMesh& mesh = graph.mesh;
  const HalfEdgeId twin = mesh.twin(h);
  const VertexId s = mesh.origin(h), y = mesh.target(h), v = mesh.apex(h), u = mesh.apex(twin);
  return holds_only_origin(graph, {u, v, s}, twin) && holds_only_origin(graph, {v, u, y}, h);
}

/// With the way to ask whether a circle holds a vertex only.
template <class HoldsOnly>
bool is_flippable(const DelaunayGraph& graph, HalfEdgeId h, const HoldsOnly& holds_only) {
  const TriangleMesh& mesh = graph.mesh;
  if (mesh.is_boundary(h)) return false;
  // The diagonal u v crosses the edge s y; s is to the left of u v, so s, u, y, v go around.
  const VertexId s = mesh.origin(h), y = mesh.target(h);
  const VertexId v = mesh.apex(h), u = mesh.apex(mesh.twin(h));
  const Point &pu = graph.point(u), &pv = graph.point(v);
  const bool is_convex = orient(pu, pv, graph.point(s)) > 0 && orient(pv, pu, graph.point(y)) > 0;
  return is_convex && holds_only({u, v, s}, y) && holds_only({v, u, y}, s);
}

}  // namespace

bool is_first_order_flippable(const DelaunayGraph& graph, HalfEdgeId h) {
  return is_flippable(
      graph, h, [&](const Corners& corners, VertexId v) { return holds_only(graph, corners, v); });
}

std::vector<HalfEdgeId> first_order_edges(const DelaunayGraph& graph,
                                          const KeepWanted& keep_wanted) {
  const TriangleMesh& mesh = graph.mesh;
  SoleInside inside(graph);
  const auto holds_only = [&](const Corners& corners, VertexId v) {
    return inside.holds_only(corners, v);
  };
  const auto find = [&](std::size_t first, std::size_t last, std::vector<HalfEdgeId>& found) {
    Batch batch;
    std::array<HalfEdgeId, Batch::kSize> edges;
    for (std::size_t begin = first; begin < last; begin += Batch::kSize) {
      std::size_t size = 0;
      for (std::size_t i = begin; i < std::min(last, begin + Batch::kSize); ++i) {
        const HalfEdgeId h{Index(i)};
        edges[size] = h;
        size += std::size_t(!mesh.is_boundary(h)) & std::size_t(h < mesh.twin(h));
      }
      if (keep_wanted) size = keep_wanted({edges.data(), size});
      batch.judge(graph, {edges.data(), size});
      for (std::size_t i = 0; i < size; ++i) {
        const Batch::Verdict verdict = batch.verdict(i);
        if (verdict == Batch::kNo) continue;
        if (verdict == Batch::kNearestOutside ? is_flippable_beyond_nearest(graph, edges[i])
                                              : is_flippable(graph, edges[i], holds_only))
          found.push_back(edges[i]);
      }
    }
  };
  return parallel_collect<HalfEdgeId>(0, mesh.halfedge_count(), 1 << 14, find);
}

}  // namespace hodt
