// What must hold of every solution, whatever the algorithm.
#pragma once

#include <algorithm>
#include <cstddef>
#include <set>
#include <span>
#include <string>
#include <tuple>

#include "../support/connectivity_problem.h"
#include "../support/convert.h"
#include "../support/shapes.h"
#include "../support/triangulation_problems.h"

#include "hodt/optimize/extrema/extrema_solution.h"
#include "hodt/optimize/objective.h"
#include "hodt/order/delaunay_graph.h"

namespace hodt {

/// Points with heights, triangulated.
struct Terrain {
  explicit Terrain(const PointSet& points) : delaunay(hodt::delaunay(points)), graph(delaunay) {}
  Terrain(const support::Points& points, const std::vector<double>& z)
      : Terrain(PointSet{points, z}) {}

  std::span<const double> z() const { return delaunay.vertices.z; }
  std::string source() const { return support::to_source(delaunay.vertices.xy, z()); }

  Delaunay delaunay;
  DelaunayGraph graph;
};

/// The objective's value, by the definition: every edge's ends are looked at.
inline std::size_t count_extrema(const Terrain& terrain, const TriangleMesh& mesh,
                                 Objective objective) {
  const auto key = [&](Index v) {
    const Point& p = terrain.graph.xy[v];
    return std::tuple(terrain.z()[v], p.x, p.y);
  };
  std::vector<bool> has_lower(mesh.vertex_count(), false), has_higher(mesh.vertex_count(), false);
  for (Index t = 0; t < mesh.triangle_count(); ++t)
    for (const Index u : mesh.corners(TriangleId(t)))
      for (const Index v : mesh.corners(TriangleId(t)))
        if (key(u) < key(v)) has_higher[u] = has_lower[v] = true;
  std::size_t count = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (counts_minima(objective)) count += !has_lower[v];
    if (counts_maxima(objective)) count += !has_higher[v];
  }
  return count;
}

/// Empty if the mesh is a triangulation of order k and its numbers are true.
inline std::string problem(const Terrain& terrain, const ExtremaSolution& solution, Index k,
                           Objective objective) {
  const TriangleMesh mesh = solution.change.applied_to(terrain.delaunay.mesh);
  if (auto p = connectivity_problem(mesh, Surface::disk); !p.empty()) return p;
  if (auto p = embedding_problem(terrain.graph.xy, mesh); !p.empty()) return p;
  if (auto p = order_problem(terrain.graph, mesh, k); !p.empty()) return p;
  if (solution.delaunay != count_extrema(terrain, terrain.delaunay.mesh, objective))
    return "delaunay is not a recount";
  if (solution.result != count_extrema(terrain, mesh, objective)) return "result is not a recount";
  if (solution.result > solution.delaunay) return "worse than Delaunay";
  if (solution.bound > solution.result) return "the bound is above the result";
  return "";
}

inline bool same(const ExtremaSolution& a, const ExtremaSolution& b) {
  const auto same_mesh = [&] {
    return !a.change.mesh() == !b.change.mesh() &&
           (!a.change.mesh() || support::same_arrays(*a.change.mesh(), *b.change.mesh()));
  };
  return std::ranges::equal(a.change.flips(), b.change.flips()) && same_mesh() &&
         a.delaunay == b.delaunay && a.result == b.result && a.bound == b.bound;
}

}  // namespace hodt
