#include "hodt/order/mesh_order.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "../support/convert.h"
#include "../support/shapes.h"
#include <gtest/gtest.h>

#include "hodt/base/parallel.h"
#include "hodt/order/first_order/first_order.h"
#include "hodt/order/triangulation_order.h"

namespace hodt {
namespace {

using List = std::vector<std::array<Index, 3>>;

List to_list(const oracle::Triangles& triangles) {
  List list;
  for (const auto& [a, b, c] : triangles) list.push_back({Index(a), Index(b), Index(c)});
  return list;
}

/// By the oracle: both orders, and the histogram of plain ones.
MeshOrder expected_order(const oracle::Instance& instance, const oracle::Triangles& triangles) {
  MeshOrder expected;
  for (const auto& [a, b, c] : triangles) {
    const auto plain = static_cast<Index>(instance.triangle_order_plain(a, b, c));
    expected.order = std::max(expected.order, Index(instance.triangle_order(a, b, c)));
    expected.order_plain = std::max(expected.order_plain, plain);
    if (expected.histogram.size() <= plain) expected.histogram.resize(plain + 1);
    ++expected.histogram[plain];
  }
  return expected;
}

void expect_equal(const MeshOrder& found, const MeshOrder& expected, const PointSet& points) {
  ASSERT_EQ(found.order, expected.order) << support::to_source(points.xy);
  ASSERT_EQ(found.order_plain, expected.order_plain) << support::to_source(points.xy);
  ASSERT_EQ(found.histogram, expected.histogram) << support::to_source(points.xy);
}

class OrderFamilies : public testing::TestWithParam<families::Family> {};

TEST_P(OrderFamilies, of_all_triangulations) {
  for (const int n : {4, 6, 7}) {
    const oracle::Instance instance(GetParam().make(n, 31));
    const PointSet points = support::to_point_set(instance.points());
    const oracle::Catalogue catalogue(instance);
    for (const auto& each : catalogue.triangulations())
      expect_equal(order_of_mesh(points, to_list(each.triangles)),
                   expected_order(instance, each.triangles), points);
  }
}

/// Triangles that make no mesh at all, at random.
TEST_P(OrderFamilies, of_any_list_of_triangles) {
  families::Random random(2);
  const int n = GetParam().name == "wide_range" ? 10 : 18;
  const oracle::Instance instance(GetParam().make(n, 32));
  const PointSet points = support::to_point_set(instance.points());
  for (int round = 0; round < 30; ++round) {
    oracle::Triangles triangles;
    for (int i = 0; i < round % 5 + 1; ++i) {
      const int a = random.integer(0, instance.size() - 1);
      const int b = random.integer(0, instance.size() - 1);
      const int c = random.integer(0, instance.size() - 1);
      if (a != b && b != c && c != a && instance.orient(a, b, c) > 0)
        triangles.push_back({a, b, c});
    }
    expect_equal(order_of_mesh(points, to_list(triangles)), expected_order(instance, triangles),
                 points);
  }
}

/// The histogram of the optimizers: by the perturbation, against the Delaunay triangulation.
TEST_P(OrderFamilies, histogram_of_a_changed_triangulation) {
  for (const int n : {4, 6, 7}) {
    const Delaunay d = delaunay(support::to_point_set(GetParam().make(n, 33)));
    const DelaunayGraph graph(d);
    const oracle::Instance instance(support::to_oracle(d.vertices.xy));
    const oracle::Catalogue catalogue(instance);
    for (const auto& each : catalogue.triangulations()) {
      std::vector<std::size_t> expected;
      for (const auto& [a, b, c] : each.triangles) {
        const auto order = static_cast<std::size_t>(instance.triangle_order(a, b, c));
        if (expected.size() <= order) expected.resize(order + 1);
        ++expected[order];
      }
      const TriangleMesh mesh = support::make_mesh(d.vertices.size(), to_list(each.triangles));
      ASSERT_EQ(order_histogram(graph, mesh), expected);
      const std::vector<Index> orders = triangle_orders(graph, MeshChange(mesh));
      ASSERT_EQ(order_histogram(orders), expected);
      for (std::size_t t = 0; t < orders.size(); ++t) {
        const auto& [a, b, c] = each.triangles[t];
        ASSERT_EQ(int(orders[t]), instance.triangle_order(a, b, c));
      }
      ASSERT_EQ(expected.size(), std::size_t(each.order) + 1);
      // The same corners in another order are no other triangle.
      List turned = to_list(each.triangles);
      for (auto& corners : turned) std::rotate(corners.begin(), corners.begin() + 1, corners.end());
      ASSERT_EQ(order_histogram(graph, support::make_mesh(d.vertices.size(), turned)), expected);
    }
    ASSERT_EQ(order_histogram(graph, d.mesh), std::vector<std::size_t>{d.mesh.triangle_count()});
  }
}

INSTANTIATE_TEST_SUITE_P(All, OrderFamilies, testing::ValuesIn(families::all()),
                         [](const auto& each) { return each.param.name; });

TEST(MeshOrder, of_flips) {
  const Delaunay d = delaunay({support::uniform(2000, 6), {}});
  const DelaunayGraph graph(d);
  const std::vector<HalfEdgeId> flips = first_order_edges(graph);
  const MeshChange change(flips);
  EXPECT_EQ(order_histogram(graph, change), order_histogram(graph, change.applied_to(d.mesh)));
  EXPECT_EQ(triangle_orders(graph, change),
            triangle_orders(graph, MeshChange(change.applied_to(d.mesh))));
  EXPECT_EQ(order_histogram(graph, MeshChange()), order_histogram(graph, d.mesh));
  HalfEdgeId beside = TriangleMesh::next(flips.front());
  if (d.mesh.is_boundary(beside)) beside = TriangleMesh::next(beside);
  EXPECT_THROW(order_histogram(graph, MeshChange({flips.front(), beside})), std::logic_error);
  EXPECT_THROW(triangle_orders(graph, MeshChange({flips.front(), beside})), std::logic_error);
}

TEST(MeshOrder, points_that_are_no_corner_count) {
  const PointSet points{{{0, 0}, {4, 0}, {0, 4}, {1, 1}, {3, 3}, {2, 1}, {4, 4}}, {}};
  const MeshOrder order = order_of_mesh(points, List{{0, 1, 2}});
  // (4, 4) is on the circle, and the largest: outside by both rules.
  EXPECT_EQ(order.order, 3u);
  EXPECT_EQ(order.order_plain, 3u);
  EXPECT_EQ(order.histogram, (std::vector<std::size_t>{0, 0, 0, 1}));
}

TEST(MeshOrder, cocircular_points_are_outside_by_the_plain_rule) {
  const PointSet square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}};
  const MeshOrder one = order_of_mesh(square, List{{0, 1, 2}, {0, 2, 3}});
  const MeshOrder other = order_of_mesh(square, List{{0, 1, 3}, {1, 2, 3}});
  EXPECT_EQ(one.order_plain, 0u);
  EXPECT_EQ(other.order_plain, 0u);
  EXPECT_EQ(one.order + other.order, 1u) << "exactly one diagonal is Delaunay";
}

