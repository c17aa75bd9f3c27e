// Objectives in order, against all triangulations of small sets.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "../support/convert.h"
#include "../support/inner_edges.h"
#include "../support/shapes.h"
#include "../support/terrains.h"
#include "../support/triangulation_problems.h"
#include <gtest/gtest.h>

#include "hodt/base/error.h"
#include "hodt/base/exact_sum.h"
#include "hodt/base/parallel.h"
#include "hodt/base/stop.h"
#include "hodt/geometry/heights.h"
#include "hodt/hydrology/minima_to_keep.h"
#include "hodt/optimize/measure/edge_measures.h"
#include "hodt/optimize/measure/measures.h"
#include "hodt/optimize/optimize.h"
#include "hodt/optimize/value_of.h"
#include "hodt/order/triangulation_order.h"
#include "hodt/pipeline.h"
#include "hodt/pipeline/given_tin.h"
#include "hodt/tin/boundary_edges.h"

namespace hodt {
namespace {

/// Solved at order 1 wherever the choices that hang together are few.
constexpr const char* kLists[] = {
    "min-local-minima,min-sum-abn",
    "min-local-minima,max-sum-small-angle",
    "min-local-minima,min-max-angle",
    "min-local-minima,min-local-maxima",
    "min-local-maxima,min-max-abn",
    "min-local-maxima,max-max-area",
    "min-local-extrema,min-sum-jnd",
    "min-local-extrema,max-min-small-angle,min-sum-wabn",
    "min-sum-flat-area,min-sum-abn",
    "min-sum-length,min-local-extrema",
    "min-max-angle,min-sum-abn",
    "max-min-small-angle,min-local-minima",
    "min-max-abn,min-sum-length",
    "min-max-jnd,max-min-enclosing-radius,min-sum-abn",
    "min-sum-abn,min-local-minima",
    "min-sum-abn,min-sum-length,min-local-maxima",
    "min-local-minima,min-local-maxima,min-sum-abn",
    "min-max-angle,min-local-minima,min-sum-length",
    "min-sum-flat-area,min-local-minima,min-sum-wabn",
    "min-sum-area,min-sum-circumradius,min-local-minima",
};

/// Not solved at order 1: bounds hold whatever is before.
constexpr const char* kOtherLists[] = {
    "min-max-degree,min-local-minima",
    "min-local-extrema,min-max-degree,min-sum-abn",
    "min-min-angle,min-sum-length",
    "max-max-abn,min-local-minima",
};

/// What an objective makes of a triangulation; of a sum also without rounding.
struct Measured {
  double value;
  ExactSum sum;
};

Measured measured(const Objective& objective, const TriangleMesh& mesh, const Delaunay& d) {
  Measured measured{value_of(objective, mesh, d.vertices.xy, d.vertices.z), {}};
  if (objective.kind != Objective::measured || objective.aggregate != Aggregate::sum)
    return measured;
  if (is_of_edges(objective)) {
    const EdgeValues values(objective, d.vertices.xy, d.vertices.z);
    for_each_inner_edge(mesh, [&](HalfEdgeId h) { measured.sum.add(values.of(mesh, h)); });
    return measured;
  }
  const TriangleValues values(objective, d.vertices.xy, d.vertices.z);
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.corners(TriangleId(t));
    measured.sum.add(values.of(a, b, c));
  }
  return measured;
}

bool is_worse(const Objective& objective, const Measured& a, const Measured& b) {
  if (objective.kind != Objective::measured || objective.aggregate != Aggregate::sum)
    return is_better(objective, b.value, a.value);
  ExactSum difference = a.sum;
  difference.subtract(b.sum);
  return objective.direction == Direction::minimize ? difference.nearest() > 0
                                                    : difference.nearest() < 0;
}

/// All triangulations of a small set.
class BruteForce {
 public:
  BruteForce(const Delaunay& delaunay, std::span<const Objective> objectives)
      : objectives_(objectives.begin(), objectives.end()) {
    const oracle::Instance instance(support::to_oracle(delaunay.vertices.xy));
    oracle::for_each_triangulation(
        instance, kMostOrder, [&](const oracle::Triangles& triangles, int order) {
          std::vector<std::array<Index, 3>> corners;
          for (const auto& [a, b, c] : triangles) corners.push_back({Index(a), Index(b), Index(c)});
          const TriangleMesh mesh = support::make_mesh(delaunay.vertices.size(), corners);
          Entry entry{order, {}};
          for (const Objective& objective : objectives_)
            entry.measured.push_back(measured(objective, mesh, delaunay));
          all_.push_back(std::move(entry));
        });
  }

  static constexpr int kMostOrder = 3;

