// hodt::triangulate on sets too large to enumerate all triangulations, but not those of order 1,
// and on sets where only what it says about its own triangles can be checked.
#include <algorithm>
#include <array>

#include "pipeline_check.h"
#include <gtest/gtest.h>

namespace exhaustive {
namespace {

using hodt::Objective;
using oracle::Catalogue;
using oracle::Instance;

constexpr std::array kObjectives{Objective::min_local_minima, Objective::min_local_maxima,
                                 Objective::min_local_extrema};

class Medium : public testing::TestWithParam<families::Family> {
 protected:
  /// Exact fractions of 2000 bits are slow; such points stay few.
  int at_most(int n) const { return GetParam().name == "wide_range" ? std::min(n, 14) : n; }
  Instance instance(int n, int seed) const { return Instance(GetParam().make(at_most(n), seed)); }
};

TEST_P(Medium, delaunay) {
  for (const int n : {12, 20, 40, 60}) {
    for (int seed = 0; seed < (slow() ? 10 : 1); ++seed) {
      const Instance points = instance(n, seed);
      const auto result =
          triangulate(to_point_set(points), {.order = 0, .objective = Objective::none});
      ASSERT_EQ(points.canonical(to_oracle(result.tin)), points.delaunay()) << to_source(points);
      ASSERT_EQ(result.report.order, 0u);
    }
  }
}

TEST_P(Medium, first_order_is_optimal) {
  for (const int n : {10, 12, 14, 16}) {
    for (int seed = 0; seed < (slow() ? 20 : 3); ++seed) {
      Instance points = instance(n, seed);
      const Catalogue first_order(points, 1);
      for (const auto& heights : families::all_heights()) {
        points.set_heights(heights.make(points.points(), seed));
        const oracle::Optima optima = first_order.optima(points);
        for (const Objective objective : kObjectives) {
          const auto result =
              triangulate(to_point_set(points), {.order = 1, .objective = objective});
          ASSERT_EQ(why_not_k_od(points, result, 1), "") << to_source(points);
          const Expected expected{optimum_of(objective, optima, 1)};
          ASSERT_EQ(why_not_value(points, points.delaunay(), result, objective, 1, expected), "")
              << hodt::name_of(objective) << ' ' << to_source(points);
        }
      }
    }
  }
}

TEST_P(Medium, the_report_is_true_at_any_order) {
  for (const int n : {11, 25, 45}) {
    Instance points = instance(n, 1);
    const oracle::Triangles delaunay = points.delaunay();
    for (const auto& heights : families::all_heights()) {
      points.set_heights(heights.make(points.points(), n));
      for (const Objective objective : kObjectives) {
        double best =
            2 * n;  // of the results so far: each is a triangulation of the next order too
        for (const int k : {0, 1, 2, 3, 4, 6, 8}) {
          const auto result =
              triangulate(to_point_set(points), {.order = hodt::Index(k), .objective = objective});
          ASSERT_EQ(why_not_k_od(points, result, k), "") << "k " << k << ' ' << to_source(points);
          ASSERT_EQ(why_not_value(points, delaunay, result, objective, k, {}), "")
              << hodt::name_of(objective) << " k " << k << ' ' << to_source(points);
          best = std::min(best, result.report.value->result);
          ASSERT_LE(result.report.value->bound, best)
              << hodt::name_of(objective) << " k " << k << ' ' << to_source(points);
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Families, Medium, testing::ValuesIn(families::all()),
                         [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace exhaustive
