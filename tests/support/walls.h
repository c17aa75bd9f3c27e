// Random walls, and whether a triangulation is the constrained Delaunay triangulation of them.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "../oracle/families.h"
#include "connectivity_problem.h"
#include "triangulation_problems.h"
#include <gtest/gtest.h>

#include "hodt/delaunay/delaunay.h"
#include "hodt/geometry/predicates.h"

namespace support::walls {

using namespace hodt;

using Edges = std::vector<std::array<VertexId, 2>>;

inline bool is_between(const Point& a, const Point& b, const Point& p) {
  const bool first = lexicographically_less(a, p) && lexicographically_less(p, b);
  const bool second = lexicographically_less(b, p) && lexicographically_less(p, a);
  return orient(a, b, p) == 0 && (first || second);
}

/// The edge as the pieces between the vertices on it.
inline std::set<std::pair<Index, Index>> pieces_of(std::span<const Point> xy, const Edges& edges) {
  std::set<std::pair<Index, Index>> pieces;
  for (const auto& [u, v] : edges) {
    if (u == v) continue;
    std::vector<Index> on{u, v};
    for (Index p = 0; p < xy.size(); ++p)
      if (is_between(xy[u], xy[v], xy[p])) on.push_back(p);
    std::sort(on.begin(), on.end(),
              [&](Index p, Index q) { return lexicographically_less(xy[p], xy[q]); });
    for (std::size_t i = 1; i < on.size(); ++i) pieces.insert(std::minmax(on[i - 1], on[i]));
  }
  return pieces;
}

/// Where they meet is no vertex.
inline bool is_crossed(std::span<const Point> xy, const std::array<VertexId, 2>& e,
                       const std::array<VertexId, 2>& f) {
  const Point &a = xy[e[0]], &b = xy[e[1]], &p = xy[f[0]], &q = xy[f[1]];
  return orient(a, b, p) * orient(a, b, q) < 0 && orient(p, q, a) * orient(p, q, b) < 0 &&
         std::none_of(xy.begin(), xy.end(),
                      [&](const Point& v) { return is_between(a, b, v) && is_between(p, q, v); });
}

/// Takes of random edges those that cross none that was taken before.
inline Edges random_edges(std::span<const Point> xy, std::size_t count, double reach,
                          std::uint64_t seed) {
  families::Random random(seed);
  const auto n = static_cast<int>(xy.size());
  Edges edges;
  for (std::size_t attempt = 0; attempt < 20 * count && edges.size() < count; ++attempt) {
    // Often near each other along the curve.
    const int a = random.integer(0, n - 1), most = attempt % 2 == 0 ? 200 : n;
    const int b = (a + random.integer(0, most)) % n;
    const std::array<VertexId, 2> edge{VertexId{Index(a)}, VertexId{Index(b)}};
    const double dx = xy[edge[0]].x - xy[edge[1]].x, dy = xy[edge[0]].y - xy[edge[1]].y;
    if (dx * dx + dy * dy > reach * reach) continue;
    if (std::none_of(edges.begin(), edges.end(),
                     [&](const auto& other) { return is_crossed(xy, edge, other); }))
      edges.push_back(edge);
  }
  return edges;
}

/// A triangulation with the pieces of the edges as walls, whose other edges are Delaunay, each by
/// itself: that is the constrained Delaunay triangulation.
inline void expect_constrained_delaunay(const Delaunay& d, const Edges& edges) {
  const std::span<const Point> xy = d.vertices.xy;
  ASSERT_EQ(connectivity_problem(d.mesh), "");
  ASSERT_EQ(embedding_problem(xy, d.mesh), "");
  std::set<std::pair<Index, Index>> walls;
  for (Index i = 0; i < d.mesh.halfedge_count(); ++i) {
    const HalfEdgeId h(i), twin = d.mesh.twin(h);
    if (d.walls[h]) walls.insert(std::minmax<Index>(d.mesh.origin(h), d.mesh.target(h)));
    if (!twin.valid()) continue;
    ASSERT_EQ(d.walls[h], d.walls[twin]);
    if (d.walls[h]) continue;
    ASSERT_FALSE(in_circle(xy[d.mesh.origin(h)], xy[d.mesh.target(h)], xy[d.mesh.apex(h)],
                           xy[d.mesh.apex(twin)]));
  }
  ASSERT_EQ(walls, pieces_of(xy, edges));
}

}  // namespace support::walls
