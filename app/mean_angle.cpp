#include "app/mean_angle.h"

namespace hodt::app {

std::optional<double> angles_in_sum(const Report& report) {
  const Objective& objective = report.objective;
  if (objective.kind != Objective::measured || objective.aggregate != Aggregate::sum)
    return std::nullopt;
  const auto is = [&](Measure measure) { return objective.measure == measure; };
  if (is(TriangleMeasure(TriangleMeasure::angle)) ||
      is(TriangleMeasure(TriangleMeasure::small_angle)))
    return double(report.triangles);
  if (!is(EdgeMeasure(EdgeMeasure::abn))) return std::nullopt;
  // Euler: n vertices and t triangles make n + t - 1 edges, of which 2n - 2 - t are on the
  // boundary.
  const std::size_t vertices = report.points - report.duplicates;
  const std::size_t inner_edges = 2 * report.triangles + 1 - vertices;
  return inner_edges > 0 ? std::optional(double(inner_edges)) : std::nullopt;
}

}  // namespace hodt::app
