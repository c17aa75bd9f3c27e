#include "hodt/optimize/value_of.h"

#include <algorithm>
#include <vector>

#include "hodt/geometry/heights.h"
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
  return static_cast<double>(std::count(is_removed.begin(), is_removed.end(), false));
}

}  // namespace

double value_of(const Objective& objective, const TriangleMesh& mesh, std::span<const Point> xy,
                std::span<const double> z) {
  if (objective.kind == Objective::measured)
    return is_of_edges(objective) ? EdgeValues(objective, xy, z).of(mesh)
                                  : TriangleValues(objective, xy, z).of(mesh);
  if (objective == Objective::none) return 0;
  if (objective == Objective::min_max_degree) {
    const Buffer<Index> degrees = degrees_of(mesh);
    return *std::max_element(degrees.begin(), degrees.end());
  }
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
