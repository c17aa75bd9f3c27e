#include "hodt/hydrology/pit_water.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "../support/convert.h"
#include "../support/shapes.h"
#include <gtest/gtest.h>

#include "hodt/delaunay/delaunay.h"
#include "hodt/hydrology/pit_depths.h"
#include "hodt/mesh/glued.h"

namespace hodt {
namespace {

using Triangles = std::vector<std::array<Index, 3>>;

struct Terrain {
  std::vector<Point> xy;
  std::vector<double> z;
  Triangles triangles;

  TriangleMesh mesh() const { return support::make_mesh(xy.size(), triangles); }
  double volume() const { return water_volume(mesh(), xy, z); }
};

Terrain rough_terrain(std::uint64_t seed) {
  const support::Points points =
      seed % 3 == 0 ? support::lattice(9, 9) : support::uniform(90, seed);
  const double step = seed % 2 ? 5 : 1e-9;  // many equal heights, or none
  const Delaunay d = delaunay({points, support::rough_heights(points, step, seed)});
  Terrain terrain{
      {d.vertices.xy.begin(), d.vertices.xy.end()}, {d.vertices.z.begin(), d.vertices.z.end()}, {}};
  for (Index t = 0; t < d.mesh.triangle_count(); ++t) {
    const auto [a, b, c] = d.mesh.corners(TriangleId(t));
    terrain.triangles.push_back({a, b, c});
  }
  return terrain;
}

/// The definition: the lowest level at which the vertices that are not above it connect v to a
/// side with one triangle only.
std::vector<double> expected_levels(const Terrain& terrain) {
  const std::size_t n = terrain.xy.size();
  std::multiset<std::pair<Index, Index>> sides;
  for (const auto& t : terrain.triangles)
    for (int i = 0; i < 3; ++i) sides.insert(std::minmax({t[i], t[(i + 1) % 3]}));
  std::vector<double> candidates = terrain.z;
  std::sort(candidates.begin(), candidates.end());
  std::vector<double> levels(n, std::numeric_limits<double>::infinity());
  for (const double level : candidates) {
    std::vector<bool> drains(n, false);
    for (const auto& [u, v] : sides)
      if (sides.count({u, v}) == 1) {
        drains[u] = drains[u] || terrain.z[u] <= level;
        drains[v] = drains[v] || terrain.z[v] <= level;
      }
    for (bool changed = true; changed;) {
      changed = false;
      for (const auto& [u, v] : sides) {
        if (drains[u] == drains[v] || std::max(terrain.z[u], terrain.z[v]) > level) continue;
        drains[u] = drains[v] = changed = true;
      }
    }
    for (std::size_t v = 0; v < n; ++v)
      if (drains[v]) levels[v] = std::min(levels[v], level);
  }
  return levels;
}

/// By the midpoint rule on `parts` x `parts` small triangles in each. From a point water can run
/// to any corner of its triangle, over the higher of the two, and on from there.
double expected_volume(const Terrain& terrain, int parts) {
  const std::vector<double> levels = expected_levels(terrain);
  double volume = 0;
  for (const auto& [a, b, c] : terrain.triangles) {
    const Point &p = terrain.xy[a], &q = terrain.xy[b], &r = terrain.xy[c];
    const double area = ((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)) / 2;
    const auto depth = [&](double s, double t) {
      const double height =
          terrain.z[a] + s * (terrain.z[b] - terrain.z[a]) + t * (terrain.z[c] - terrain.z[a]);
      return std::max(height, std::min({levels[a], levels[b], levels[c]})) - height;
    };
    double sum = 0;
    for (int i = 0; i < parts; ++i)
      for (int j = 0; i + j < parts; ++j) {
        sum += depth((i + 1 / 3.) / parts, (j + 1 / 3.) / parts);
        if (i + j < parts - 1) sum += depth((i + 2 / 3.) / parts, (j + 2 / 3.) / parts);
      }
    volume += area * sum / (parts * parts);
  }
  return volume;
}

/// A square of side 2 at the given height, with a centre.
Terrain bowl(double rim, double centre) {
  return {{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}},
          {rim, rim, rim, rim, centre},
          {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
}

TEST(PitWater, levels_are_where_water_first_finds_the_boundary) {
  std::size_t wet = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const Terrain terrain = rough_terrain(seed);
    const Buffer<double> found = water_levels(terrain.mesh(), terrain.z);
    const std::vector<double> expected = expected_levels(terrain);
    EXPECT_TRUE(std::equal(found.begin(), found.end(), expected.begin(), expected.end())) << seed;
    for (std::size_t v = 0; v < expected.size(); ++v) wet += expected[v] > terrain.z[v];
  }
  EXPECT_GT(wet, 100u);
}

TEST(PitWater, volume_equals_that_of_small_columns) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const Terrain terrain = rough_terrain(seed);
    const double expected = expected_volume(terrain, 200);
    EXPECT_GT(expected, 0) << seed;
    EXPECT_NEAR(terrain.volume(), expected, 1e-3 * expected) << seed;
  }
}

