#include "hodt/optimize/extrema/first_order_extrema.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "solution_check.h"
#include <gtest/gtest.h>

#include "hodt/base/parallel.h"
#include "hodt/geometry/heights.h"
#include "hodt/optimize/extrema/remove_extrema.h"
#include "hodt/order/first_order/first_order.h"

namespace hodt {
namespace {

ExtremaSolution solve(const Terrain& terrain) {
  return minimize_first_order_extrema(terrain.graph, terrain.z());
}

std::string problem(const Terrain& terrain, const ExtremaSolution& solution) {
  if (solution.bound != solution.result) return "the bound is not the result";
  return hodt::problem(terrain, solution, 1, Objective::min_local_extrema);
}

/// The optimum from another algorithm. Every flippable quadrilateral removes one of at most two
/// extrema of the fixed edges: as many are removed as a bipartite matching has edges.
class ByMatching {
 public:
  explicit ByMatching(const Terrain& terrain) : terrain_(terrain) {
    const TriangleMesh& mesh = terrain.graph.mesh;
    const std::size_t n = mesh.vertex_count();
    has_[0].assign(n, false);
    has_[1].assign(n, false);
    const auto flippable = first_order_edges(terrain.graph);
    const auto is_flippable = [&](HalfEdgeId h) {
      return std::binary_search(flippable.begin(), flippable.end(), std::min(h, mesh.twin(h)));
    };
    for (Index i = 0; i < mesh.halfedge_count(); ++i) {
      const HalfEdgeId h(i);
      if (is_flippable(h)) continue;
      const auto [low, high] = ordered(mesh.origin(h), mesh.target(h));
      has_[0][high] = has_[1][low] = true;
    }
    for (const HalfEdgeId h : flippable) {
      serves_.emplace_back();
      add_removed(mesh.origin(h), mesh.target(h));
      add_removed(mesh.apex(h), mesh.apex(mesh.twin(h)));
    }
  }

  std::size_t optimum() {
    const auto extrema = std::count(has_[0].begin(), has_[0].end(), false) +
                         std::count(has_[1].begin(), has_[1].end(), false);
    served_by_.assign(2 * has_[0].size(), kNone);
    std::size_t removed = 0;
    for (Index q = 0; q < serves_.size(); ++q) {
      seen_.assign(serves_.size(), false);
      removed += augment(q);
    }
    return static_cast<std::size_t>(extrema) - removed;
  }

  /// Quadrilaterals whose two diagonals remove different extrema.
  std::size_t arcs() const {
    return static_cast<std::size_t>(std::count_if(
        serves_.begin(), serves_.end(), [](const auto& extrema) { return extrema.size() == 2; }));
  }

 private:
  std::pair<Index, Index> ordered(VertexId a, VertexId b) const {
    const Heights heights{terrain_.graph.xy, terrain_.z()};
    return heights.lower(a, b) ? std::pair<Index, Index>(a, b) : std::pair<Index, Index>(b, a);
  }
  void add_removed(VertexId a, VertexId b) {
    const auto [low, high] = ordered(a, b);
    EXPECT_TRUE(has_[0][high] || has_[1][low]) << "Lemma 7: at most one a diagonal";
    if (!has_[0][high]) serves_.back().push_back(2 * high);
    if (!has_[1][low]) serves_.back().push_back(2 * low + 1);
  }
  bool augment(Index q) {
    if (seen_[q]) return false;
    seen_[q] = true;
    for (const Index extremum : serves_[q]) {
      if (served_by_[extremum] != kNone && !augment(served_by_[extremum])) continue;
      served_by_[extremum] = q;
      return true;
    }
    return false;
  }

