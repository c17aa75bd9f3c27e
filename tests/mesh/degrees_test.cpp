#include "hodt/mesh/degrees.h"

#include <set>
#include <utility>
#include <vector>

#include "../support/shapes.h"
#include <gtest/gtest.h>

#include "hodt/delaunay/delaunay.h"

namespace hodt {
namespace {

TEST(Degrees, are_the_numbers_of_neighbours) {
  for (const support::Points& points : {support::uniform(300, 1), support::lattice(9, 7),
                                        support::Points{{0, 0}, {1, 0}, {0, 1}}}) {
    const Delaunay d = delaunay({points, {}});
    std::set<std::pair<Index, Index>> neighbours;
    for (Index t = 0; t < d.mesh.triangle_count(); ++t) {
      const auto [a, b, c] = d.mesh.corners(TriangleId(t));
      for (const auto& [u, v] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
        neighbours.emplace(u, v);
        neighbours.emplace(v, u);
      }
    }
    std::vector<Index> expected(points.size(), 0);
    for (const auto& [u, v] : neighbours) ++expected[u];
    const Buffer<Index> degrees = degrees_of(d.mesh);
    EXPECT_EQ(std::vector<Index>(degrees.begin(), degrees.end()), expected);
  }
}

}  // namespace
}  // namespace hodt
