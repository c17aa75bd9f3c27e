// Meshes that are there already: what of them stays, and that nothing gets worse.
#include "hodt/pipeline/given_tin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "../support/terrains.h"
#include "families.h"
#include <gtest/gtest.h>

#include "hodt/base/error.h"
#include "hodt/io/input_text.h"
#include "hodt/io/point_file.h"
#include "hodt/optimize/value_of.h"
#include "hodt/pipeline.h"
#include "hodt/tin/boundary_edges.h"
#include "hodt/tin/embedding.h"

namespace hodt {
namespace {

/// Around a triangular hole, with a vertex of no triangle, and one triangle given clockwise.
Tin ring() {
  Tin tin;
  tin.points.xy = {{5, 5}, {0, 0}, {10, 0}, {5, 9}, {4, 2}, {6, 2}, {5, 4}};
  tin.points.z = {9, 0, 1, 2, 3, 4, 5};
  tin.triangles = {{1, 2, 5}, {1, 5, 4}, {2, 3, 6}, {6, 5, 2}, {3, 1, 4}, {6, 3, 4}};
  return tin;
}

TEST(GivenTin, keeps_used_vertices_outline_and_holes) {
  const GivenTin given = given_tin(ring());
  EXPECT_EQ(given.unused_vertices, 1u);
  ASSERT_EQ(given.points.size(), 6u);
  EXPECT_EQ(given.points.xy[0], (Point{0, 0}));
  EXPECT_EQ(given.points.z[5], 5);
  EXPECT_EQ(given.constraints.boundary.size(), 6u);
  const TriangulateResult result = triangulate(given.points, {.order = 4}, given.constraints);
  EXPECT_EQ(result.tin.triangles.size(), 6u);
  EXPECT_EQ(boundary_edges(result.tin.triangles), given.constraints.boundary);
  ASSERT_TRUE(result.report.given);
}

TEST(GivenTin, refuses_what_is_no_mesh) {
  Tin tin;
  tin.points.xy = {{0, 0}, {2, 0}, {0, 2}, {2, 2}, {1, -1}};
  tin.triangles = {{0, 1, 2}, {0, 1, 3}};
  try {
    given_tin(tin);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("triangle"), std::string::npos);
  }
}

/// Two triangles that meet in a corner only: each side has a vertex of its own there.
TEST(GivenTin, knows_the_sides_of_a_vertex_where_it_touches_itself) {
  Tin tin;
  tin.points.xy = {{0, 0}, {2, 0}, {1, 1}, {0, 2}, {2, 2}};
  tin.points.z = {0, 1, 2, 3, 5};
  tin.triangles = {{0, 1, 2}, {2, 4, 3}};
  const GivenTin given = given_tin(tin);
  for (const char* name : {"min-sum-length", "min-max-abn", "max-min-abn", "min-sum-jnd"}) {
    const TriangulateResult result =
        triangulate(given.points, {.objective = objective_from_name(name)}, given.constraints);
    ASSERT_TRUE(result.report.given) << name;
    EXPECT_EQ(result.report.given->order, 0u);
    EXPECT_EQ(result.report.given->value, result.report.value->result) << name;
    EXPECT_TRUE(result.report.value->optimal) << name;
    EXPECT_EQ(result.tin.points.size(), 5u);
    EXPECT_EQ(result.tin.triangles.size(), 2u);
  }
}

/// A result of another objective as the mesh, with a hole: its value is told, the result of its
/// order is no worse, and improving it again changes nothing.
TEST(GivenTin, is_never_better_than_the_result_of_its_order) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    PointSet points;
    for (const auto& [x, y] : families::random_square(60, seed)) points.xy.push_back({x, y});
    families::Random random(seed);
    for (std::size_t i = 0; i < points.size(); ++i) points.z.push_back(random.real());
    Tin tin =
        triangulate(points, {.order = 3, .objective = objective_from_name("max-sum-length")}).tin;
    tin.triangles.erase(tin.triangles.begin() + 30);
    const GivenTin given = given_tin(tin);
    for (const char* name : {"min-local-minima", "min-local-extrema", "min-max-degree",
                             "min-max-angle", "min-sum-length", "min-sum-abn"}) {
      const Objective objective = objective_from_name(name);
      const TriangulateOptions options{.order = 4, .objective = objective};
      const TriangulateResult result = triangulate(given.points, options, given.constraints);
      const Value& value = *result.report.value;
      ASSERT_LE(result.report.given->order, 4u);
      EXPECT_FALSE(is_better(objective, result.report.given->value, value.result)) << name;
      EXPECT_EQ(boundary_edges(result.tin.triangles), given.constraints.boundary);
      const TriangulateResult again =
          triangulate(result.tin.points, options, given_tin(result.tin).constraints);
      EXPECT_NEAR(again.report.given->value, value.result, 1e-9 * value.result) << name;
      EXPECT_FALSE(is_better(objective, again.report.given->value, again.report.value->result));
    }
  }
}

