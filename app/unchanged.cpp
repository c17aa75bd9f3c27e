#include "app/unchanged.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "hodt/optimize/measure/measures.h"

namespace hodt::app {

namespace {

/// As the tables show it: 0.00 %.
bool is_unchanged(const ComparisonRow& row) {
  const std::optional<double> change = row.change();
  return change && std::fabs(*change) < 0.005;
}

bool is_unchanged(const ObjectiveComparison& objective) {
  const auto& rows = objective.rows;
  return std::any_of(rows.begin(), rows.end(), [](const auto& row) { return row.k > 0; }) &&
         std::all_of(rows.begin(), rows.end(), [](const auto& row) { return is_unchanged(row); });
}

std::vector<bool> vertices_on_outline(const TriangleMesh& mesh) {
  std::vector<bool> on_outline(mesh.vertex_count(), false);
  for (Index h = 0; h < mesh.halfedge_count(); ++h)
    if (mesh.is_boundary(HalfEdgeId(h)))
      on_outline[mesh.origin(HalfEdgeId(h))] = on_outline[mesh.target(HalfEdgeId(h))] = true;
  return on_outline;
}

/// Whether a triangle with the largest or smallest value, whichever the objective asks for, has a
/// corner on the outline.
bool is_decided_on_outline(const Objective& objective, const Delaunay& delaunay) {
  const VertexSet& vertices = delaunay.vertices;
  const TriangleMesh& mesh = delaunay.mesh;
  if (is_of_edges(objective)) return false;
  const TriangleValues values(objective, vertices.xy, vertices.z);
  const std::vector<bool> at_outline = vertices_on_outline(mesh);
  const double sign = objective.aggregate == Aggregate::max ? 1 : -1;
  double extreme = 0;
  bool on_outline = false;
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.corners(TriangleId(t));
    const double value = sign * values.of(a, b, c);
    if (t > 0 && value < extreme) continue;
    on_outline = at_outline[a] || at_outline[b] || at_outline[c] ||
                 (t > 0 && value == extreme && on_outline);
    extreme = value;
  }
  return on_outline;
}

}  // namespace

std::string why_unchanged(const ObjectiveComparison& comparison, const Delaunay& delaunay) {
  const Objective& objective = comparison.objective();
  if (comparison.objectives.size() > 1) return {};  // others can change
  if (objective.kind != Objective::measured || objective.aggregate == Aggregate::sum ||
      !is_unchanged(comparison))
    return {};
  const bool proved = std::all_of(comparison.rows.begin(), comparison.rows.end(),
                                  [](const auto& row) { return row.value.optimal; });
  const std::string place =
      is_decided_on_outline(objective, delaunay)
          ? "A triangle at the outline decides it, where there is least choice"
      : is_of_edges(objective) ? "An edge decides it"
                               : "A single triangle decides it";
  return place + (proved ? ", and no triangulation of these orders does noticeably better."
                         : ", and nothing noticeably better was found.");
}

}  // namespace hodt::app
