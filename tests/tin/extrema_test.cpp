#include "hodt/tin/extrema.h"

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace hodt {
namespace {

using Triangles = std::vector<std::array<Index, 3>>;

/// The definitions, word for word.
class BruteForce {
 public:
  BruteForce(const PointSet& points, const Triangles& triangles) : points_(points) {
    for (const auto& t : triangles) {
      for (int i = 0; i < 3; ++i) {
        const Index u = t[i], v = t[(i + 1) % 3];
        neighbours_[u].insert(v);
        neighbours_[v].insert(u);
        ++uses_[{std::min(u, v), std::max(u, v)}];
      }
    }
  }

  ExtremaCount count() const {
    ExtremaCount result;
    for (const auto& [v, around] : neighbours_) {
      const auto lower = [&, v = v](Index u) { return key(u) < key(v); };
      const auto higher = [&, v = v](Index u) { return key(u) > key(v); };
      if (std::none_of(around.begin(), around.end(), lower)) add(result.minima, is_boundary(v));
      if (std::none_of(around.begin(), around.end(), higher)) add(result.maxima, is_boundary(v));
    }
    count_pits(result.pits);
    return result;
  }

 private:
  std::tuple<double, double, double> key(Index v) const {
    return {points_.z[v], points_.xy[v].x, points_.xy[v].y};
  }
  static void add(SplitCount& count, bool boundary) {
    ++(boundary ? count.boundary : count.interior);
  }
  bool is_boundary(Index v) const {
    return std::any_of(uses_.begin(), uses_.end(), [v](const auto& use) {
      return use.second == 1 && (use.first.first == v || use.first.second == v);
    });
  }
  void count_pits(SplitCount& pits) const {
    std::set<Index> seen;
    for (const auto& [start, unused] : neighbours_) {
      if (seen.contains(start)) continue;
      std::vector<Index> level{start};
      seen.insert(start);
      bool deeper = false, boundary = false;
      for (std::size_t i = 0; i < level.size(); ++i) {
        const Index v = level[i];
        boundary = boundary || is_boundary(v);
        for (const Index u : neighbours_.at(v)) {
          deeper = deeper || points_.z[u] < points_.z[v];
          if (points_.z[u] == points_.z[v] && seen.insert(u).second) level.push_back(u);
        }
      }
      if (!deeper) add(pits, boundary);
    }
  }

  const PointSet& points_;
  std::map<Index, std::set<Index>> neighbours_;
  std::map<std::pair<Index, Index>, int> uses_;
};

/// A grid of width x height vertices with some triangles missing and vertex numbers shuffled.
std::pair<PointSet, Triangles> patchy_grid(Index width, Index height, int levels,
                                           std::mt19937& random) {
  PointSet points;
  std::vector<Index> number(width * height);
  for (Index v = 0; v < number.size(); ++v) number[v] = v;
  std::shuffle(number.begin(), number.end(), random);
  points.xy.resize(number.size());
  for (Index v = 0; v < number.size(); ++v) {
    points.xy[number[v]] = {static_cast<double>(v % width), static_cast<double>(v / width)};
    points.z.push_back(static_cast<double>(random() % levels));
  }
  Triangles triangles;
  for (Index y = 0; y + 1 < height; ++y) {
    for (Index x = 0; x + 1 < width; ++x) {
      const Index a = number[y * width + x], b = number[y * width + x + 1];
      const Index c = number[(y + 1) * width + x], d = number[(y + 1) * width + x + 1];
      if (random() % 8) triangles.push_back({a, b, d});
      if (random() % 8) triangles.push_back({d, c, a});
    }
  }
  std::shuffle(triangles.begin(), triangles.end(), random);
  return {points, triangles};
}

TEST(Extrema, AgreesWithTheDefinitionsOnPatchyGrids) {
  std::mt19937 random(1);
  for (int round = 0; round < 2000; ++round) {
    const int levels = 1 + static_cast<int>(random() % 6);
    const auto [points, triangles] =
        patchy_grid(2 + random() % 7, 2 + random() % 7, levels, random);
    const ExtremaCount expected = BruteForce(points, triangles).count();
    const ExtremaCount counted = count_extrema(points, triangles);
    ASSERT_EQ(counted, expected) << "round " << round;
  }
}

TEST(Extrema, CountsASinglePyramid) {
  PointSet points;
  points.xy = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}, {9, 9}};
  points.z = {1, 1, 1, 1, 0, -5};
  const Triangles triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  ExtremaCount counted = count_extrema(points, triangles);
  EXPECT_EQ(counted.minima, (SplitCount{1, 0}));
  EXPECT_EQ(counted.maxima, (SplitCount{0, 1}));  // (2, 2) is the highest of the equal corners
  EXPECT_EQ(counted.pits, (SplitCount{1, 0}));
  points.z[4] = 1;
  counted = count_extrema(points, triangles);
  EXPECT_EQ(counted.minima, (SplitCount{0, 1}));
  EXPECT_EQ(counted.pits, (SplitCount{0, 1}));
}

TEST(Extrema, NoTrianglesNoExtrema) {
  PointSet points;
  points.xy = {{0, 0}};
  points.z = {1};
  EXPECT_EQ(count_extrema(points, {}), ExtremaCount{});
}

TEST(Extrema, EqualPointsAreNeitherLowerNorHigher) {
  PointSet points;
  points.xy = {{0, 0}, {0, 0}, {1, 1}};
  points.z = {0, 0, 0};
  const Triangles triangles = {{0, 1, 2}};
  EXPECT_EQ(count_extrema(points, triangles).minima.total(), 2u);
  EXPECT_EQ(count_extrema(points, triangles).pits.total(), 1u);
}

}  // namespace
}  // namespace hodt
