#include "hodt/optimize/value_of.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "hodt/geometry/heights.h"
#include "hodt/geometry/runs_of_points.h"
#include "hodt/mesh/degrees.h"
#include "hodt/optimize/measure/edge_measures.h"
#include "hodt/optimize/measure/measures.h"

namespace hodt {

namespace {

double extrema_of(const TriangleMesh& mesh, const Heights& heights, Extremum kind) {
  std::vector<bool> is_removed(mesh.vertex_count(), false);
  for (Index i = 0; i < mesh.halfedge_count(); ++i) {
    const VertexId u = mesh.origin(HalfEdgeId(i)), v = mesh.target(HalfEdgeId(i));
    is_removed[heights.removes(u, v, kind) ? v : u] = true;
  }
  double count = 0;
  for_each_point(heights.xy, [&](Index first, Index end) {
    const auto begin = is_removed.begin();
    count += std::find(begin + std::ptrdiff_t(first), begin + std::ptrdiff_t(end), true) ==
             begin + std::ptrdiff_t(end);
  });
  return count;
}

double largest_degree(const TriangleMesh& mesh, std::span<const Point> xy) {
  const Buffer<Index> degrees = degrees_of(mesh);
  Index largest = 0;
  for_each_point(xy, [&](Index first, Index end) {
    largest =
        std::max(largest, std::accumulate(degrees.begin() + first, degrees.begin() + end, 0u));
  });
  return largest;
}

}  // namespace

double value_of(const Objective& objective, const TriangleMesh& mesh, std::span<const Point> xy,
                std::span<const double> z) {
  if (objective.kind == Objective::measured)
    return is_of_edges(objective) ? EdgeValues(objective, xy, z).of(mesh)
                                  : TriangleValues(objective, xy, z).of(mesh);
  if (objective == Objective::none) return 0;
  if (objective == Objective::min_max_degree) return largest_degree(mesh, xy);
  const Heights heights{xy, z};
  double value = 0;
  if (objective != Objective::min_local_maxima)
    value += extrema_of(mesh, heights, Extremum::minimum);
  if (objective != Objective::min_local_minima)
    value += extrema_of(mesh, heights, Extremum::maximum);
  return value;
}

bool is_better(const Objective& objective, double value, double other) {
  return objective.kind == Objective::measured ? Aggregator(objective).better(value, other)
                                               : value < other;
}

}  // namespace hodt
