#include "hodt/mesh/mesh_change.h"

#include <utility>
#include <vector>

#include "../support/connectivity_problem.h"
#include "../support/convert.h"
#include "../support/inner_edges.h"
#include "../support/shapes.h"
#include <gtest/gtest.h>

#include "hodt/delaunay/delaunay.h"

namespace hodt {
namespace {

/// Flips on both sides of the place, as far away as what is asked for in advance.
TEST(MeshChange, flips_one_after_another) {
  const TriangleMesh mesh = delaunay({support::uniform(500, 3), {}}).mesh;
  std::vector<bool> used(mesh.triangle_count(), false);
  std::vector<HalfEdgeId> flips;
  TriangleMesh expected = mesh;
  for_each_inner_edge(mesh, [&](HalfEdgeId h) {
    const TriangleId left = TriangleMesh::triangle(h), right = TriangleMesh::triangle(mesh.twin(h));
    if (used[left] || used[right]) return;
    used[left] = used[right] = true;
    flips.push_back(h);
    expected.flip(h);
  });
  ASSERT_GT(flips.size(), 100u);
  MeshChange change(flips);
  EXPECT_EQ(change.mesh(), nullptr);
  EXPECT_EQ(change.flips().size(), flips.size());
  EXPECT_TRUE(support::same_arrays(change.applied_to(mesh), expected));
  TriangleMesh in_place = mesh;
  std::move(change).apply_to(in_place);
  EXPECT_TRUE(support::same_arrays(in_place, expected));
  EXPECT_EQ(connectivity_problem(in_place, Surface::disk), "");
}

TEST(MeshChange, may_be_nothing_or_all) {
  const TriangleMesh mesh = delaunay({support::uniform(50, 3), {}}).mesh;
  const TriangleMesh other = delaunay({support::uniform(50, 4), {}}).mesh;
  EXPECT_TRUE(support::same_arrays(MeshChange().applied_to(mesh), mesh));
  const MeshChange change(other);
  EXPECT_TRUE(support::same_arrays(*change.mesh(), other));
  EXPECT_TRUE(support::same_arrays(change.applied_to(mesh), other));
}

}  // namespace
}  // namespace hodt
