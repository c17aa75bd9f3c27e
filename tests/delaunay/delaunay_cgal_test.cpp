// The Delaunay triangulation against CGAL's, ties included.
#include <cmath>
#include <string>
#include <vector>

#include "../support/cgal_triangles.h"
#include "../support/shapes.h"
#include "../support/terrains.h"
#include <gtest/gtest.h>

#include "hodt/delaunay/delaunay.h"

namespace hodt {
namespace {

void expect_same(const PointSet& points) {
  const Delaunay ours = delaunay(points);
  // In our order, so that CGAL gets distinct points; vertex numbers are the same then.
  const oracle::Triangles triangles = support::triangles_of(ours.mesh);
  const oracle::Triangles theirs = support::cgal_delaunay(ours.vertices.xy);
  ASSERT_EQ(triangles.size(), theirs.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) ASSERT_EQ(triangles[i], theirs[i]);
}

class Cgal : public testing::TestWithParam<support::Shape> {};

TEST_P(Cgal, has_the_same_triangles) {
  expect_same({GetParam().make(), {}});
}

std::vector<support::Shape> shapes() {
  using namespace support;
  return {
      {"uniform", [] { return uniform(100000, 11); }},
      {"clustered", [] { return clustered(100000, 12); }},
      {"lattice", [] { return lattice(300, 300); }},
      {"shuffled_lattice", [] { return shuffled(lattice(150, 150), 1); }},
      {"utm_lattice", [] { return utm_lattice(200, 200); }},
      {"noisy_lattice", [] { return noisy_lattice(200, 200, 1e-10, 13); }},
      {"barely_noisy_lattice", [] { return noisy_lattice(200, 200, 1e-15, 14); }},
      {"lattice_of_ulps", [] { return lattice_of_ulps(150, 150); }},
      {"cocircular_ring", [] { return cocircular_rings(1); }},
      {"cocircular_rings", [] { return cocircular_rings(50); }},
      {"hexagonal",
       [] {
         return grid(150, 150, [](int i, int j) {
           return Point{i + 0.5 * (j % 2), j * std::sqrt(0.75)};
         });
       }},
      {"sheared_lattice",
       [] { return grid(150, 150, [](int i, int j) {
              return Point{3.0 * i + j, 3.0 * j - i};
            }); }},
  };
}

INSTANTIATE_TEST_SUITE_P(Shapes, Cgal, testing::ValuesIn(shapes()),
                         [](const auto& each) { return each.param.name; });

class CgalFamilies : public testing::TestWithParam<families::Family> {};

TEST_P(CgalFamilies, has_the_same_triangles) {
  for (const int n : {10, 100, 1000}) expect_same(support::to_point_set(GetParam().make(n, n + 1)));
}

/// Without the families at the ends of the exponent range, which CGAL does not claim to handle.
std::vector<families::Family> families_within_range() {
  std::vector<families::Family> within;
  for (const auto& family : families::all())
    if (family.name != "wide_range" && family.name != "subnormal_lattice") within.push_back(family);
  return within;
}

INSTANTIATE_TEST_SUITE_P(Families, CgalFamilies, testing::ValuesIn(families_within_range()),
                         [](const auto& each) { return each.param.name; });

class CgalTerrains : public testing::TestWithParam<std::string> {};

TEST_P(CgalTerrains, has_the_same_triangles) {
  const auto points = support::terrain_sample(GetParam());
  if (!points) GTEST_SKIP() << support::no_terrain(GetParam());
  expect_same(*points);
}

INSTANTIATE_TEST_SUITE_P(Samples, CgalTerrains,
                         testing::Values("whitebox_dem", "jacksboro", "bigtujunga",
                                         "baja_soundings", "lidar_delft_east", "swiss_sic97"),
                         [](const auto& each) { return each.param; });

}  // namespace
}  // namespace hodt
