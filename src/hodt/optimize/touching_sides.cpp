#include "hodt/optimize/touching_sides.h"

#include <algorithm>

#include "hodt/geometry/heights.h"
#include "hodt/geometry/runs_of_points.h"
#include "hodt/optimize/value_of.h"
#include "hodt/order/fixed_edges.h"

namespace hodt {

namespace {

constexpr Index kMostOrder = 32;  // fixed edges of larger orders are few, and take long to find

/// What every triangulation of the order has around vertices.
class Fixed {
 public:
  Fixed(const DelaunayGraph& graph, Index order, const Deadline& deadline) : graph_(graph) {
    if (order > kMostOrder) return;
    try {
      fixed_ = fixed_edges(graph, order, deadline);
    } catch (const TimeIsUp&) {
      fixed_ = {};  // the boundary and walls will do
    }
  }

  template <class F>
  void for_each_neighbour(VertexId v, const F& f) const {
    for_each_outgoing(graph_.mesh, graph_.outgoing[v], [&](HalfEdgeId h) {
      if (is_fixed(h)) f(graph_.mesh.target(h));
      if (graph_.mesh.is_boundary(TriangleMesh::prev(h))) f(graph_.mesh.apex(h));
    });
  }

 private:
  bool is_fixed(HalfEdgeId h) const {
    return graph_.mesh.is_boundary(h) || graph_.is_wall(h) || (fixed_.size() > 0 && fixed_[h]);
  }

  const DelaunayGraph& graph_;
  Buffer<bool> fixed_;  // of half-edges, or none
};

/// Calls f(first, end) for the vertices at every point that several sides meet in.
template <class F>
void for_each_touch(const DelaunayGraph& graph, const F& f) {
  for_each_point(graph.xy, [&](Index first, Index end) {
    if (end - first > 1) f(first, end);
  });
}

/// By how many a count of extrema by sides can exceed that by points. Both are the same where all
/// sides agree; a side with a neighbour in every triangulation that removes it is never one.
Index most_in_excess(const DelaunayGraph& graph, const Heights& heights, const Fixed& fixed,
                     Extremum kind) {
  Index excess = 0;
  for_each_touch(graph, [&](Index first, Index end) {
    Index possible = 0;
    for (VertexId v(first); v < end; v = VertexId(v + 1)) {
      bool is_removed = false;
      fixed.for_each_neighbour(v, [&](VertexId w) { is_removed |= heights.removes(w, v, kind); });
      possible += Index{!is_removed};
    }
    excess += possible - Index{possible == end - first};
  });
  return excess;
}

/// The most edges that any point has in every triangulation.
Index least_degree(const DelaunayGraph& graph, const Fixed& fixed) {
  Index most = 0;
  for_each_touch(graph, [&](Index first, Index end) {
    Index degree = 0;
    for (VertexId v(first); v < end; v = VertexId(v + 1))
      fixed.for_each_neighbour(v, [&](VertexId) { ++degree; });
    most = std::max(most, degree);
  });
  return most;
}

double bound_for_points(const DelaunayGraph& graph, std::span<const double> z, Index order,
                        const Objective& objective, const Deadline& deadline, double of_sides) {
  const Fixed fixed(graph, order, deadline);
  if (objective == Objective::min_max_degree)
    return std::max<double>(of_sides, least_degree(graph, fixed));
  const Heights heights{graph.xy, z};
  if (objective != Objective::min_local_maxima)
    of_sides -= most_in_excess(graph, heights, fixed, Extremum::minimum);
  if (objective != Objective::min_local_minima)
    of_sides -= most_in_excess(graph, heights, fixed, Extremum::maximum);
  return std::max(of_sides, 0.0);
}

}  // namespace

bool touches_itself(const DelaunayGraph& graph) {
  return std::adjacent_find(graph.xy.begin(), graph.xy.end()) != graph.xy.end();
}

bool counts_vertices(const Objective& objective) {
  return objective.kind != Objective::measured && objective != Objective::none;
}

void count_points(const DelaunayGraph& graph, std::span<const double> z, Index order,
                  const Objective& objective, const Deadline& deadline, Optimum& optimum) {
  Value& value = optimum.value;
  value.delaunay = value_of(objective, graph.mesh, graph.xy, z);
  value.result = value_of(objective, optimum.change.applied_to(graph.mesh), graph.xy, z);
  if (value.delaunay < value.result) {
    optimum.change = {};
    value.result = value.delaunay;
  }
  value.bound = bound_for_points(graph, z, order, objective, deadline, value.bound);
  value.optimal = value.result == value.bound;
}

}  // namespace hodt
