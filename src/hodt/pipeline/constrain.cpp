#include "hodt/pipeline/constrain.h"

#include <array>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "hodt/order/constrained/domain.h"

namespace hodt {

namespace {

std::vector<std::array<VertexId, 2>> vertices_of(std::span<const Constraints::Edge> edges,
                                                 const PointSet& points,
                                                 const Buffer<VertexId>& vertex_of) {
  std::vector<std::array<VertexId, 2>> ends;
  ends.reserve(edges.size());
  for (const auto& [u, v] : edges) {
    for (const Index row : {u, v})
      if (row >= points.size())
        throw ParameterError(
            fmt::format("a constraint ends at row {}, counted from 0, but there are {} points", row,
                        points.size()));
    ends.push_back({vertex_of[u], vertex_of[v]});
  }
  return ends;
}

[[noreturn]] void throw_crossing(const PointSet& points, std::span<const Constraints::Edge> edges,
                                 std::vector<CrossingEdges> crossings) {
  const auto [i, j] = crossings.front();
  const auto& [a, b] = edges[i];
  const auto& [c, d] = edges[j];
  const Point place = crossing_place(points.xy[a], points.xy[b], points.xy[c], points.xy[d]);
  throw CrossingError(
      fmt::format("the constraints between rows {} and {} and between rows {} and {}, counted "
                  "from 0, cross near x {}, y {}; they need a point there",
                  a, b, c, d, place.x, place.y),
      std::move(crossings));
}

/// Edges that are walls.
std::size_t count_walls(const Delaunay& delaunay) {
  std::size_t count = 0;
  for (Index i = 0; i < delaunay.walls.size(); ++i) {
    const HalfEdgeId h(i);
    if (delaunay.walls[h]) count += delaunay.mesh.is_boundary(h) || h < delaunay.mesh.twin(h);
  }
  return count;
}

}  // namespace

Point crossing_place(const Point& a, const Point& b, const Point& c, const Point& d) {
  // In extended precision, from an end of the first segment.
  using Real = long double;
  const Real abx = Real(b.x) - a.x, aby = Real(b.y) - a.y;
  const Real cdx = Real(d.x) - c.x, cdy = Real(d.y) - c.y;
  const Real acx = Real(c.x) - a.x, acy = Real(c.y) - a.y;
  const Real part = (acx * cdy - acy * cdx) / (abx * cdy - aby * cdx);
  const Real bounded = part >= 0 && part <= 1 ? part : Real(0.5);
  return {static_cast<double>(a.x + bounded * abx), static_cast<double>(a.y + bounded * aby)};
}

ConstraintReport constrain(Delaunay& delaunay, const PointSet& points,
                           const Constraints& constraints) {
  ConstraintReport report;
  if (constraints.empty()) return report;
  std::vector<Constraints::Edge> edges = constraints.edges;
  edges.insert(edges.end(), constraints.boundary.begin(), constraints.boundary.end());
  const Buffer<VertexId> vertex_of = vertices_of_rows(points, delaunay.vertices);
  const std::vector<std::array<VertexId, 2>> ends = vertices_of(edges, points, vertex_of);
  report.edges = edges.size();
  if (std::vector<CrossingEdges> crossings = insert_walls(delaunay, ends); !crossings.empty())
    throw_crossing(points, edges, std::move(crossings));
  const std::size_t walls = count_walls(delaunay);
  const Restriction restriction = restrict_to_domain(
      delaunay, std::span(ends).subspan(constraints.edges.size()), constraints.max_edge);
  report.triangles_outside = restriction.outside;
  report.triangles_too_long = restriction.too_long;
  report.unused_points = restriction.unused;
  report.walls = count_walls(delaunay);
  report.walls_left_out = walls - report.walls;
  return report;
}

}  // namespace hodt
