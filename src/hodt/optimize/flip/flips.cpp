#include "hodt/optimize/flip/flips.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "hodt/geometry/predicates.h"
#include "hodt/mesh/degrees.h"
#include "hodt/order/circle_counter.h"

namespace hodt {

namespace {

/// The corners of the two triangles at an inner edge ab: abc on the left, and bad.
struct Quadrilateral {
  VertexId a, b, c, d;
};

/// `Better` says of a quadrilateral whose diagonal ab could be replaced by dc whether that is
/// better. It may have a member flipped(quadrilateral), which is told what was replaced.
template <class Better>
class Flipper {
 public:
  Flipper(const DelaunayGraph& graph, Index k, Better& better, TriangleMesh& mesh)
      : graph_(graph),
        k_(k),
        better_(better),
        mesh_(mesh),
        counter_(graph),
        queued_(mesh.halfedge_count(), false) {}

  /// Returns whether there was any.
  bool run(const Deadline& deadline) {
    bool any = false;
    for (Index h = 0; h < mesh_.halfedge_count(); ++h) push(HalfEdgeId(h));
    while (!queue_.empty()) {
      if (deadline.passed()) return false;
      const HalfEdgeId h = queue_.back();
      queue_.pop_back();
      queued_[h] = false;
      if (mesh_.is_boundary(h)) continue;  // since it was queued, it came to name another edge
      const Quadrilateral q = quadrilateral(h);
      if (!improves(h, q)) continue;
      flip(h);
      if constexpr (requires { better_.flipped(q); }) better_.flipped(q);
      any = true;
    }
    return any;
  }
  /// For what depends on all that is around the corners, where a flip can make another one better
  /// that is further away than run() looks.
  void run_to_the_end(const Deadline& deadline) {
    while (run(deadline)) continue;
  }

 private:
  void push(HalfEdgeId h) {
    if (mesh_.is_boundary(h) || queued_[h] || queued_[mesh_.twin(h)]) return;
    queued_[h] = true;
    queue_.push_back(h);
  }

  Quadrilateral quadrilateral(HalfEdgeId h) const {
    return {mesh_.origin(h), mesh_.target(h), mesh_.apex(h), mesh_.apex(mesh_.twin(h))};
  }

  bool improves(HalfEdgeId h, const Quadrilateral& q) {
    const Point &a = graph_.point(q.a), &b = graph_.point(q.b);
    const Point &c = graph_.point(q.c), &d = graph_.point(q.d);
    if (orient(a, d, c) <= 0 || orient(b, c, d) <= 0) return false;  // not convex
    if (graph_.is_wall(q.a, q.b)) return false;
    return better_(mesh_, h, q) && counter_.count(q.a, q.d, q.c, k_) <= k_ &&
           counter_.count(q.b, q.c, q.d, k_) <= k_;
  }

  void flip(HalfEdgeId h) {
    const HalfEdgeId diagonal = mesh_.flip(h);
    for (const HalfEdgeId inner : {diagonal, mesh_.twin(diagonal)}) {
      for (const HalfEdgeId side : {TriangleMesh::next(inner), TriangleMesh::prev(inner)}) {
        push(side);
        // What flipping these would change includes the sides.
        if (mesh_.is_boundary(side)) continue;
        push(TriangleMesh::next(mesh_.twin(side)));
        push(TriangleMesh::prev(mesh_.twin(side)));
      }
    }
  }

  const DelaunayGraph& graph_;
  const Index k_;
  Better& better_;
  TriangleMesh& mesh_;
  CircleCounter counter_;
  std::vector<bool> queued_;
  std::vector<HalfEdgeId> queue_;
};

/// Calls f(u, v) for every edge once.
template <class F>
void for_each_edge_of(const TriangleMesh& mesh, const F& f) {
  for (Index i = 0; i < mesh.halfedge_count(); ++i)
    if (const HalfEdgeId h(i); mesh.is_boundary(h) || h < mesh.twin(h))
      f(mesh.origin(h), mesh.target(h));
}

/// A flip is better that makes the larger degree at the ends of the edge smaller. The degrees are
/// kept, as counting those of hubs would take long.
class SmallerDegrees {
 public:
  explicit SmallerDegrees(const TriangleMesh& mesh) : degree_(degrees_of(mesh)) {}
  bool operator()(const TriangleMesh&, HalfEdgeId, const Quadrilateral& q) const {
    return std::max(degree_[q.c], degree_[q.d]) + 1 < std::max(degree_[q.a], degree_[q.b]);
  }
  void flipped(const Quadrilateral& q) {
    --degree_[q.a], --degree_[q.b];
    ++degree_[q.c], ++degree_[q.d];
  }

