#include "hodt/optimize/flip/flips.h"

#include <algorithm>
#include <vector>

#include "hodt/mesh/degrees.h"
#include "hodt/optimize/flip/flipper.h"
#include "hodt/optimize/flip/remover_counts.h"

namespace hodt {

namespace {

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

/// A flip is better that leaves fewer minima and maxima.
class FewerExtrema {
 public:
  FewerExtrema(const TriangleMesh& mesh, const Heights& heights, const Buffer<bool>& kept)
      : heights_(heights), kept_(kept) {
    for (const Extremum kind : kExtrema) removers_.emplace_back(mesh, heights, kind);
  }
  bool operator()(const TriangleMesh&, HalfEdgeId, const Quadrilateral& q) const {
    if (kept_[heights_.lower(q.c, q.d) ? q.d : q.c]) return false;
    int more = 0;  // the two diagonals have no end in common
    for (const RemoverCounts& counts : removers_)
      more += counts.effect(q.a, q.b, -1) + counts.effect(q.c, q.d, 1);
    return more < 0;
  }
  void flipped(const Quadrilateral& q) {
    for (RemoverCounts& counts : removers_) {
      counts.change(q.a, q.b, -1);
      counts.change(q.c, q.d, 1);
    }
  }

 private:
  const Heights& heights_;
  const Buffer<bool>& kept_;
  std::vector<RemoverCounts> removers_;
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