  /// The best value of objective i among the triangulations of order k that are as good as this
  /// for the objectives before.
  double best(int k, std::size_t i, std::span<const Measured> before) const {
    std::optional<double> best;
    for (const Entry& entry : all_) {
      if (entry.order > k) continue;
      bool keeps = true;
      for (std::size_t j = 0; j < before.size(); ++j)
        keeps &= !is_worse(objectives_[j], entry.measured[j], before[j]);
      const double value = entry.measured[i].value;
      if (keeps && (!best || is_better(objectives_[i], value, *best))) best = value;
    }
    return best.value();
  }

 private:
  struct Entry {
    int order;
    std::vector<Measured> measured;
  };
  std::vector<Objective> objectives_;
  std::vector<Entry> all_;
};

class InOrderFamilies : public testing::TestWithParam<families::Family> {
 protected:
  /// Of doubles whose rounding leaves nothing of what is measured.
  static bool is_measurable() {
    const std::string& name = GetParam().name;
    return name != "wide_range" && name != "subnormal_lattice";
  }
};

TEST_P(InOrderFamilies, against_all_triangulations) {
  if (!is_measurable()) GTEST_SKIP();
  std::size_t solved = 0, asked = 0;
  for (const int n : {5, 7, 8}) {
    for (const auto& heights : families::all_heights()) {
      const auto points = GetParam().make(n, std::uint64_t(n));
      const Delaunay d = delaunay(support::to_point_set(points, heights.make(points, 3)));
      const DelaunayGraph graph(d);
      for (const bool is_solvable : {true, false})
        for (const char* list : is_solvable ? std::span<const char* const>(kLists)
                                            : std::span<const char* const>(kOtherLists)) {
          const std::vector<Objective> objectives = objectives_from_names(list);
          const BruteForce all(d, objectives);
          for (int k = 0; k <= BruteForce::kMostOrder; ++k) {
            const std::string what = std::string(list) + " k = " + std::to_string(k) + ' ' +
                                     support::to_source(d.vertices.xy, d.vertices.z);
            const OptimizeOptions options{.order = Index(k)};
            const OrderedOptimum found =
                optimize_in_order(graph, d.vertices.z, objectives, options);
            const TriangleMesh mesh = found.change.applied_to(d.mesh);
            ASSERT_EQ(order_problem(graph, mesh, Index(k)), "") << what;
            std::vector<Measured> values;
            for (const Objective& objective : objectives)
              values.push_back(measured(objective, mesh, d));
            const Value first = optimize(graph, d.vertices.z, objectives[0], options).value;
            ASSERT_FALSE(is_better(objectives[0], first.result, found.value.result)) << what;
            for (std::size_t i = 0; i < objectives.size(); ++i) {
              const Value& value = i == 0 ? found.value : found.then[i - 1].value;
              const bool in_order = i > 0 && found.then[i - 1].is_bound_in_order;
              ASSERT_EQ(value.result, values[i].value) << what;
              const std::span<const Measured> before{values.data(), i};
              const double best = all.best(k, i, before);
              ASSERT_FALSE(is_better(objectives[i], value.result, best)) << what;
              const double most = in_order ? best : all.best(k, i, {});
              ASSERT_FALSE(is_better(objectives[i], most, value.bound)) << what;
              if (value.optimal) {
                ASSERT_NEAR(value.result, best, 1e-9 * std::fabs(best)) << what;
              }
              if (k == 1 && is_solvable && i > 0) {
                ++asked;
                solved += in_order;
                ASSERT_TRUE(!in_order || value.optimal) << what;
              }
            }
          }
        }
    }
  }
  // What rounding leaves of slopes that are equal can have bits that span too much.
  EXPECT_GE(solved, asked - asked / 50);
}

INSTANTIATE_TEST_SUITE_P(All, InOrderFamilies, testing::ValuesIn(families::all()),
                         [](const auto& each) { return each.param.name; });

PointSet rough_terrain(std::size_t n, std::uint64_t seed) {
  const support::Points points = support::uniform(n, seed);
  return {points, support::rough_heights(points, 1, seed)};
}

TriangulateOptions options_of(const char* list, Index k) {
  std::vector<Objective> objectives = objectives_from_names(list);
  return {.order = k,
          .objective = objectives.front(),
          .then = {objectives.begin() + 1, objectives.end()}};
}

bool same_triangles(const TriangulateResult& a, const TriangulateResult& b) {
  return a.tin.triangles == b.tin.triangles;
}

/// Of many points, what small sets do not have: regions that differ, and parts of many choices.
TEST(InOrder, keeps_the_first_and_betters_the_second) {
  const PointSet points = rough_terrain(2000, 7);
  const Delaunay d = delaunay(points);
  const DelaunayGraph graph(d);
  for (const char* list : {"min-local-minima,min-sum-abn", "min-local-extrema,max-sum-small-angle",
                           "min-max-abn,min-sum-length", "min-max-degree,min-sum-abn"})
    for (const Index k : {1u, 2u, 4u, 8u}) {
      const std::vector<Objective> objectives = objectives_from_names(list);
      const OptimizeOptions options{.order = k};
      const OrderedOptimum both = optimize_in_order(graph, d.vertices.z, objectives, options);
      const Optimum first = optimize(graph, d.vertices.z, objectives[0], options);
      const Value second = optimize(graph, d.vertices.z, objectives[1], options).value;
      const LaterValue& later = both.then[0];
      EXPECT_FALSE(is_better(objectives[0], first.value.result, both.value.result)) << list << k;
      EXPECT_EQ(both.value.bound, first.value.bound);
      EXPECT_FALSE(is_better(objectives[1], later.value.result, second.bound)) << list << k;
      EXPECT_EQ(later.value.delaunay, second.delaunay);
      const double before =
          value_of(objectives[1], first.change.applied_to(d.mesh), d.vertices.xy, d.vertices.z);
      EXPECT_TRUE(is_better(objectives[1], later.value.result, before)) << list << k;
      EXPECT_EQ(order_problem(graph, both.change.applied_to(d.mesh), k), "");
    }
}

TEST(InOrder, is_the_same_on_any_number_of_threads) {
  const PointSet points = rough_terrain(12000, 3);  // more than one block of flips
  for (const char* list : {"min-local-minima,min-sum-abn", "min-max-angle,min-local-extrema"})
    for (const Index k : {1u, 4u}) {
      const TriangulateOptions options = options_of(list, k);
      const TriangulateResult many = triangulate(points, options);
      const ThreadLimit limit(1);
      EXPECT_TRUE(same_triangles(triangulate(points, options), many)) << list << k;
    }
}

TEST(InOrder, one_objective_is_as_ever) {
  const PointSet points = rough_terrain(500, 3);
  const Delaunay d = delaunay(points);
  const DelaunayGraph graph(d);
  const Objective objective = objective_from_name("min-sum-abn");
  const Optimum alone = optimize(graph, d.vertices.z, objective, {.order = 3});
  const OrderedOptimum found =
      optimize_in_order(graph, d.vertices.z, {&objective, 1}, {.order = 3});
  EXPECT_TRUE(found.then.empty());
  EXPECT_EQ(found.value.bound, alone.value.bound);
  EXPECT_TRUE(
      support::same_arrays(found.change.applied_to(d.mesh), alone.change.applied_to(d.mesh)));
}

TEST(InOrder, a_time_limit_leaves_valid_bounds) {
  const PointSet points = rough_terrain(2000, 5);
  for (const Index k : {1u, 4u})
    for (const double seconds : {1e-9, 0.02, 0.1}) {
      TriangulateOptions options = options_of("min-local-minima,min-sum-abn", k);
      options.time_limit = seconds;
      const Report report = triangulate(points, options).report;
      EXPECT_LE(report.value->bound, report.value->result);
      EXPECT_LE(report.then[0].value.bound, report.then[0].value.result);
      EXPECT_LE(report.value->result, report.value->delaunay);
    }
}

TEST(InOrder, stops_when_told) {
  const PointSet points = rough_terrain(2000, 5);
  std::atomic<bool> flag = true;
  const StopOn stop(&flag);
  EXPECT_THROW(triangulate(points, options_of("min-local-minima,min-sum-abn", 4)), Stopped);
}

TEST(InOrder, minima_to_keep_stay) {
  const PointSet points = rough_terrain(1500, 9);
  for (const char* list : {"min-local-minima,min-sum-abn", "min-local-extrema,min-sum-length"})
    for (const Index k : {1u, 4u}) {
      TriangulateOptions options = options_of(list, k);
      options.min_pit_depth = 0.2;
      const TriangulateResult result = triangulate(points, options);
      ASSERT_GT(result.report.kept, 0u);
      const Delaunay d = delaunay(points);
      const MinimaToKeep keep =
          minima_to_keep(DelaunayGraph(d), d.vertices.z, options.min_pit_depth, {});
      std::vector<bool> has_lower(points.size(), false);
      const Heights heights{points.xy, points.z};
      for (const auto& t : result.tin.triangles)
        for (const Index u : t)
          for (const Index v : t)
            if (u != v && heights.lower(VertexId(v), VertexId(u))) has_lower[u] = true;
      for (Index v = 0; v < d.vertices.size(); ++v)
        if (keep.is_kept[v]) {
          EXPECT_FALSE(has_lower[d.vertices.row[v]]) << list << k;
        }
    }
  TriangulateOptions options = options_of("min-sum-abn,min-local-minima", 2);
  options.min_pit_depth = 0.2;
  EXPECT_THROW(triangulate(points, options), ParameterError);
}

/// Walls stay, nothing is outside, and a mesh that is there already is never better.
TEST(InOrder, with_constraints_and_given_meshes) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const PointSet points = rough_terrain(80, seed);
    Tin tin =
        triangulate(points, {.order = 3, .objective = objective_from_name("max-sum-length")}).tin;
    tin.triangles.erase(tin.triangles.begin() + 40);
    const GivenTin given = given_tin(tin);
    for (const char* list : {"min-local-minima,min-sum-abn", "min-max-angle,min-sum-length",
                             "min-sum-abn,min-local-extrema,min-max-degree"})
      for (const Index k : {1u, 4u}) {
        const TriangulateOptions options = options_of(list, k);
        const TriangulateResult result = triangulate(given.points, options, given.constraints);
        EXPECT_EQ(boundary_edges(result.tin.triangles), given.constraints.boundary);
        EXPECT_LE(result.report.order, k);
        const TriangulateResult again =
            triangulate(result.tin.points, options, given_tin(result.tin).constraints);
        const auto values = [](const Report& report) {
          std::vector<double> all{report.value->result};
          for (const LaterValue& later : report.then) all.push_back(later.value.result);
          return all;
        };
        const auto is_worse = [&](const std::vector<double>& a, const std::vector<double>& b) {
          for (std::size_t i = 0; i < a.size(); ++i)
            if (a[i] != b[i])
              return is_better(i == 0 ? options.objective : options.then[i - 1], b[i], a[i]);
          return false;
        };
        EXPECT_FALSE(is_worse(values(again.report), values(result.report))) << list << k;
        ASSERT_EQ(again.report.given->then.size(), options.then.size());
        EXPECT_EQ(again.report.given->then[0], result.report.then[0].value.result);
      }
  }
}