  const Terrain& terrain_;
  std::vector<bool> has_[2];  // a lower, a higher neighbour along a fixed edge
  std::vector<std::vector<Index>> serves_;
  std::vector<Index> served_by_;
  std::vector<bool> seen_;
};

/// The least over all triangulations of order 1, for every kind of heights.
void expect_optimal(const families::Points& points, int seeds) {
  oracle::Instance instance(points);
  const oracle::Catalogue catalogue(instance, 1);
  for (const auto& heights : families::all_heights()) {
    for (int seed = 0; seed < seeds; ++seed) {
      instance.set_heights(heights.make(points, seed));
      const Terrain terrain(support::to_point_set(points, instance.heights()));
      const ExtremaSolution solution = solve(terrain);
      ASSERT_EQ(problem(terrain, solution), "") << terrain.source();
      const auto optimum =
          static_cast<std::size_t>(oracle::Optima::at(catalogue.optima(instance).extrema, 1));
      ASSERT_EQ(solution.result, optimum) << terrain.source();
      ASSERT_EQ(ByMatching(terrain).optimum(), optimum) << "the test's own algorithm errs";
    }
  }
}

class FirstOrderExtrema : public testing::TestWithParam<families::Family> {};

TEST_P(FirstOrderExtrema, are_as_few_as_possible) {
  for (const int n : {6, 9, 11, 13})
    for (int seed = 70; seed < 73; ++seed) expect_optimal(GetParam().make(n, seed), 4);
}

INSTANTIATE_TEST_SUITE_P(All, FirstOrderExtrema, testing::ValuesIn(families::all()),
                         [](const auto& each) { return each.param.name; });

/// Every cell is a quadrilateral to choose in: paths, trees and cycles of conflicts.
TEST(FirstOrderExtremaLattice, strips_and_blocks) {
  expect_optimal(families::lattice(2, 3), 60);
  expect_optimal(families::lattice(2, 6), 40);
  expect_optimal(families::lattice(7, 2), 40);
  expect_optimal(families::lattice(3, 3), 60);
  expect_optimal(families::lattice(3, 4), 40);
  expect_optimal(families::lattice(4, 4), 20);
}

/// All heights of three levels on a strip of three cells.
TEST(FirstOrderExtremaLattice, all_heights_of_a_strip) {
  const families::Points strip = families::lattice(4, 2);
  oracle::Instance instance(strip);
  const oracle::Catalogue catalogue(instance, 1);
  for (int code = 0; code < 6561; ++code) {
    families::Heights z;
    for (int i = 0, rest = code; i < 8; ++i, rest /= 3) z.push_back(rest % 3);
    instance.set_heights(z);
    const Terrain terrain(support::to_point_set(strip, z));
    const ExtremaSolution solution = solve(terrain);
    ASSERT_EQ(problem(terrain, solution), "") << terrain.source();
    ASSERT_EQ(solution.result,
              static_cast<std::size_t>(oracle::Optima::at(catalogue.optima(instance).extrema, 1)))
        << terrain.source();
  }
}

TEST(FirstOrderExtremaLattice, all_permutations_of_two_cells) {
  const families::Points strip = families::lattice(3, 2);
  oracle::Instance instance(strip);
  const oracle::Catalogue catalogue(instance, 1);
  families::Heights z(6);
  std::iota(z.begin(), z.end(), 0);
  do {
    instance.set_heights(z);
    const Terrain terrain(support::to_point_set(strip, z));
    const ExtremaSolution solution = solve(terrain);
    ASSERT_EQ(problem(terrain, solution), "") << terrain.source();
    ASSERT_EQ(solution.result,
              static_cast<std::size_t>(oracle::Optima::at(catalogue.optima(instance).extrema, 1)))
        << terrain.source();
  } while (std::next_permutation(z.begin(), z.end()));
}

/// Two quadrilaterals between the same two extrema are a cycle: both can go.
TEST(FirstOrderExtremaCycle, of_two_arcs) {
  const Terrain terrain({{0, 0}, {0, 1}, {1, 0}, {1, 1}, {2, 0}, {2, 1}}, {4, 0, 2, 3, 5, 1});
  const ExtremaSolution solution = solve(terrain);
  EXPECT_EQ(problem(terrain, solution), "");
  EXPECT_EQ(solution.result, 4u);
  EXPECT_EQ(ByMatching(terrain).arcs(), 2u);
}

TEST(FirstOrderExtremaCycle, one_triangle_has_nothing_to_choose) {
  const Terrain terrain({{0, 0}, {1, 0}, {0, 1}}, {0, 0, 0});
  const ExtremaSolution solution = solve(terrain);
  EXPECT_EQ(problem(terrain, solution), "");
  EXPECT_EQ(solution.result, 2u);
}

// ---- Larger sets ----

std::vector<double> heights_of(const support::Points& points, int levels, std::uint64_t seed) {
  families::Random random(seed);
  std::vector<double> z;
  for (std::size_t i = 0; i < points.size(); ++i) z.push_back(random.integer(0, levels));
  return z;
}

TEST(FirstOrderExtremaLarge, equal_a_matching) {
  std::size_t arcs = 0;
  for (const support::Points& points :
       {support::uniform(4000, 1), support::lattice(60, 60), support::lattice(2, 1500),
        support::utm_lattice(60, 60), support::clustered(3000, 2), support::cocircular_rings(20)}) {
    for (const int levels : {1, 4, 1000000}) {
      const Terrain terrain(points, heights_of(points, levels, 3));
      const ExtremaSolution solution = solve(terrain);
      ASSERT_EQ(problem(terrain, solution), "");
      ByMatching matching(terrain);
      ASSERT_EQ(solution.result, matching.optimum());
      arcs += matching.arcs();
      ASSERT_LE(solution.result, remove_extrema({.graph = terrain.graph,
                                                 .z = terrain.z(),
                                                 .order = 1,
                                                 .objective = Objective::min_local_extrema})
                                     .result);
    }
  }
  EXPECT_GT(arcs, 500u) << "the sets are no test of conflicts";
}

TEST(FirstOrderExtremaLarge, threads_do_not_matter) {
  const support::Points points = support::lattice(200, 200);
  const auto run = [&](std::size_t threads) {
    const ThreadLimit limit(threads);
    return solve(Terrain(points, heights_of(points, 50, 4)));
  };
  EXPECT_TRUE(same(run(1), run(2)));
}

}  // namespace
}  // namespace hodt