 private:
  Buffer<Index> degree_;
};

/// A flip is better that leaves fewer minima and maxima. What removes each vertex, as one or the
/// other, is counted.
class FewerExtrema {
 public:
  FewerExtrema(const TriangleMesh& mesh, const Heights& heights, const Buffer<bool>& kept)
      : heights_(heights), kept_(kept) {
    for (Buffer<Index>& removers : removers_) removers = Buffer<Index>(mesh.vertex_count(), 0);
    for_each_edge_of(mesh, [&](VertexId u, VertexId v) { count(u, v, 1); });
  }
  bool operator()(const TriangleMesh&, HalfEdgeId, const Quadrilateral& q) const {
    if (kept_[heights_.lower(q.c, q.d) ? q.d : q.c]) return false;
    int gained = 0;
    for (const Extremum kind : kExtrema) {
      gained -= removes_with(q.b, q.a, kind, 1) + removes_with(q.a, q.b, kind, 1);
      gained += removes_with(q.d, q.c, kind, 0) + removes_with(q.c, q.d, kind, 0);
    }
    return gained > 0;
  }
  void flipped(const Quadrilateral& q) {
    count(q.a, q.b, -1);
    count(q.c, q.d, 1);
  }

 private:
  /// Whether u removes v, and so many do now.
  int removes_with(VertexId u, VertexId v, Extremum kind, Index removers) const {
    return heights_.removes(u, v, kind) && removers_[place(kind)][v] == removers ? 1 : 0;
  }
  void count(VertexId u, VertexId v, int change) {
    for (const Extremum kind : kExtrema) {
      const VertexId removed = heights_.removes(u, v, kind) ? v : u;
      removers_[place(kind)][removed] += static_cast<Index>(change);
    }
  }
  static std::size_t place(Extremum kind) { return kind == Extremum::minimum ? 0 : 1; }

  const Heights& heights_;
  const Buffer<bool>& kept_;
  std::array<Buffer<Index>, 2> removers_;  // of every vertex, as a minimum and as a maximum
};

}  // namespace

void improve_by_flips(const DelaunayGraph& graph, const TriangleValues& values, Index k,
                      const Deadline& deadline, TriangleMesh& mesh) {
  const auto better = [&](const TriangleMesh&, HalfEdgeId, const Quadrilateral& q) {
    return values.better_pair(values.of(q.a, q.d, q.c), values.of(q.b, q.c, q.d),
                              values.of(q.a, q.b, q.c), values.of(q.b, q.a, q.d));
  };
  Flipper(graph, k, better, mesh).run(deadline);
}

void reduce_degrees_by_flips(const DelaunayGraph& graph, Index k, const Deadline& deadline,
                             TriangleMesh& mesh) {
  SmallerDegrees better(mesh);
  Flipper(graph, k, better, mesh).run_to_the_end(deadline);
}

void remove_extrema_by_flips(const DelaunayGraph& graph, const Heights& heights,
                             Objective objective, const Buffer<bool>& kept, Index k,
                             const Deadline& deadline, TriangleMesh& mesh) {
  const auto lowers_kept = [&](VertexId u, VertexId v) {
    return kept[heights.lower(u, v) ? v : u];
  };
  const auto to_the_last = [&](const TriangleMesh&, HalfEdgeId, const Quadrilateral& q) {
    const Extremum kind = counts_minima(objective) ? Extremum::minimum : Extremum::maximum;
    const auto further = [&](VertexId u, VertexId v) {
      return heights.removes(u, v, kind) ? u : v;
    };
    const VertexId last = further(q.c, q.d);
    return further(last, further(q.a, q.b)) == last && !lowers_kept(q.c, q.d);
  };
  if (objective != Objective::min_local_extrema) {
    Flipper(graph, k, to_the_last, mesh).run(deadline);
    return;
  }
  FewerExtrema fewer(mesh, heights, kept);
  Flipper(graph, k, fewer, mesh).run_to_the_end(deadline);
}

}  // namespace hodt