TEST(PitWater, bowls_hold_what_they_should) {
  EXPECT_DOUBLE_EQ(bowl(5, 2).volume(), 4. * 3 / 3);  // a pyramid upside down
  EXPECT_EQ(bowl(5, 5).volume(), 0);
  EXPECT_EQ(bowl(5, 7).volume(), 0);
  // Flows over at a corner 1 high: the rest of the rim stays above the water.
  Terrain open = bowl(3, 0);
  open.z[1] = 1;
  // Two triangles with depths 1, 0, -2: the share 1/3 of each is wet; two with 1, -2, -2: 1/9.
  EXPECT_DOUBLE_EQ(open.volume(), 2 * (1 / 3.) / 3 + 2 * (1 / 9.) / 3);
  open.z[1] = -1;
  EXPECT_EQ(open.volume(), 0);
}

/// A strip along x with a trough of two vertices; the rim is lower at one corner.
Terrain trough(double rim, double outlet, double z4, double z5) {
  return {{{0, 0}, {3, 0}, {3, 2}, {0, 2}, {1, 1}, {2, 1}},
          {rim, rim, outlet, rim, z4, z5},
          {{0, 1, 4}, {1, 5, 4}, {1, 2, 5}, {2, 3, 5}, {3, 4, 5}, {3, 0, 4}}};
}

TEST(PitWater, wedges_with_two_wet_corners) {
  const Terrain terrain = trough(4, 2, 0, 1);
  EXPECT_NEAR(terrain.volume(), expected_volume(terrain, 1000), 1e-5);
  EXPECT_GT(terrain.volume(), 0.5);
}

TEST(PitWater, thin_films_do_not_cancel) {
  // Wet share f of the sides to the rim. Two corners wet: half an area twice, f * f each; one wet,
  // the outlet at the shore: 2.5 areas, f * f / 3 each; the rest is f * f * f.
  const double f = 1e-9;
  EXPECT_NEAR(trough(1, f, 0, 0).volume() / (f * f * (1 + 2.5 / 3)), 1, 1e-8);
}

TEST(PitWater, pits_in_a_pit_are_counted_once) {
  // A wide bowl of depth 6 with a ridge 4 high through its middle, lower than the rim.
  std::vector<Point> xy;
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 7; ++x) xy.push_back({double(x), double(y)});
  std::vector<double> z;
  for (const Point& p : xy) {
    const bool rim = p.x == 0 || p.x == 6 || p.y == 0 || p.y == 4;
    z.push_back(rim ? 6 : p.x == 3 ? 4 : p.x < 3 ? 0 : 1);
  }
  const Delaunay d = delaunay({xy, z});
  const PitTotals totals = pit_totals(d.mesh, d.vertices.xy, d.vertices.z);
  EXPECT_EQ(totals.count, 2u);
  EXPECT_EQ(totals.deepest, 6);
  EXPECT_EQ(totals.depth, 6 + 3);  // the other flows over the ridge
  const Buffer<double> levels = water_levels(d.mesh, d.vertices.z);
  for (const double level : levels) EXPECT_EQ(level, 6);
}

TEST(PitWater, a_finer_mesh_of_the_same_surface_holds_the_same) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Terrain terrain = rough_terrain(seed);
    for (double& z : terrain.z) z = 3 * std::round(z);  // so that a third of a sum is exact
    Terrain finer{terrain.xy, terrain.z, {}};
    for (const auto& [a, b, c] : terrain.triangles) {
      const auto centre = static_cast<Index>(finer.xy.size());
      finer.xy.push_back({(terrain.xy[a].x + terrain.xy[b].x + terrain.xy[c].x) / 3,
                          (terrain.xy[a].y + terrain.xy[b].y + terrain.xy[c].y) / 3});
      finer.z.push_back((terrain.z[a] + terrain.z[b] + terrain.z[c]) / 3);
      for (const auto& side : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
        finer.triangles.push_back({side.first, side.second, centre});
    }
    const double volume = terrain.volume();
    EXPECT_GT(volume, 0);
    EXPECT_NEAR(finer.volume(), volume, 1e-10 * volume) << seed;
  }
}

