#include "hodt/hydrology/pit_depths.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <vector>

#include "../support/shapes.h"
#include <gtest/gtest.h>

#include "hodt/delaunay/delaunay.h"
#include "hodt/mesh/glued.h"

namespace hodt {
namespace {

struct Surface {
  std::vector<std::vector<Index>> neighbours;
  std::vector<bool> is_boundary;

  explicit Surface(const TriangleMesh& mesh)
      : neighbours(mesh.vertex_count()), is_boundary(mesh.vertex_count(), false) {
    for (Index h = 0; h < mesh.halfedge_count(); ++h) {
      const Index a = mesh.origin(HalfEdgeId(h)), b = mesh.target(HalfEdgeId(h));
      neighbours[a].push_back(b);
      neighbours[b].push_back(a);
      if (mesh.is_boundary(HalfEdgeId(h))) is_boundary[a] = is_boundary[b] = true;
    }
  }
};

/// For every vertex without a lower neighbour: the least height that a path to the boundary or to a
/// lower vertex has to rise to, by relaxation until nothing changes.
std::map<Index, double> expected_depths(const Surface& surface, std::span<const Point> xy,
                                        std::span<const double> z) {
  const auto lower = [&](Index a, Index b) {
    return std::tuple(z[a], xy[a].x, xy[a].y) < std::tuple(z[b], xy[b].x, xy[b].y);
  };
  std::map<Index, double> depths;
  for (Index m = 0; m < xy.size(); ++m) {
    const auto& around = surface.neighbours[m];
    if (std::any_of(around.begin(), around.end(), [&](Index v) { return lower(v, m); })) continue;
    std::vector<double> level(xy.size(), std::numeric_limits<double>::infinity());
    level[m] = z[m];
    for (bool changed = true; changed;) {
      changed = false;
      for (Index v = 0; v < xy.size(); ++v)
        for (const Index w : surface.neighbours[v])
          if (const double through = std::max(level[v], z[w]); through < level[w]) {
            level[w] = through;
            changed = true;
          }
    }
    double spill = std::numeric_limits<double>::infinity();
    for (Index v = 0; v < xy.size(); ++v)
      if (surface.is_boundary[v] || lower(v, m)) spill = std::min(spill, level[v]);
    depths[m] = spill - z[m];
  }
  return depths;
}

TEST(PitDepths, equal_the_least_rise_of_any_path) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const support::Points points =
        seed % 3 == 0 ? support::lattice(12, 12) : support::uniform(150, seed);
    const double step = seed % 2 ? 0.25 : 1e-9;  // many equal heights, or none
    const Delaunay d = delaunay({points, support::rough_heights(points, step, seed)});
    std::map<Index, double> found;
    for (const Pit& pit : pit_depths(d.mesh, d.vertices.xy, d.vertices.z))
      EXPECT_TRUE(found.emplace(pit.bottom, pit.depth).second);
    EXPECT_EQ(found, expected_depths(Surface(d.mesh), d.vertices.xy, d.vertices.z)) << seed;
  }
}

TEST(PitDepths, water_ends_in_a_minimum) {
  const support::Points points = support::uniform(300, 5);
  const Delaunay d = delaunay({points, support::rough_heights(points, 1e-9, 6)});
  const Buffer<HalfEdgeId> outgoing = outgoing_halfedges(d.mesh);
  std::vector<bool> is_bottom(d.vertices.size(), false);
  for (const Pit& pit : pit_depths(d.mesh, d.vertices.xy, d.vertices.z))
    is_bottom[pit.bottom] = true;
  for (Index v = 0; v < d.vertices.size(); ++v) {
    const VertexId end = drains_to(d.mesh, outgoing, d.vertices.xy, d.vertices.z, VertexId(v));
    EXPECT_TRUE(is_bottom[end]);
    EXPECT_LE(d.vertices.z[end], d.vertices.z[v]);
    if (is_bottom[v]) {
      EXPECT_EQ(end, VertexId(v));
    }
  }
}

TEST(PitDepths, of_vertices_without_a_triangle_there_are_none) {
  const std::vector<std::array<Index, 3>> triangles = {{1, 2, 3}};
  const std::vector<Point> xy = {{5, 5}, {0, 0}, {1, 0}, {0, 1}, {7, 7}};
  const std::vector<double> z = {-1, 1, 2, 3, 4};
  const std::vector<Pit> pits = pit_depths(glued(xy.size(), triangles), xy, z);
  ASSERT_EQ(pits.size(), 1u);
  EXPECT_EQ(Index(pits[0].bottom), 1u);
  EXPECT_EQ(pits[0].depth, 0);
  EXPECT_TRUE(pit_depths(glued(xy.size(), {}), xy, z).empty());
  EXPECT_TRUE(pit_depths(glued(0, {}), {}, {}).empty());
}

}  // namespace
}  // namespace hodt
