#include "hodt/delaunay/duplicates.h"

#include <algorithm>
#include <limits>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "hodt/base/error.h"
#include "hodt/delaunay/spatial_order.h"

namespace hodt {
namespace {

constexpr DuplicateRule kRules[] = {DuplicateRule::lowest, DuplicateRule::highest,
                                    DuplicateRule::mean, DuplicateRule::first};

/// The height at each place, by the definition; of `mean` for whole numbers that divide well.
std::map<std::pair<double, double>, double> heights_by_definition(const PointSet& points,
                                                                  DuplicateRule rule) {
  std::map<std::pair<double, double>, std::vector<double>> places;
  for (std::size_t i = 0; i < points.size(); ++i)
    places[{points.xy[i].x, points.xy[i].y}].push_back(points.z[i]);
  std::map<std::pair<double, double>, double> heights;
  for (const auto& [place, z] : places) {
    double sum = 0;
    for (const double height : z) sum += height;
    heights[place] = rule == DuplicateRule::lowest    ? *std::min_element(z.begin(), z.end())
                     : rule == DuplicateRule::highest ? *std::max_element(z.begin(), z.end())
                     : rule == DuplicateRule::first   ? z.front()
                                                      : sum / static_cast<double>(z.size());
  }
  return heights;
}

TEST(Duplicates, TheHeightOfTheRuleIsThatOfTheVertex) {
  std::mt19937 random(5);
  for (int set = 0; set < 200; ++set)
    for (const DuplicateRule rule : kRules) {
      PointSet points;
      const std::size_t size = 3 + random() % 30;
      for (std::size_t i = 0; i < size; ++i) {
        points.xy.push_back({double(random() % 3), double(random() % 3)});
        points.z.push_back(double(int(random() % 9) - 4));
      }
      const PointSet given = points;
      const auto expected = heights_by_definition(given, rule);
      const DuplicateHeights told = settle_duplicates(points, rule);
      const VertexSet vertices = spatial_order(points).vertices;
      ASSERT_EQ(vertices.size(), expected.size());
      std::size_t different = 0;
      double largest = 0;
      for (std::size_t i = 0; i < given.size(); ++i) {
        const double d = std::abs(given.z[i] - expected.at({given.xy[i].x, given.xy[i].y}));
        different += d > 0;
        largest = std::max(largest, d);
      }
      for (std::size_t v = 0; v < vertices.size(); ++v)
        EXPECT_EQ(vertices.z[v], expected.at({vertices.xy[v].x, vertices.xy[v].y}))
            << name_of(rule);
      if (rule == DuplicateRule::lowest) {
        EXPECT_EQ(points.z, given.z) << "the triangulation does it";
        EXPECT_EQ(vertices.duplicate_heights.different, different);
        EXPECT_EQ(vertices.duplicate_heights.largest_difference, largest);
      } else {
        EXPECT_EQ(told.rule, rule);
        EXPECT_EQ(told.different, different);
        EXPECT_EQ(told.largest_difference, largest);
        for (std::size_t v = 0; v < vertices.size(); ++v) {
          const auto first = std::find(given.xy.begin(), given.xy.end(), vertices.xy[v]);
          EXPECT_EQ(vertices.row[v], first - given.xy.begin()) << "the first row stands for all";
        }
      }
    }
}

TEST(Duplicates, AMeanDoesNotDependOnTheOrder) {
  const double big = 1e16, largest = std::numeric_limits<double>::max();
  for (const std::vector<double>& z : {std::vector{big, 1.0, -big}, {1.0, big, -big}}) {
    PointSet points{{{0, 0}, {0, 0}, {0, 0}}, z};
    settle_duplicates(points, DuplicateRule::mean);
    EXPECT_EQ(points.z[0], 1.0 / 3);
  }
  PointSet points{{{0, 0}, {0, 0}}, {largest, largest}};
  settle_duplicates(points, DuplicateRule::mean);
  EXPECT_EQ(points.z[1], largest);
}

TEST(Duplicates, AreAnErrorIfAskedFor) {
  PointSet points{{{1, 1}, {0, 0}, {2, 2}, {2, 2}, {0, 0}}, {1, 2, 3, 3, 5}};
  try {
    settle_duplicates(points, DuplicateRule::error);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("points 1 and 4 (counted from 0)"), std::string::npos)
        << error.what();
  }
  points.z.clear();
  EXPECT_THROW(settle_duplicates(points, DuplicateRule::error), InputError);
  EXPECT_NO_THROW(settle_duplicates(points, DuplicateRule::mean)) << "there are no heights";
  PointSet distinct{{{1, 1}, {0, 0}}, {1, 2}};
  EXPECT_EQ(settle_duplicates(distinct, DuplicateRule::error).different, 0u);
}

TEST(Duplicates, RulesHaveNames) {
  for (const DuplicateRule rule : kRules)
    EXPECT_EQ(duplicate_rule("--duplicates", name_of(rule)), rule);
  EXPECT_EQ(duplicate_rule("--duplicates", "error"), DuplicateRule::error);
  EXPECT_THROW(duplicate_rule("--duplicates", "median"), ParameterError);
}

}  // namespace
}  // namespace hodt
