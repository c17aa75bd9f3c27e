#include "hodt/geometry/heights.h"

#include <vector>

#include <gtest/gtest.h>

namespace hodt {
namespace {

TEST(Heights, ties_go_by_x_and_then_y) {
  const std::vector<Point> xy{{0, 0}, {1, 0}, {1, 1}, {-5, 9}};
  const std::vector<double> z{2, 2, 2, 3};
  const Heights heights{xy, z};
  for (Index u = 0; u < 4; ++u)
    for (Index v = 0; v < 4; ++v) {
      EXPECT_EQ(heights.lower(VertexId(u), VertexId(v)), u < v) << u << ' ' << v;
      EXPECT_EQ(heights.removes(VertexId(u), VertexId(v), Extremum::minimum), u < v);
      EXPECT_EQ(heights.removes(VertexId(u), VertexId(v), Extremum::maximum), u > v);
    }
}

TEST(Heights, zero_has_no_sign) {
  const std::vector<Point> xy{{-0.0, 1}, {0.0, 2}};
  const std::vector<double> z{0.0, -0.0};
  const Heights heights{xy, z};
  EXPECT_TRUE(heights.lower(VertexId(0), VertexId(1)));
  EXPECT_FALSE(heights.lower(VertexId(1), VertexId(0)));
}

}  // namespace
}  // namespace hodt
