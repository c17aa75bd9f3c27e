#include "hodt/optimize/extrema/remove_extrema.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <numeric>
#include <string>
#include <vector>

#include "../support/terrains.h"
#include "solution_check.h"
#include <gtest/gtest.h>

#include "hodt/base/buffer.h"
#include "hodt/base/parallel.h"
#include "hodt/geometry/heights.h"

namespace hodt {
namespace {

constexpr std::array kObjectives{Objective::min_local_minima, Objective::min_local_maxima,
                                 Objective::min_local_extrema};

ExtremaSolution solve(const Terrain& terrain, Index k,
                      Objective objective = Objective::min_local_minima,
                      Method method = Method::automatic) {
  return remove_extrema({.graph = terrain.graph,
                         .z = terrain.z(),
                         .order = k,
                         .objective = objective,
                         .method = method});
}

/// How many extrema have, among all useful edges up to order k, none that removes them. By the
/// oracle: no bound needs to be lower, and these stay in any triangulation of order k.
std::size_t hopeless(const oracle::Instance& instance, int k, Objective objective) {
  std::size_t minima = 0, maxima = 0;
  for (int u = 0; u < instance.size(); ++u) {
    bool lower = false, higher = false;
    for (int v = 0; v < instance.size(); ++v) {
      if (u == v) continue;
      const auto order = instance.useful_order_by_lemma(u, v);
      if (!order || *order > k) continue;
      (instance.is_lower(v, u) ? lower : higher) = true;
    }
    minima += !lower;
    maxima += !higher;
  }
  return (counts_minima(objective) ? minima : 0) + (counts_maxima(objective) ? maxima : 0);
}

class RemoveExtrema : public testing::TestWithParam<families::Family> {};

TEST_P(RemoveExtrema, at_any_order_by_any_method) {
  const bool slow = GetParam().name == "wide_range";
  for (const int n : {5, 10, 22, 36}) {
    if (slow && n > 10) continue;
    const families::Points points = GetParam().make(n, n + 3);
    for (const auto& heights : families::all_heights()) {
      const Terrain terrain(support::to_point_set(points, heights.make(points, n)));
      const oracle::Instance instance(support::to_oracle(terrain.graph.xy),
                                      oracle::Heights(terrain.z().begin(), terrain.z().end()));
      for (const Objective objective : kObjectives) {
        std::size_t last_bound = terrain.z().size();
        for (const Index k : {0, 1, 2, 3, 5, 8, 40}) {
          const ExtremaSolution best = solve(terrain, k, objective);
          const ExtremaSolution greedy = solve(terrain, k, objective, Method::greedy);
          const auto what = [&] {
            return std::string(name_of(objective)) + " k " + std::to_string(k) + ' ' +
                   terrain.source();
          };
          ASSERT_EQ(problem(terrain, best, k, objective), "") << what();
          ASSERT_EQ(problem(terrain, greedy, k, objective), "") << what();
          ASSERT_LE(best.result, greedy.result) << what();
          const ExtremaSolution flips = solve(terrain, k, objective, Method::flip);
          ASSERT_EQ(problem(terrain, flips, k, objective), "") << what();
          ASSERT_LE(flips.bound, best.result) << what();
          // Each quadrilateral of order 1 gets the diagonal that Theorem 3 takes.
          ASSERT_TRUE(k != 1 || objective == Objective::min_local_extrema ||
                      flips.result == best.result)
              << what();
          ASSERT_GE(best.bound, greedy.bound) << what();
          ASSERT_GE(best.bound, hopeless(instance, int(k), objective)) << what();
          ASSERT_LE(best.bound, last_bound) << what();
          last_bound = best.bound;
          ASSERT_TRUE(k > 0 || support::same_arrays(best.change.applied_to(terrain.delaunay.mesh),
                                                    terrain.delaunay.mesh))
              << what();
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, RemoveExtrema, testing::ValuesIn(families::all()),
                         [](const auto& each) { return each.param.name; });

TEST(RemoveExtremaKeep, by_any_method) {
  const support::Points points = support::uniform(800, 4);
  const Terrain terrain(points, support::rough_heights(points, 1, 2));
  const auto is_minimum = [&](const TriangleMesh& mesh, Index v) {
    const Heights heights{terrain.graph.xy, terrain.z()};
    bool is = true;
    for (Index h = 0; h < mesh.halfedge_count(); ++h) {
      const VertexId a = mesh.origin(HalfEdgeId(h)), b = mesh.target(HalfEdgeId(h));
      if (a == v) is &= heights.lower(a, b);
      if (b == v) is &= heights.lower(b, a);
    }
    return is;
  };
  Buffer<bool> keep(points.size(), false);
  std::vector<Index> kept;
  for (Index v = 0; v < points.size(); ++v)
    if (v % 2 == 0 && is_minimum(terrain.delaunay.mesh, v)) {
      keep[v] = true;
      kept.push_back(v);
    }
  ASSERT_GT(kept.size(), 10u);
  for (const Objective objective : {Objective::min_local_minima, Objective::min_local_extrema})
    for (const Method method : {Method::automatic, Method::greedy, Method::flip, Method::exact}) {
      const auto solution = remove_extrema({.graph = terrain.graph,
                                            .z = terrain.z(),
                                            .order = 4,
                                            .objective = objective,
                                            .method = method,
                                            .keep = keep});
      EXPECT_EQ(problem(terrain, solution, 4, objective), "");
      EXPECT_LT(solution.result, solution.delaunay);
      const TriangleMesh mesh = solution.change.applied_to(terrain.delaunay.mesh);
      for (const Index v : kept) EXPECT_TRUE(is_minimum(mesh, v)) << name_of(objective);
    }
}

// ---- Against the optimum ----

/// Theorem 3: minima alone, or maxima alone, are optimal at first order.
TEST(RemoveExtremaFirstOrder, minima_are_as_few_as_possible) {
  std::vector<families::Points> sets{families::lattice(4, 4), families::lattice(2, 8),
                                     families::lattice(5, 3)};
  for (const auto& family : families::all())
    for (const int n : {8, 12}) sets.push_back(family.make(n, 90));
  for (const families::Points& points : sets) {
    oracle::Instance instance(points);
    const oracle::Catalogue catalogue(instance, 1);
    for (const auto& heights : families::all_heights()) {
      for (int seed = 0; seed < 4; ++seed) {
        instance.set_heights(heights.make(points, seed));
        const oracle::Optima optima = catalogue.optima(instance);
        const Terrain terrain(support::to_point_set(points, instance.heights()));
        const auto minima = solve(terrain, 1, Objective::min_local_minima);
        const auto maxima = solve(terrain, 1, Objective::min_local_maxima);
        ASSERT_EQ(int(minima.result), oracle::Optima::at(optima.minima, 1)) << terrain.source();
        ASSERT_EQ(int(maxima.result), oracle::Optima::at(optima.maxima, 1)) << terrain.source();
        ASSERT_EQ(minima.bound, minima.result);
        ASSERT_EQ(maxima.bound, maxima.result);
      }
    }
  }
}

/// A third of all orders of seven heights: never better than the optimum, and seldom worse.
TEST(RemoveExtremaSmall, permutations_of_heights) {
  int cases = 0, optimal = 0, round = 0;
  for (const families::Points& points :
       {families::random_square(7, 1), families::lattice_subset(7, 2, 3),
        families::convex_ellipse(7, 3), families::ring(7, 4, 25, true)}) {
    oracle::Instance instance(points);
    const oracle::Catalogue catalogue(instance);
    families::Heights z(7);
    std::iota(z.begin(), z.end(), 0);
    do {
      if (++round % 3 != 0) continue;
      instance.set_heights(z);
      const oracle::Optima optima = catalogue.optima(instance);
      const Terrain terrain(support::to_point_set(points, z));
      for (const int k : {1, 2, 3}) {
        const ExtremaSolution solution = solve(terrain, Index(k));
        ASSERT_EQ(problem(terrain, solution, Index(k), Objective::min_local_minima), "")
            << terrain.source();
        const int optimum = oracle::Optima::at(optima.minima, k);
        ASSERT_GE(int(solution.result), optimum) << terrain.source();
        ASSERT_LE(int(solution.bound), optimum) << terrain.source();
        ++cases;
        optimal += int(solution.result) == optimum;
      }
    } while (std::next_permutation(z.begin(), z.end()));
  }
  EXPECT_GE(optimal, 0.99 * cases);
}

// ---- Laws ----

/// Without ties, maxima are minima upside down: the very same mesh.
TEST(RemoveExtremaLaws, maxima_are_the_minima_of_negated_heights) {
  for (const support::Points& points :
       {support::uniform(3000, 1), support::lattice(55, 55), support::clustered(3000, 2)}) {
    families::Random random(3);
    std::vector<double> z, negated;
    for (std::size_t i = 0; i < points.size(); ++i) z.push_back(random.real(-1, 1));
    for (const double height : z) negated.push_back(-height);
    const Terrain upright(points, z), turned(points, negated);
    for (const Index k : {1, 3, 6}) {
      ASSERT_TRUE(same(solve(upright, k, Objective::min_local_maxima),
                       solve(turned, k, Objective::min_local_minima)));
      const auto both = solve(upright, k, Objective::min_local_extrema);
      const auto both_turned = solve(turned, k, Objective::min_local_extrema);
      ASSERT_EQ(both.bound, both_turned.bound);
      ASSERT_EQ(both.delaunay, both_turned.delaunay);
    }
  }
}

/// With ties x and y must be turned as well; then the numbering differs, and with it the search.
TEST(RemoveExtremaLaws, with_ties_the_plane_is_turned_too) {
  const support::Points points = support::uniform(3000, 5);
  support::Points opposite;
  for (const Point& p : points) opposite.push_back({-p.x, -p.y});
  families::Random random(6);
  std::vector<double> z, negated;
  for (std::size_t i = 0; i < points.size(); ++i) z.push_back(random.integer(0, 3));
  for (const double height : z) negated.push_back(-height);
  const Terrain upright(points, z), turned(opposite, negated);
  for (const Index k : {0, 1, 2, 4, 8}) {
    const auto maxima = solve(upright, k, Objective::min_local_maxima);
    const auto minima = solve(turned, k, Objective::min_local_minima);
    EXPECT_EQ(maxima.delaunay, minima.delaunay);
    EXPECT_EQ(maxima.bound, minima.bound);
    EXPECT_LE(std::max(maxima.result, minima.result) - std::min(maxima.result, minima.result),
              k <= 1 ? 0 : 1 + maxima.result / 100);
  }
}

/// Only the order of heights counts.
TEST(RemoveExtremaLaws, heights_may_be_stretched) {
  const support::Points points = support::uniform(2000, 7);
  const std::vector<double> z = support::rough_heights(points, 1, 8);
  std::vector<double> stretched;
  for (const double height : z) stretched.push_back(height * height * height - 1e9);
  for (const Index k : {1, 4})
    EXPECT_TRUE(same(solve(Terrain(points, z), k), solve(Terrain(points, stretched), k)));
}

TEST(RemoveExtremaLaws, input_order_and_threads_do_not_matter) {
  for (const support::Points& points : {support::uniform(5000, 9), support::lattice(70, 70)}) {
    PointSet set{points, support::rough_heights(points, 2, 10)};
    std::vector<Index> order(points.size());
    std::iota(order.begin(), order.end(), Index{0});
    families::Random(11).shuffle(order);
    PointSet moved;
    for (const Index i : order) {
      moved.xy.push_back(set.xy[i]);
      moved.z.push_back(set.z[i]);
    }
    for (const Objective objective : kObjectives) {
      const auto run = [&](const PointSet& input, std::size_t threads) {
        const ThreadLimit limit(threads);
        return solve(Terrain(input), 5, objective);
      };
      const ExtremaSolution first = run(set, 1);
      ASSERT_TRUE(same(first, run(set, 2)));
      ASSERT_TRUE(same(first, run(moved, 2)));
    }
  }
}

TEST(RemoveExtremaLaws, an_extremum_with_no_way_out_stays) {
  // One cone: its tip is the only minimum, and no triangulation can do without.
  const support::Points points = support::lattice(20, 20);
  std::vector<double> z;
  for (const Point& p : points) z.push_back((p.x - 7) * (p.x - 7) + (p.y - 9) * (p.y - 9));
  const ExtremaSolution solution = solve(Terrain(points, z), 8);
  EXPECT_EQ(solution.delaunay, 1u);
  EXPECT_EQ(solution.result, 1u);
  EXPECT_EQ(solution.bound, 1u);
}

// ---- Terrains ----

TEST(RemoveExtremaLarge, made_terrains) {
  for (const support::Points& points :
       {support::uniform(15000, 12), support::lattice(120, 120), support::utm_lattice(100, 100),
        support::clustered(10000, 13)}) {
    const Terrain terrain(points, support::rough_heights(points, 1, 14));
    for (const Objective objective : kObjectives) {
      for (const Index k : {1, 4, 10}) {
        const ExtremaSolution solution = solve(terrain, k, objective);
        ASSERT_EQ(problem(terrain, solution, k, objective), "");
        ASSERT_LT(solution.result, solution.delaunay);
        ASSERT_EQ(solution.result, solution.bound);
      }
    }
  }
}

/// Points on curves see each other across everything: useful edges that are fine one by one force a
/// higher order together, and some have to go.
TEST(RemoveExtremaCrowded, rings_and_convex_sets) {
  int runs = 0, improved = 0;
  for (const auto& family : families::all()) {
    if (!family.name.starts_with("ring_") && !family.name.starts_with("convex_")) continue;
    for (int seed = 0; seed < 100; ++seed) {
      const families::Points points = family.make(20 + seed % 5 * 20, seed);
      const Terrain terrain(
          support::to_point_set(points, seed % 2 ? families::permutation_heights(points, seed)
                                                 : families::random_heights(points, seed)));
      for (const Objective objective :
           {Objective::min_local_minima, Objective::min_local_extrema}) {
        for (const Index k : {4, 5, 7}) {
          const ExtremaSolution greedy = solve(terrain, k, objective, Method::greedy);
          const ExtremaSolution best = solve(terrain, k, objective);
          ASSERT_EQ(problem(terrain, greedy, k, objective), "") << k << ' ' << terrain.source();
          ASSERT_EQ(problem(terrain, best, k, objective), "") << k << ' ' << terrain.source();
          ASSERT_LE(best.result, greedy.result) << k << ' ' << terrain.source();
          ++runs;
          improved += best.result < greedy.result;
        }
      }
    }
  }
  EXPECT_GT(improved, runs / 100) << "of " << runs << ": the search is of no use";
}

/// White noise: extrema so dense that hulls meet everywhere.
TEST(RemoveExtremaLarge, noise) {
  for (const support::Points& points :
       {support::uniform(8000, 15), support::lattice(90, 90), support::clustered(8000, 16)}) {
    families::Random random(17);
    std::vector<double> z;
    for (std::size_t i = 0; i < points.size(); ++i) z.push_back(random.real());
    const Terrain terrain(points, z);
    for (const Objective objective : kObjectives) {
      for (const Index k : {3, 6, 9}) {
        const ExtremaSolution greedy = solve(terrain, k, objective, Method::greedy);
        ASSERT_EQ(problem(terrain, greedy, k, objective), "") << k;
        const ExtremaSolution best = solve(terrain, k, objective);
        ASSERT_EQ(problem(terrain, best, k, objective), "") << k;
        ASSERT_LE(best.result, greedy.result);
        ASSERT_EQ(best.result, best.bound) << k;
      }
    }
  }
}

/// Where everything may cross everything: the limits on the search end it soon.
TEST(RemoveExtremaLarge, any_order) {
  const support::Points points = support::uniform(500, 18);
  families::Random random(19);
  std::vector<double> z;
  for (std::size_t i = 0; i < points.size(); ++i) z.push_back(random.real());
  const Terrain terrain(points, z);
  for (const Objective objective : kObjectives) {
    const auto start = std::chrono::steady_clock::now();
    const ExtremaSolution best = solve(terrain, 500, objective);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60));
    EXPECT_EQ(problem(terrain, best, 500, objective), "");
    EXPECT_LT(best.result, best.delaunay / 3);
  }
}

class Terrains : public testing::TestWithParam<std::string> {};

TEST_P(Terrains, the_bound_is_met) {
  const auto points = support::terrain_sample(GetParam());
  if (!points) GTEST_SKIP() << support::no_terrain(GetParam());
  const Terrain terrain(*points);
  for (const Objective objective : kObjectives) {
    for (const Index k : {1, 2, 3, 4, 8, 12, 24}) {
      const std::clock_t start = std::clock();
      const ExtremaSolution solution = solve(terrain, k, objective);
      const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
      const std::string what = std::string(name_of(objective)) + " k " + std::to_string(k);
      ASSERT_EQ(problem(terrain, solution, k, objective), "") << what;
      EXPECT_EQ(solution.result, solution.bound) << what;
      EXPECT_LT(seconds, 10) << what;
      EXPECT_LE(solution.result, solve(terrain, k, objective, Method::greedy).result);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Samples, Terrains,
                         testing::Values("whitebox_dem", "jacksboro", "bigtujunga", "swiss_sic97",
                                         "baja_soundings", "lidar_delft_east"),
                         [](const auto& each) { return each.param; });

}  // namespace
}  // namespace hodt