TEST(MeshOrder, duplicates_are_one_point_and_corners_of_either_row) {
  const PointSet points{{{0, 0}, {4, 0}, {0, 4}, {1, 1}, {1, 1}, {4, 0}, {0, 0}}, {}};
  for (const List& list : {List{{0, 1, 2}}, List{{6, 5, 2}}, List{{5, 2, 0}}}) {
    const MeshOrder order = order_of_mesh(points, list);
    EXPECT_EQ(order.order, 1u);
    EXPECT_EQ(order.histogram, (std::vector<std::size_t>{0, 1}));
  }
}

TEST(MeshOrder, no_triangles) {
  const MeshOrder order = order_of_mesh({{{0, 0}, {1, 0}, {0, 1}}, {}}, {});
  EXPECT_EQ(order.order, 0u);
  EXPECT_EQ(order.order_plain, 0u);
  EXPECT_TRUE(order.histogram.empty());
}

TEST(MeshOrder, of_a_large_delaunay_triangulation_on_any_threads) {
  for (const support::Points& points : {support::uniform(30000, 4), support::lattice(150, 150)}) {
    const Delaunay d = delaunay({points, {}});
    List list;
    for (Index t = 0; t < d.mesh.triangle_count(); ++t) {
      auto [a, b, c] = d.mesh.corners(TriangleId(t));
      list.push_back({d.vertices.row[a], d.vertices.row[b], d.vertices.row[c]});
    }
    for (const std::size_t threads : {1, 2}) {
      const ThreadLimit limit(threads);
      const MeshOrder order = order_of_mesh({points, {}}, list);
      EXPECT_EQ(order.order, 0u);
      EXPECT_EQ(order.histogram, std::vector<std::size_t>{list.size()});
    }
  }
}

TEST(MeshOrder, APointOfNoTriangleMayLieOnTheBorder) {
  // Not convex: the border is a wall, and the last point lies on it.
  const PointSet points{{{0, 0}, {4, 0}, {0, 4}, {1, 1}, {2, 0}}, {}};
  const List triangles{{0, 1, 3}, {0, 3, 2}};
  const std::vector<std::array<Index, 2>> border{{0, 1}, {1, 3}, {3, 2}, {2, 0}};
  const MeshOrder order = order_of_mesh(points, triangles, {}, border);
  EXPECT_EQ(order.missing_walls, 0u);
  EXPECT_EQ(order.order, 1u);  // it is inside the circle of the first triangle
  // A line that the mesh has not is still found out.
  const std::vector<std::array<Index, 2>> line{{3, 4}};
  EXPECT_EQ(order_of_mesh(points, triangles, line, border).missing_walls, 1u);
}

}  // namespace
}  // namespace hodt
