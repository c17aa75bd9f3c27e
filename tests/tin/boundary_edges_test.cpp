#include "hodt/tin/boundary_edges.h"

#include <gtest/gtest.h>

namespace hodt {
namespace {

using Edges = std::vector<std::array<Index, 2>>;
using Triangles = std::vector<std::array<Index, 3>>;

TEST(BoundaryEdges, are_those_of_one_triangle_in_its_direction) {
  EXPECT_EQ(boundary_edges(Triangles{}), Edges{});
  EXPECT_EQ(boundary_edges(Triangles{{2, 0, 1}}), (Edges{{0, 1}, {1, 2}, {2, 0}}));
  EXPECT_EQ(boundary_edges(Triangles{{0, 1, 2}, {1, 0, 3}}),
            (Edges{{0, 3}, {1, 2}, {2, 0}, {3, 1}}));
}

/// A ring of triangles around a triangular hole: the hole runs the other way.
TEST(BoundaryEdges, go_around_holes) {
  const Triangles ring{{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
  EXPECT_EQ(boundary_edges(ring), (Edges{{0, 1}, {1, 2}, {2, 0}, {3, 5}, {4, 3}, {5, 4}}));
}

}  // namespace
}  // namespace hodt
