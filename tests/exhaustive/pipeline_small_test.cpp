// hodt::triangulate against the enumeration of all triangulations of small point sets.
#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "pipeline_check.h"
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "hodt/base/error.h"

namespace exhaustive {
namespace {

using hodt::Objective;
using oracle::Catalogue;
using oracle::Instance;

constexpr std::array kObjectives{Objective::min_local_minima, Objective::min_local_maxima,
                                 Objective::min_local_extrema};
constexpr int kLargestOrder = 4;

/// How often hodt found the optimum, and how often it knew.
struct Tally {
  int cases = 0;
  int improvable = 0;  ///< the optimum is below Delaunay's value
  int at_optimum = 0;
  int bound_tight = 0;
  int proved = 0;
};

class Small : public testing::TestWithParam<families::Family> {
 protected:
  static void TearDownTestSuite() {
    for (const auto& [k, tally] : tallies()) {
      std::cout << "k " << k << ": " << tally.cases << " cases, " << tally.improvable
                << " improvable; optimum found in " << tally.at_optimum << ", bound tight in "
                << tally.bound_tight << ", proved optimal " << tally.proved << "\n";
    }
  }
  static std::map<int, Tally>& tallies() {
    static std::map<int, Tally> all;
    return all;
  }
  static void count(int k, const hodt::Value& value, int optimum) {
    Tally& tally = tallies()[k];
    ++tally.cases;
    tally.improvable += optimum < value.delaunay;
    tally.at_optimum += value.result == optimum;
    tally.bound_tight += value.bound == optimum;
    tally.proved += value.optimal;
  }

