#include "hodt/optimize/flip/flips.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "hodt/geometry/predicates.h"
#include "hodt/order/circle_counter.h"

namespace hodt {

namespace {

/// The corners of the two triangles at an inner edge ab: abc on the left, and bad.
struct Quadrilateral {
  VertexId a, b, c, d;
};

/// `Better` says of a quadrilateral whose diagonal ab could be replaced by dc whether that is
/// better.
template <class Better>
class Flipper {
 public:
  Flipper(const DelaunayGraph& graph, Index k, const Better& better, TriangleMesh& mesh)
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
    for (std::size_t steps = 0; !queue_.empty(); ++steps) {
      if (steps % 1024 == 0 && deadline.passed()) return false;
      const HalfEdgeId h = queue_.back();
      queue_.pop_back();
      queued_[h] = false;
      if (!improves(h)) continue;
      flip(h);
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

  bool improves(HalfEdgeId h) {
    if (mesh_.is_boundary(h)) return false;  // since it was queued, it came to name another edge
    const Quadrilateral q{mesh_.origin(h), mesh_.target(h), mesh_.apex(h),
                          mesh_.apex(mesh_.twin(h))};
    const Point &a = graph_.point(q.a), &b = graph_.point(q.b);
    const Point &c = graph_.point(q.c), &d = graph_.point(q.d);
    if (orient(a, d, c) <= 0 || orient(b, c, d) <= 0) return false;  // not convex
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
  const Better& better_;
  TriangleMesh& mesh_;
  CircleCounter counter_;
  std::vector<bool> queued_;
  std::vector<HalfEdgeId> queue_;
};

/// Calls f(v) for every neighbour of the origin of h, whatever is at the boundary.
template <class F>
void for_each_neighbour_around(const TriangleMesh& mesh, HalfEdgeId h, const F& f) {
  HalfEdgeId first = h;
  for (HalfEdgeId before = mesh.rotate_cw(h); before.valid() && before != h;
       before = mesh.rotate_cw(before))
    first = before;
  if (mesh.is_boundary(first)) return for_each_neighbour(mesh, first, f);
  for_each_neighbour(mesh, h, f);
}

/// What a flip changes; 0 where there is no such edge, before and after.
using FiveValues = std::array<double, 5>;

/// By the sum, or lexicographically by the sorted values, the one that counts most first.
bool better_values(const Combination& combination, FiveValues fresh, FiveValues old) {
  const Aggregate aggregate = combination.objective().aggregate;
  if (aggregate == Aggregate::sum) {
    const double sum = std::accumulate(fresh.begin(), fresh.end(), 0.0);
    const double before = std::accumulate(old.begin(), old.end(), 0.0);
    // What rounding can have made of equal sums is no gain.
    return combination.better(sum, before) &&
           std::fabs(sum - before) > 1e-13 * sum + 1e-13 * before;
  }
  for (FiveValues* values : {&fresh, &old}) {
    std::sort(values->begin(), values->end());
    if (aggregate == Aggregate::max) std::reverse(values->begin(), values->end());
  }
  for (std::size_t i = 0; i < fresh.size(); ++i)
    if (fresh[i] != old[i]) return combination.better(fresh[i], old[i]);
  return false;
}

bool better_across_edges(const EdgeValues& values, const TriangleMesh& mesh, HalfEdgeId h,
                         const Quadrilateral& q) {
  FiveValues fresh{values.of(q.d, q.c, q.a, q.b)}, old{values.of(q.a, q.b, q.c, q.d)};
  std::size_t count = 1;
  const HalfEdgeId twin = mesh.twin(h);
  // Each side, and the corner that its triangle has after the flip.
  const std::pair<HalfEdgeId, VertexId> sides[] = {{TriangleMesh::next(h), q.d},
                                                   {TriangleMesh::prev(h), q.d},
                                                   {TriangleMesh::next(twin), q.c},
                                                   {TriangleMesh::prev(twin), q.c}};
  for (const auto& [side, apex] : sides) {
    if (mesh.is_boundary(side)) continue;
    const VertexId beyond = mesh.apex(mesh.twin(side));
    fresh[count] = values.of(mesh.origin(side), mesh.target(side), apex, beyond);
    old[count++] = values.of(mesh, side);
  }
  return better_values(values, fresh, old);
}

}  // namespace

void improve_by_flips(const DelaunayGraph& graph, const TriangleValues& values, Index k,
                      const Deadline& deadline, TriangleMesh& mesh) {
  const auto better = [&](const TriangleMesh&, HalfEdgeId, const Quadrilateral& q) {
    return values.better_pair(values.of(q.a, q.d, q.c), values.of(q.b, q.c, q.d),
                              values.of(q.a, q.b, q.c), values.of(q.b, q.a, q.d));
  };
  Flipper(graph, k, better, mesh).run(deadline);
}

void improve_by_flips(const DelaunayGraph& graph, const EdgeValues& values, Index k,
                      const Deadline& deadline, TriangleMesh& mesh) {
  const auto better = [&](const TriangleMesh& m, HalfEdgeId h, const Quadrilateral& q) {
    return better_across_edges(values, m, h, q);
  };
  Flipper(graph, k, better, mesh).run(deadline);
}

void reduce_degrees_by_flips(const DelaunayGraph& graph, Index k, const Deadline& deadline,
                             TriangleMesh& mesh) {
  // Read off around a vertex: flips leave nothing to keep up to date.
  const auto degree = [](const TriangleMesh& m, HalfEdgeId h) {
    Index count = 0;
    for_each_neighbour_around(m, h, [&](VertexId) { ++count; });
    return count;
  };
  const auto better = [&](const TriangleMesh& m, HalfEdgeId h, const Quadrilateral&) {
    const HalfEdgeId twin = m.twin(h);
    const Index ends = std::max(degree(m, h), degree(m, twin));
    const Index others =
        std::max(degree(m, TriangleMesh::prev(h)), degree(m, TriangleMesh::prev(twin)));
    return others + 1 < ends;
  };
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
  const auto fewer = [&](const TriangleMesh& m, HalfEdgeId h, const Quadrilateral& q) {
    if (lowers_kept(q.c, q.d)) return false;
    const HalfEdgeId twin = m.twin(h);
    int gained = 0;
    for (const Extremum kind : kExtrema) {
      // Whether v, which the origin of `corner` loses or gains, is all that removes it.
      const auto is_sole_remover = [&](VertexId v, HalfEdgeId corner) {
        if (!heights.removes(v, m.origin(corner), kind)) return false;
        bool is_sole = true;
        for_each_neighbour_around(m, corner, [&](VertexId w) {
          is_sole &= w == v || !heights.removes(w, m.origin(corner), kind);
        });
        return is_sole;
      };
      gained -= is_sole_remover(q.b, h);
      gained -= is_sole_remover(q.a, twin);
      gained += is_sole_remover(q.d, TriangleMesh::prev(h));
      gained += is_sole_remover(q.c, TriangleMesh::prev(twin));
    }
    return gained > 0;
  };
  if (objective == Objective::min_local_extrema)
    Flipper(graph, k, fewer, mesh).run_to_the_end(deadline);
  else
    Flipper(graph, k, to_the_last, mesh).run(deadline);
}

}  // namespace hodt