TEST(PitWater, totals_are_those_of_the_pits_inside) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Terrain terrain = rough_terrain(seed);
    const TriangleMesh mesh = terrain.mesh();
    std::set<Index> boundary;
    for (Index h = 0; h < mesh.halfedge_count(); ++h)
      if (mesh.is_boundary(HalfEdgeId(h)))
        boundary.insert({mesh.origin(HalfEdgeId(h)), mesh.target(HalfEdgeId(h))});
    std::vector<double> depths;
    for (const Pit& pit : pit_depths(mesh, terrain.xy, terrain.z))
      if (!boundary.contains(pit.bottom)) depths.push_back(pit.depth);
    const PitTotals totals = pit_totals(mesh, terrain.xy, terrain.z);
    ASSERT_FALSE(depths.empty());
    EXPECT_EQ(totals.count, depths.size());
    EXPECT_EQ(totals.deepest, *std::max_element(depths.begin(), depths.end()));
    EXPECT_NEAR(totals.depth, std::accumulate(depths.begin(), depths.end(), 0.), 1e-9);
    EXPECT_EQ(totals.volume, terrain.volume());
  }
}

/// By definition: the water over all triangles, with everything dry but what the level connects to
/// the bottom.
double expected_volume(const Terrain& terrain, const Pit& pit) {
  std::vector<bool> is_wet(terrain.xy.size(), false);
  is_wet[pit.bottom] = pit.depth > 0;
  for (bool grows = true; grows;) {
    grows = false;
    for (const auto& t : terrain.triangles)
      for (const Index u : t)
        for (const Index v : t)
          if (is_wet[u] && !is_wet[v] && terrain.z[v] < pit.level) is_wet[v] = grows = true;
  }
  double volume = 0;
  for (const auto& t : terrain.triangles) {
    if (!is_wet[t[0]] && !is_wet[t[1]] && !is_wet[t[2]]) continue;
    // The midpoint rule on small pieces.
    constexpr int pieces = 400;
    const auto at = [&](auto of, double a, double b) {
      return of(t[0]) * (1 - a - b) + of(t[1]) * a + of(t[2]) * b;
    };
    const auto x = [&](Index v) { return terrain.xy[v].x; };
    const auto y = [&](Index v) { return terrain.xy[v].y; };
    const auto z = [&](Index v) { return terrain.z[v]; };
    const double area =
        ((x(t[1]) - x(t[0])) * (y(t[2]) - y(t[0])) - (x(t[2]) - x(t[0])) * (y(t[1]) - y(t[0]))) / 2;
    double depths = 0;
    for (int i = 0; i < pieces; ++i)
      for (int j = 0; i + j < pieces; ++j)
        for (const double part : {1.0 / 3, 2.0 / 3}) {
          if (part > 0.5 && i + j + 1 == pieces) continue;
          depths += std::max(0.0, pit.level - at(z, (i + part) / pieces, (j + part) / pieces));
        }
    volume += std::fabs(area) * depths / (pieces * pieces);
  }
  return volume;
}

TEST(PitVolumes, AreThoseOfTheLakesByDefinition) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const Terrain terrain = rough_terrain(seed);
    const TriangleMesh mesh = terrain.mesh();
    const std::vector<Pit> pits = pit_depths(mesh, terrain.xy, terrain.z);
    const std::vector<double> volumes = pit_volumes(mesh, terrain.xy, terrain.z, pits);
    ASSERT_EQ(volumes.size(), pits.size());
    for (std::size_t i = 0; i < pits.size(); ++i) {
      EXPECT_DOUBLE_EQ(pits[i].level - terrain.z[pits[i].bottom], pits[i].depth);
      const double expected = expected_volume(terrain, pits[i]);
      EXPECT_NEAR(volumes[i], expected, 2e-3 * expected + 1e-12) << seed << ' ' << i;
      if (pits[i].depth == 0) {
        EXPECT_EQ(volumes[i], 0);
      }
    }
  }
}

