#include "hodt/delaunay/spatial_order.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "../support/convert.h"
#include "../support/shapes.h"
#include <gtest/gtest.h>

namespace hodt {
namespace {

/// The bits of a key that are y's (odd) or x's (even), as a number.
std::uint32_t cell(std::uint64_t key, int first_bit) {
  std::uint32_t value = 0;
  for (int i = 0; i < 32; ++i) value |= std::uint32_t(key >> (2 * i + first_bit) & 1) << i;
  return value;
}

std::vector<PointSet> sample_sets() {
  std::vector<PointSet> sets;
  for (const auto& family : families::all())
    for (const int n : {4, 40}) sets.push_back(support::to_point_set(family.make(n, 5)));
  sets.push_back({support::uniform(20000, 1), {}});
  sets.push_back({support::clustered(20000, 2), {}});
  sets.push_back({support::lattice(100, 100), {}});
  sets.push_back({support::lattice_of_ulps(100, 100), {}});
  sets.push_back({{{3, 4}}, {}});
  sets.push_back({{{3, 4}, {3, 5}}, {}});
  return sets;
}

TEST(SpatialOrder, every_point_is_there_once_with_its_row) {
  for (const PointSet& points : sample_sets()) {
    const SpatialOrder order = spatial_order(points);
    ASSERT_EQ(order.vertices.size(), points.size());
    ASSERT_EQ(order.vertices.row.size(), points.size());
    ASSERT_EQ(order.key.size(), points.size());
    std::vector<Index> rows(order.vertices.row.begin(), order.vertices.row.end());
    std::sort(rows.begin(), rows.end());
    for (Index i = 0; i < rows.size(); ++i) ASSERT_EQ(rows[i], i);
    for (Index v = 0; v < order.vertices.size(); ++v)
      ASSERT_EQ(order.vertices.xy[v], points.xy[order.vertices.row[v]]);
  }
}

TEST(SpatialOrder, keys_rise_and_equal_keys_are_lexicographic) {
  for (const PointSet& points : sample_sets()) {
    const SpatialOrder order = spatial_order(points);
    for (std::size_t i = 1; i < order.key.size(); ++i) {
      ASSERT_LE(order.key[i - 1], order.key[i]);
      if (order.key[i - 1] < order.key[i]) continue;
      ASSERT_TRUE(lexicographically_less(order.vertices.xy[i - 1], order.vertices.xy[i]));
    }
  }
}

/// What makes a cut between two keys a straight line: cells rise with coordinates.
TEST(SpatialOrder, cells_are_monotone_in_both_coordinates) {
  for (const PointSet& points : sample_sets()) {
    const SpatialOrder order = spatial_order(points);
    const auto& xy = order.vertices.xy;
    for (const bool along_y : {false, true}) {
      std::vector<std::pair<double, std::uint32_t>> by_coordinate;
      for (std::size_t i = 0; i < xy.size(); ++i)
        by_coordinate.emplace_back(along_y ? xy[i].y : xy[i].x, cell(order.key[i], along_y));
      std::sort(by_coordinate.begin(), by_coordinate.end());
      for (std::size_t i = 1; i < by_coordinate.size(); ++i) {
        ASSERT_LE(by_coordinate[i - 1].second, by_coordinate[i].second);
        if (by_coordinate[i - 1].first != by_coordinate[i].first) continue;
        ASSERT_EQ(by_coordinate[i - 1].second, by_coordinate[i].second);
      }
    }
  }
}

TEST(SpatialOrder, the_larger_extent_uses_all_cells) {
  const SpatialOrder order = spatial_order(PointSet{{{-5, 1}, {15, 2}, {3, 1.5}}, {}});
  EXPECT_EQ(cell(order.key[0], 0), 0u);
  std::uint32_t largest_x = 0, largest_y = 0;
  for (const std::uint64_t key : order.key) {
    largest_x = std::max(largest_x, cell(key, 0));
    largest_y = std::max(largest_y, cell(key, 1));
  }
  EXPECT_GT(largest_x, 0xfffffff0u);
  EXPECT_NEAR(largest_y, 4294967295.0 / 20, 10);
}

TEST(SpatialOrder, near_in_the_order_is_near_in_the_plane) {
  const SpatialOrder order = spatial_order({support::uniform(100000, 3), {}});
  double sum = 0;
  for (std::size_t i = 1; i < order.key.size(); ++i) {
    const Point &p = order.vertices.xy[i - 1], &q = order.vertices.xy[i];
    sum += std::hypot(p.x - q.x, p.y - q.y);
  }
  // A random order would jump by 0.52 on average, the best possible one by about 0.0022.
  EXPECT_LT(sum / 100000, 0.01);
}

TEST(SpatialOrder, heights_travel_along) {
  PointSet points{support::uniform(5000, 4), {}};
  for (std::size_t i = 0; i < points.size(); ++i) points.z.push_back(double(i) / 2);
  const SpatialOrder order = spatial_order(points);
  ASSERT_EQ(order.vertices.z.size(), points.size());
  for (Index v = 0; v < order.vertices.size(); ++v)
    ASSERT_EQ(order.vertices.z[v], order.vertices.row[v] / 2.0);
}

TEST(SpatialOrder, no_points) {
  const SpatialOrder order = spatial_order({});
  EXPECT_EQ(order.vertices.size(), 0u);
  EXPECT_EQ(order.key.size(), 0u);
}

TEST(SpatialOrder, one_place_many_times) {
  PointSet points{std::vector<Point>(100, Point{1e300, -1e300}), {}};
  for (int i = 0; i < 100; ++i) points.z.push_back((i * 37 + 11) % 100);
  const SpatialOrder order = spatial_order(points);
  ASSERT_EQ(order.vertices.size(), 1u);
  EXPECT_EQ(order.vertices.z[0], 0);
  EXPECT_EQ(points.z[order.vertices.row[0]], 0);
  const auto vertex_of = vertices_of_rows(points, order.vertices);
  for (const VertexId v : vertex_of) EXPECT_EQ(v, VertexId(0));
}

}  // namespace
}  // namespace hodt
