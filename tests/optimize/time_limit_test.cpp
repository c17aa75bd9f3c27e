// With a time limit every phase ends soon after, whatever the points are, with a triangulation of
// the order and a bound on the right side. Covers base/deadline and optimize/measure/trivial_bound.
#include <algorithm>
#include <cmath>
#include <ctime>
#include <iterator>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include "../support/shapes.h"
#include "solution_check.h"
#include <gtest/gtest.h>

#include "hodt/base/error.h"
#include "hodt/base/parallel.h"
#include "hodt/optimize/measure/trivial_bound.h"
#include "hodt/optimize/optimize.h"
#include "hodt/order/triangulation_order.h"

namespace hodt {
namespace {

using support::Points;

Points around_a_hub(std::size_t n, double roughness) {
  Points points = support::uniform(n, 1);
  for (Point& p : points) {
    const double a = 2 * std::numbers::pi * p.x, radius = 1 + roughness * p.y;
    p = {radius * std::cos(a), radius * std::sin(a)};
  }
  points[0] = {0, 0};
  return points;
}

Points star(std::size_t n) {
  return around_a_hub(n, 0.001);
}

Points wheel(std::size_t n) {
  return around_a_hub(n, 0);
}

Points two_hubs(std::size_t n) {
  Points points = support::uniform(n, 2);
  for (Point& p : points) p = {p.x - 0.5, 1e-9 * p.y};
  points[0] = {0, 1e3};
  points[1] = {0, -1e3};
  return points;
}

Points parabola(std::size_t n) {
  Points points = support::uniform(n, 3);
  for (Point& p : points) p.y = p.x * p.x;
  return points;
}

Points raster(std::size_t n) {
  const int side = static_cast<int>(std::sqrt(double(n)));
  return support::lattice(side, side);
}

Points uniform(std::size_t n) {
  return support::uniform(n, 4);
}

Points stretched(std::size_t n) {
  Points points = uniform(n);
  for (Point& p : points) p = {1e150 * p.x, 1e-150 * p.y};
  return points;
}

struct Family {
  const char* name;
  Points (*make)(std::size_t);
};

const Family kFamilies[] = {{"uniform", uniform},    {"raster", raster},     {"star", star},
                            {"wheel", wheel},        {"parabola", parabola}, {"two_hubs", two_hubs},
                            {"stretched", stretched}};

const char* const kObjectives[] = {
    "min-local-minima", "min-local-extrema", "min-max-degree",          "min-sum-length",
    "min-max-angle",    "max-min-angle",     "max-sum-circumradius",    "min-sum-abn",
    "min-max-jnd",      "max-sum-jnd",       "max-sum-enclosing-radius"};

Terrain terrain_of(const Family& family, std::size_t n) {
  const Points points = family.make(n);
  std::vector<double> z;
  families::Random random(5);
  for (std::size_t i = 0; i < points.size(); ++i) z.push_back(random.real());
  return {points, z};
}

double processor_seconds() {
  return double(std::clock()) / CLOCKS_PER_SEC;
}

class TimeLimit : public testing::TestWithParam<std::tuple<int, const char*, Index>> {};

/// The processor's time and one thread: what else the machine does is of no account.
TEST_P(TimeLimit, ends_in_time_with_a_valid_result_and_bound) {
  constexpr double kLimit = 0.05, kMore = 1;
  const auto [family, name, order] = GetParam();
  const ThreadLimit one(1);
  Terrain terrain = terrain_of(kFamilies[family], 8000);
  const Objective objective = objective_from_name(name);
  const double before = processor_seconds();
  const Deadline deadline(kLimit);
  terrain.graph.list_neighbours_if_hubs(deadline);
  Optimum optimum;
  try {
    optimum =
        optimize(terrain.graph, terrain.z(), objective, {.order = order, .deadline = deadline});
  } catch (const InputError&) {  // a circumradius is out of a double's range
    EXPECT_EQ(kFamilies[family].make, stretched);
    EXPECT_EQ(name_of(objective), "max-sum-circumradius");
    return;
  }
  EXPECT_LE(processor_seconds() - before, kLimit + kMore);
  const TriangleMesh mesh = optimum.change.applied_to(terrain.delaunay.mesh);
  EXPECT_EQ(connectivity_problem(mesh, Surface::disk), "");
  EXPECT_EQ(embedding_problem(terrain.graph.xy, mesh), "");
  EXPECT_LE(order_histogram(terrain.graph, mesh).size(), std::size_t{order} + 1);
  const auto& [delaunay, result, bound, is_optimal] = optimum.value;
  EXPECT_TRUE(std::isfinite(bound));
  const double slack = 1e-9 * std::fabs(result);
  if (objective.kind == Objective::measured && objective.direction == Direction::maximize) {
    EXPECT_GE(bound, result - slack);
    EXPECT_GE(result, delaunay - slack);
  } else {
    EXPECT_LE(bound, result + slack);
    EXPECT_LE(result, delaunay + slack);
  }
  if (is_optimal) {
    EXPECT_NEAR(bound, result, slack);
  }
}

INSTANTIATE_TEST_SUITE_P(All, TimeLimit,
                         testing::Combine(testing::Range(0, int(std::size(kFamilies))),
                                          testing::ValuesIn(kObjectives),
                                          testing::Values(Index{4}, Index{40}, Index{4000})),
                         [](const auto& each) {
                           std::string name = std::string(kFamilies[std::get<0>(each.param)].name) +
                                              "_" + std::get<1>(each.param) + "_" +
                                              std::to_string(std::get<2>(each.param));
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

// All triangles of a set are within what is certain of any.
TEST(TrivialBound, is_finite_and_worse_than_any_triangulation) {
  for (const Family& family : kFamilies) {
    const Terrain terrain = terrain_of(family, 400);
    for (const char* measure : {"area", "angle", "small-angle", "circumradius", "enclosing-radius",
                                "inradius", "length", "flat-area", "abn", "jnd", "wabn"})
      for (const char* aggregate : {"sum", "max", "min"})
        for (const char* direction : {"min", "max"}) {
          const std::string name = std::string(direction) + "-" + aggregate + "-" + measure;
          SCOPED_TRACE(std::string(family.name) + " " + name);
          const Objective objective = objective_from_name(name);
          const double bound = trivial_bound(objective, terrain.graph.xy, terrain.delaunay.mesh);
          EXPECT_TRUE(std::isfinite(bound));
          Value value;
          try {
            value = optimize(terrain.graph, terrain.z(), objective, {.order = 1}).value;
          } catch (const InputError&) {  // some value is out of a double's range
            EXPECT_EQ(family.make, stretched);
            continue;
          }
          if (objective.direction == Direction::minimize) {
            EXPECT_LE(bound, value.result);
          } else {
            EXPECT_GE(bound, value.result);
          }
        }
  }
}

TEST(TrivialBound, is_far_from_nothing_where_lengths_and_angles_are_minimized) {
  for (const Points& points : {uniform(400), raster(400)}) {
    const Terrain terrain{points, std::vector<double>(points.size(), 0)};
    for (const char* name : {"min-sum-length", "min-max-length", "min-min-length", "min-sum-angle",
                             "min-max-angle", "min-sum-circumradius", "min-sum-enclosing-radius",
                             "min-max-enclosing-radius", "min-min-circumradius"}) {
      SCOPED_TRACE(name);
      const Objective objective = objective_from_name(name);
      const double bound = trivial_bound(objective, terrain.graph.xy, terrain.delaunay.mesh);
      const Value value = optimize(terrain.graph, terrain.z(), objective, {.order = 1}).value;
      EXPECT_LE(bound, value.result);
      EXPECT_GE(bound, 0.05 * value.result);  // slivers at the hull have large circles
    }
  }
}

TEST(TrivialBound, is_what_the_distances_in_a_square_tell) {
  const Terrain square({{0, 0}, {1, 0}, {0, 1}, {1, 1}}, {0, 0, 0, 0});
  const auto bound = [&](const char* name) {
    return trivial_bound(objective_from_name(name), square.graph.xy, square.delaunay.mesh);
  };
  EXPECT_NEAR(bound("min-max-length"), 1, 1e-8);
  EXPECT_NEAR(bound("min-sum-length"), 2, 1e-8);  // four corners, of one triangle each, at a half
  EXPECT_NEAR(bound("min-max-circumradius"), 0.5, 1e-8);
  EXPECT_NEAR(bound("min-sum-angle"), 120, 1e-6);
  EXPECT_EQ(bound("min-sum-inradius"), 0);
}

}  // namespace
}  // namespace hodt