/// The same from the definition without integrals: the part of each triangle that is under water is
/// cut out, and cut into triangles again.
double clipped_volume(const Terrain& terrain, const Pit& pit) {
  if (pit.depth <= 0) return 0;
  std::vector<std::vector<Index>> around(terrain.xy.size());
  for (const auto& t : terrain.triangles)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) around[t[i]].push_back(t[j]);
  std::vector<Index> wet = {pit.bottom};
  std::vector<bool> is_wet(terrain.xy.size(), false);
  is_wet[pit.bottom] = true;
  for (std::size_t i = 0; i < wet.size(); ++i)
    for (const Index v : around[wet[i]])
      if (!is_wet[v] && terrain.z[v] < pit.level) is_wet[v] = true, wet.push_back(v);
  struct Corner {
    long double x, y, depth;
  };
  long double volume = 0;
  for (const auto& t : terrain.triangles) {
    std::vector<Corner> part;
    for (int i = 0; i < 3; ++i) {
      const auto corner = [&](Index v) {
        return Corner{terrain.xy[v].x, terrain.xy[v].y,
                      static_cast<long double>(pit.level) - terrain.z[v]};
      };
      const Corner a = corner(t[i]), b = corner(t[(i + 1) % 3]);
      if (a.depth > 0 && is_wet[t[i]]) part.push_back(a);
      if ((a.depth > 0) == (b.depth > 0) || !(is_wet[t[i]] || is_wet[t[(i + 1) % 3]])) continue;
      const long double at = a.depth / (a.depth - b.depth);
      part.push_back({a.x + at * (b.x - a.x), a.y + at * (b.y - a.y), 0});
    }
    for (std::size_t i = 2; i < part.size(); ++i) {
      const Corner &a = part[0], &b = part[i - 1], &c = part[i];
      volume += std::fabs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2 *
                (a.depth + b.depth + c.depth) / 3;
    }
  }
  return static_cast<double>(volume);
}

/// A valley between walls, with a sill after each pit, higher than the one before, and the next pit
/// deeper: each pit is in all that follow. Heights of the slopes are scattered, so that every level
/// finds corners.
Terrain nested_pits(Index count, double unit) {
  Terrain terrain;
  const Index columns = 2 * count + 1, rows = 5;
  for (Index x = 0; x < columns; ++x)
    for (Index y = 0; y < rows; ++y) {
      terrain.xy.push_back({double(x), double(y)});
      const double wall = 2. * count, scattered = double((x * 7919 + y * 104729) % (2 * count));
      const double floor = x == 0 ? wall : x % 2 ? -double(x / 2 + 1) : double(x / 2);
      const bool is_wall = y == 0 || y == 4 || x == 0;
      terrain.z.push_back(unit * (is_wall ? wall : y == 2 ? floor : std::max(scattered, floor)));
    }
  for (Index x = 0; x + 1 < columns; ++x)
    for (Index y = 0; y + 1 < rows; ++y) {
      const Index a = x * rows + y, b = a + rows;
      terrain.triangles.push_back({a, b, b + 1});
      terrain.triangles.push_back({a, b + 1, a + 1});
    }
  return terrain;
}

TEST(PitVolumes, AreExactButForRounding) {
  std::vector<Terrain> terrains;
  for (std::uint64_t seed = 0; seed < 24; ++seed) terrains.push_back(rough_terrain(seed));
  for (const Index count : {1, 2, 7, 40})
    for (const double unit : {1., 1e-3, 1e200, 1e-290})
      terrains.push_back(nested_pits(count, unit));
  for (const Terrain& terrain : terrains) {
    const TriangleMesh mesh = terrain.mesh();
    const std::vector<Pit> pits = pit_depths(mesh, terrain.xy, terrain.z);
    const std::vector<double> volumes = pit_volumes(mesh, terrain.xy, terrain.z, pits);
    for (std::size_t i = 0; i < pits.size(); ++i) {
      const double expected = clipped_volume(terrain, pits[i]);
      EXPECT_NEAR(volumes[i], expected, 1e-11 * expected + 5e-323) << i;
    }
  }
}

TEST(PitVolumes, AreFastForPitsInPits) {
  constexpr Index count = 100000;  // to look at every lake anew would take hours
  const Terrain terrain = nested_pits(count, 1);
  const TriangleMesh mesh = glued(terrain.xy.size(), terrain.triangles);
  const std::vector<Pit> pits = pit_depths(mesh, terrain.xy, terrain.z);
  const std::vector<double> volumes = pit_volumes(mesh, terrain.xy, terrain.z, pits);
  double last = 0;
  std::size_t nested = 0;
  for (std::size_t i = 0; i < pits.size(); ++i) {
    if (terrain.xy[pits[i].bottom].y != 2) continue;
    EXPECT_GT(volumes[i], last);
    last = volumes[i];
    ++nested;
  }
  EXPECT_EQ(nested, count);
  for (const std::size_t i : {std::size_t{0}, pits.size() / 3, pits.size() - 1}) {
    const double expected = clipped_volume(terrain, pits[i]);
    EXPECT_NEAR(volumes[i], expected, 1e-9 * expected);
  }
}

}  // namespace
}  // namespace hodt