TEST(InOrder, terrain_stands_for_a_list) {
  EXPECT_EQ(objectives_from_names("terrain"),
            objectives_from_names("min-local-minima,min-sum-abn"));
  EXPECT_EQ(usual_order("terrain"), 8u);
  EXPECT_EQ(usual_order("min-local-minima,min-sum-abn"), 4u);
  EXPECT_EQ(usual_order("min-local-minima"), 4u);
}

TEST(InOrder, what_cannot_be_asked_for) {
  const PointSet points = rough_terrain(50, 1);
  for (const char* list :
       {"min-local-minima,min-local-minima", "none,min-sum-abn", "min-sum-abn,none",
        "min-sum-abn,beauty", "terrain,min-sum-length", "min-sum-length,terrain", "min-sum-abn,",
        ",min-sum-abn", "min-sum-abn,min-sum-jnd,min-sum-wabn,min-local-minima"})
    EXPECT_THROW(objectives_from_names(list), ParameterError) << list;
  TriangulateOptions options = options_of("min-sum-abn,min-local-minima", 2);
  options.then.push_back(options.objective);
  EXPECT_THROW(triangulate(points, options), ParameterError);
  options = options_of("min-local-minima,min-sum-abn", 2);
  options.method = Method::greedy;
  EXPECT_THROW(triangulate(points, options), ParameterError);
  options = options_of("min-sum-length,min-sum-abn", 2);
  EXPECT_THROW(triangulate({points.xy, {}}, options), ParameterError);
  const Delaunay d = delaunay(points);
  EXPECT_THROW(optimize_in_order(DelaunayGraph(d), d.vertices.z, {}), ParameterError);
}

/// As good as the second objective alone, but for 2 %, wherever the first leaves a choice.
TEST(InOrder, is_near_the_second_alone_on_real_terrain) {
  bool any = false;
  for (const char* name : {"whitebox_dem", "jacksboro", "swiss_sic97", "bigtujunga"}) {
    const auto points = support::terrain_sample(name);
    if (!points) continue;
    any = true;
    for (const Index k : {1u, 4u}) {
      const TriangulateOptions options = options_of("min-local-minima,min-sum-abn", k);
      const Report report = triangulate(*points, options).report;
      const Value alone =
          *triangulate(*points, {.order = k, .objective = options.then[0]}).report.value;
      const Value first = *triangulate(*points, {.order = k}).report.value;
      EXPECT_LE(report.value->result, first.result) << name << k;
      EXPECT_LE(report.then[0].value.result, 1.02 * alone.result) << name << k;
      EXPECT_EQ(report.then[0].is_bound_in_order, k == 1) << name;
    }
  }
  if (!any) GTEST_SKIP() << support::no_terrain("whitebox_dem");
}

}  // namespace
}  // namespace hodt
