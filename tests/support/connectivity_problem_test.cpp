#include "connectivity_problem.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "convert.h"
#include "shapes.h"
#include <gtest/gtest.h>

namespace hodt {
namespace {

using support::make_mesh;

std::string problem(const TriangleMesh& mesh, Surface surface = Surface::disk) {
  return connectivity_problem(mesh, surface);
}

/// Two triangles, (0, 1, 2) and (2, 1, 3).
TriangleMesh two_triangles() {
  return make_mesh(4, {{0, 1, 2}, {2, 1, 3}});
}

/// A hub, 0, with five triangles around it.
TriangleMesh wheel() {
  return make_mesh(6, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1}});
}

void expect_problem(const TriangleMesh& mesh, const std::string& words,
                    Surface surface = Surface::disk) {
  const std::string found = connectivity_problem(mesh, surface);
  EXPECT_NE(found.find(words), std::string::npos) << "found: " << found;
}

TEST(ConnectivityProblem, none_in_good_meshes) {
  EXPECT_EQ(problem(make_mesh(3, {{0, 1, 2}})), "");
  EXPECT_EQ(problem(two_triangles()), "");
  EXPECT_EQ(problem(wheel()), "");
  for (const auto& family : families::all())
    EXPECT_EQ(problem(delaunay(support::to_point_set(family.make(30, 1))).mesh), "") << family.name;
}

TEST(ConnectivityProblem, vertices_without_triangles_do_not_count) {
  EXPECT_EQ(problem(make_mesh(9, {{5, 1, 7}})), "");
}

TEST(ConnectivityProblem, array_sizes) {
  expect_problem(TriangleMesh(3, Buffer<Index>(3, 0), Buffer<Index>(6, kNone)), "3 origins but 6");
  expect_problem(TriangleMesh(3, Buffer<Index>(4, 0), Buffer<Index>(4, kNone)), "three a triangle");
}

TEST(ConnectivityProblem, corners) {
  TriangleMesh mesh = two_triangles();
  mesh.set_origin(HalfEdgeId(5), VertexId(4));
  expect_problem(mesh, "triangle 1 has the corner 4");
  mesh.set_origin(HalfEdgeId(5), VertexId());
  expect_problem(mesh, "triangle 1 has the corner");
  mesh.set_origin(HalfEdgeId(5), VertexId(1));
  expect_problem(mesh, "triangle 1 has a corner twice");
}

TEST(ConnectivityProblem, twins) {
  TriangleMesh mesh = two_triangles();
  ASSERT_EQ(mesh.twin(HalfEdgeId(1)), HalfEdgeId(3));
  mesh.twins()[3] = kNone;
  expect_problem(mesh, "half-edge 1 has the twin 3, whose twin is another");
  mesh.twins()[3] = 6;
  expect_problem(mesh, "whose twin is another");
  mesh.twins()[1] = 6;
  expect_problem(mesh, "half-edge 1 has the twin 6, but there are 6");
  mesh = two_triangles();
  mesh.twins()[0] = 0;
  expect_problem(mesh, "half-edge 0 runs from 0 to 1");
  mesh = two_triangles();
  mesh.glue(HalfEdgeId(0), HalfEdgeId(5));
  expect_problem(mesh, "half-edge 0 runs from 0 to 1, its twin 5 from 3 to 2");
  // The right ends, but in the same direction: a clockwise neighbour.
  mesh = make_mesh(4, {{0, 1, 2}, {1, 2, 3}});
  mesh.glue(HalfEdgeId(1), HalfEdgeId(3));
  expect_problem(mesh, "half-edge 1 runs from 1 to 2, its twin 3 from 1 to 2");
}

TEST(ConnectivityProblem, a_vertex_of_two_fans) {
  const TriangleMesh bow_tie = make_mesh(5, {{0, 1, 2}, {0, 3, 4}});
  expect_problem(bow_tie, "vertex 0 has 2 triangles, but only 1", Surface::any);
  // A full turn and a triangle beside it.
  const TriangleMesh pinched =
      make_mesh(8, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1}, {0, 6, 7}});
  expect_problem(pinched, "vertex 0 has 6 triangles", Surface::any);
  // A twin forgotten on both sides splits a fan, but only of inner vertices it is a fan still.
  TriangleMesh cut = wheel();
  cut.twins()[cut.twin(HalfEdgeId(0))] = kNone;
  cut.twins()[0] = kNone;
  EXPECT_EQ(problem(cut, Surface::any), "vertex 1 has 2 triangles, but only 1 of them around it");
}

TEST(ConnectivityProblem, a_disk_is_one_piece_without_holes) {
  const TriangleMesh two_pieces = make_mesh(6, {{0, 1, 2}, {3, 4, 5}});
  EXPECT_EQ(problem(two_pieces, Surface::any), "");
  expect_problem(two_pieces, "only 1 of 2 triangles");
  // A ring around the hole 0 1 2.
  const TriangleMesh ring =
      make_mesh(6, {{0, 3, 1}, {1, 3, 4}, {1, 4, 2}, {2, 4, 5}, {2, 5, 0}, {0, 5, 3}});
  EXPECT_EQ(problem(ring, Surface::any), "");
  expect_problem(ring, "is not 1: no disk");
  const TriangleMesh tetrahedron = make_mesh(4, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}});
  EXPECT_EQ(problem(tetrahedron, Surface::any), "");
  expect_problem(tetrahedron, "is not 1: no disk");
  EXPECT_EQ(problem(TriangleMesh(), Surface::any), "");
  expect_problem(TriangleMesh(), "no triangle");
}

/// Whatever one number of a mesh becomes, the change is found: no other value makes sense.
TEST(ConnectivityProblem, any_single_wrong_number) {
  const TriangleMesh good = delaunay({support::uniform(40, 3), {}}).mesh;
  ASSERT_EQ(problem(good), "");
  const auto count = static_cast<Index>(good.halfedge_count());
  for (Index h = 0; h < count; ++h) {
    for (Index value : {Index{0}, (h + 1) % count, (h * 7 + 3) % count, count - 1, count, kNone}) {
      TriangleMesh mesh = good;
      mesh.twins()[h] = value;
      EXPECT_EQ(problem(mesh).empty(), value == good.twins()[h]) << h << " twin " << value;
      mesh = good;
      value = value >= count ? value : value % Index(good.vertex_count());
      mesh.origins()[h] = value;
      EXPECT_EQ(problem(mesh).empty(), value == good.origins()[h]) << h << " origin " << value;
    }
  }
}

/// Random contents: no crash, no endless walk.
TEST(ConnectivityProblem, garbage) {
  families::Random random(5);
  int fine = 0;
  for (int round = 0; round < 20000; ++round) {
    const int triangles = random.integer(1, 4);
    TriangleMesh mesh(6, Buffer<Index>(3 * triangles), Buffer<Index>(3 * triangles));
    for (Index& v : mesh.origins()) v = Index(random.integer(0, 6));
    for (Index& h : mesh.twins()) h = Index(random.integer(-1, 3 * triangles));
    fine += connectivity_problem(mesh).empty();
  }
  EXPECT_LT(fine, 1000);
}

}  // namespace
}  // namespace hodt