/// A mesh of finite elements as the terrains come: nodes.csv and triangles.csv.gz.
std::optional<Tin> real_mesh(const std::string& name) {
  const auto folder = support::terrain_folder(name);
  if (!folder) return std::nullopt;
  Tin tin;
  tin.points = read_points(*folder / "nodes.csv");
  const InputText text = read_input(*folder / "triangles.csv.gz");
  std::istringstream lines{std::string(text.view())};
  std::string header;
  std::getline(lines, header);
  char comma;
  for (Index a, b, c; lines >> a >> comma >> b >> comma >> c;) tin.triangles.push_back({a, b, c});
  return tin;
}

/// In degrees.
double largest_angle(const Tin& tin) {
  double largest = 0;
  for (const std::array<Index, 3>& corners : tin.triangles)
    for (int i = 0; i < 3; ++i) {
      const Point &a = tin.points.xy[corners[i]], &b = tin.points.xy[corners[(i + 1) % 3]],
                  &c = tin.points.xy[corners[(i + 2) % 3]];
      const double x = b.x - a.x, y = b.y - a.y, u = c.x - a.x, v = c.y - a.y;
      largest = std::max(largest, std::atan2(std::fabs(x * v - y * u), x * u + y * v));
    }
  return largest * 180 / std::acos(-1.0);
}

class RealMesh : public testing::TestWithParam<const char*> {};

TEST_P(RealMesh, gets_better_on_its_vertices_within_its_border) {
  const std::optional<Tin> tin = real_mesh(GetParam());
  if (!tin) GTEST_SKIP() << support::no_terrain(GetParam());
  const GivenTin given = given_tin(*tin);
  for (const Index k : {1, 4}) {
    const TriangulateResult result =
        triangulate(given.points, {.order = k, .objective = objective_from_name("min-max-angle")},
                    given.constraints);
    EXPECT_EQ(result.tin.points.xy, given.points.xy);
    EXPECT_EQ(result.tin.points.z, given.points.z);
    EXPECT_EQ(result.tin.triangles.size(), tin->triangles.size());
    EXPECT_EQ(boundary_edges(result.tin.triangles), given.constraints.boundary);
    EXPECT_EQ(check_embedding(result.tin.points.xy, result.tin.triangles).problem, "");
    ASSERT_TRUE(result.report.given);
    EXPECT_NEAR(result.report.given->value, largest_angle(*tin), 1e-9);
    EXPECT_NEAR(result.report.value->result, largest_angle(result.tin), 1e-9);
    EXPECT_TRUE(result.report.value->optimal);
    if (k == 4) {
      EXPECT_LT(result.report.value->result, result.report.given->value);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, RealMesh,
                         testing::Values("mesh_merimbula", "mesh_japan_sea", "mesh_shinnecock"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace hodt