  /// Calls test(instance, catalogue, what) for every size and seed.
  template <class Test>
  void for_each_set(int seeds, const Test& test) {
    for (int n = 4; n <= 9; ++n) {
      for (int seed = 0; seed < seeds && !HasFatalFailure(); ++seed) {
        Instance instance(GetParam().make(n, seed));
        const Catalogue catalogue(instance);
        test(instance, catalogue, seed);
      }
    }
  }
};

/// All the checks of one run. Empty if nothing is wrong.
std::string why_wrong(const Instance& instance, const oracle::Triangles& delaunay,
                      const hodt::TriangulateResult& result, Objective objective, int k,
                      std::optional<int> optimum) {
  if (const std::string why = why_not_k_od(instance, result, k); !why.empty()) return why;
  return why_not_value(instance, delaunay, result, objective, k, Expected{optimum});
}

std::string describe(const Instance& instance, Objective objective, int k) {
  return std::string(hodt::name_of(objective)) + " k " + std::to_string(k) + " " +
         to_source(instance);
}

TEST_P(Small, order_0_is_the_delaunay_triangulation) {
  for_each_set(slow() ? 500 : 40, [](Instance& instance, const Catalogue&, int) {
    hodt::TriangulateOptions options;
    options.order = 0;
    options.objective = Objective::none;
    options.tell_orders = true;
    const auto result = triangulate(to_point_set(instance), options);
    ASSERT_EQ(why_not_told(instance, result.tin, true), "");
    ASSERT_EQ(why_not_k_od(instance, result, 0), "") << describe(instance, Objective::none, 0);
    ASSERT_EQ(instance.canonical(to_oracle(result.tin)), instance.delaunay())
        << describe(instance, Objective::none, 0);
    ASSERT_FALSE(result.report.value);
    ASSERT_FALSE(result.report.extrema_delaunay);
    ASSERT_FALSE(result.report.extrema_result);
  });
}

TEST_P(Small, no_better_than_the_optimum_and_no_worse_than_promised) {
  for_each_set(slow() ? 100 : 15, [&](Instance& instance, const Catalogue& catalogue, int seed) {
    const oracle::Triangles delaunay = instance.delaunay();
    for (const auto& heights : families::all_heights()) {
      instance.set_heights(heights.make(instance.points(), seed));
      const hodt::PointSet points = to_point_set(instance);
      const oracle::Optima optima = catalogue.optima(instance);
      for (int k = 0; k <= kLargestOrder; ++k) {
        for (const Objective objective : kObjectives) {
          const int optimum = optimum_of(objective, optima, k);
          const bool tell = seed % 2;
          const auto result = triangulate(
              points, {.order = hodt::Index(k), .objective = objective, .tell_orders = tell});
          ASSERT_EQ(why_not_told(instance, result.tin, tell), "")
              << describe(instance, objective, k);
          ASSERT_EQ(why_wrong(instance, delaunay, result, objective, k, optimum), "")
              << describe(instance, objective, k) << " optimum " << optimum;
          count(k, *result.report.value, optimum);
        }
      }
    }
  });
}

TEST_P(Small, an_order_above_n_is_unrestricted) {
  for_each_set(2, [&](Instance& instance, const Catalogue& catalogue, int seed) {
    instance.set_heights(families::permutation_heights(instance.points(), seed));
    const oracle::Optima optima = catalogue.optima(instance);
    for (const hodt::Index k : {hodt::Index(instance.size()), hodt::Index(1000000)}) {
      for (const Objective objective : kObjectives) {
        const auto result =
            triangulate(to_point_set(instance), {.order = k, .objective = objective});
        ASSERT_EQ(why_wrong(instance, instance.delaunay(), result, objective, int(k),
                            optimum_of(objective, optima, int(k))),
                  "")
            << describe(instance, objective, int(k));
      }
    }
  });
}

TEST_P(Small, every_method) {
  for_each_set(slow() ? 50 : 5, [&](Instance& instance, const Catalogue& catalogue, int seed) {
    instance.set_heights(families::permutation_heights(instance.points(), seed));
    const oracle::Optima optima = catalogue.optima(instance);
    for (const std::string name : {"greedy", "flip", "exact"}) {
      const hodt::Method method = hodt::method_from_name(name);
      // At first order only `automatic` promises the optimum, so these start at second order.
      for (int k = 2; k <= kLargestOrder; ++k) {
        for (const Objective objective : kObjectives) {
          const hodt::TriangulateOptions options{
              .order = hodt::Index(k), .objective = objective, .method = method};
          const auto result = triangulate(to_point_set(instance), options);
          ASSERT_EQ(why_wrong(instance, instance.delaunay(), result, objective, k,
                              optimum_of(objective, optima, k)),
                    "")
              << describe(instance, objective, k) << " method " << name;
        }
      }
    }
  });
}

TEST_P(Small, duplicates_keep_the_lowest) {
  for_each_set(1, [&](Instance& instance, const Catalogue&, int seed) {
    instance.set_heights(families::permutation_heights(instance.points(), seed));
    hodt::PointSet points = to_point_set(instance);
    points.xy.push_back(points.xy[1]);
    points.z.push_back(points.z[1] + 5);
    points.xy.push_back(points.xy[0]);
    points.z.push_back(points.z[0] + 7);
    const auto result = triangulate(points, {.order = 1});
    ASSERT_EQ(result.report.duplicates, 2u);
    ASSERT_EQ(result.report.points, points.size());
    ASSERT_EQ(result.tin.points.z, instance.heights());
    ASSERT_EQ(instance.why_not_triangulation(to_oracle(result.tin)), "");
  });
}

INSTANTIATE_TEST_SUITE_P(Families, Small, testing::ValuesIn(families::all()),
                         [](const auto& each) { return each.param.name; });

// Points of a small lattice, drawn and, on failure, made fewer and simpler.
RC_GTEST_PROP(Lattice, any_points_any_heights, ()) {
  // At rapidcheck's nominal size from the start: smaller ones mean points on a line.
  const auto in_range = [](int low, int high) {
    return rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high));
  };
  const auto n = static_cast<std::size_t>(*in_range(4, 9));
  const auto cells = *rc::gen::unique<std::vector<int>>(n, in_range(0, 36));
  const auto levels = *rc::gen::container<std::vector<int>>(n, in_range(0, 6));
  const int k = *in_range(0, kLargestOrder + 1);
  const Objective objective = *rc::gen::elementOf(kObjectives);
  oracle::Points points;
  for (const int cell : cells) points.emplace_back(cell % 6, cell / 6);
  const Instance instance(points, oracle::Heights(levels.begin(), levels.end()));
  RC_PRE(!instance.all_collinear());
  const int optimum = optimum_of(objective, Catalogue(instance).optima(instance), k);
  const auto result =
      triangulate(to_point_set(instance), {.order = hodt::Index(k), .objective = objective});
  RC_LOG(describe(instance, objective, k));
  RC_ASSERT(why_wrong(instance, instance.delaunay(), result, objective, k, optimum) == "");
}

TEST(Degenerate, no_triangle_is_an_error) {
  const auto run = [](const hodt::PointSet& points) {
    return triangulate(points, {.objective = Objective::none});
  };
  EXPECT_THROW(run({}), hodt::InputError);
  EXPECT_THROW(run({{{0, 0}}, {}}), hodt::InputError);
  EXPECT_THROW(run({{{0, 0}, {1, 0}}, {}}), hodt::InputError);
  EXPECT_THROW(run({{{0, 0}, {1, 0}, {0, 0}, {1, 0}}, {}}), hodt::InputError);
  EXPECT_THROW(run({{{0, 0}, {1, 1}, {2, 2}, {5, 5}}, {}}), hodt::InputError);
  EXPECT_THROW(run({{{0, 0}, {1, 0}, {0, NAN}}, {}}), hodt::InputError);
  EXPECT_THROW(run({{{0, 0}, {1, 0}, {0, INFINITY}}, {}}), hodt::InputError);
}

TEST(Degenerate, an_objective_of_heights_needs_heights) {
  const hodt::PointSet flat{{{0, 0}, {1, 0}, {0, 1}}, {}};
  for (const Objective objective : kObjectives) {
    EXPECT_THROW(triangulate(flat, {.objective = objective}), hodt::ParameterError);
  }
}

}  // namespace
}  // namespace exhaustive
