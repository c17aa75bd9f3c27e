#include "hodt/optimize/optimize.h"

#include <string>
#include <vector>

#include "../support/convert.h"
#include "../support/shapes.h"
#include "../support/triangulation_problems.h"
#include <gtest/gtest.h>

#include "hodt/base/error.h"
#include "hodt/order/triangulation_order.h"
#include "hodt/pipeline.h"

namespace hodt {
namespace {

/// The stages one by one give what the whole job reports.
TEST(Optimize, any_objective) {
  const support::Points points = support::uniform(600, 1);
  const PointSet set{points, support::rough_heights(points, 1, 2)};
  const Delaunay delaunay = hodt::delaunay(set);
  const DelaunayGraph graph(delaunay);
  for (const char* name :
       {"min-local-minima", "min-local-maxima", "min-local-extrema", "min-max-degree",
        "min-sum-length", "max-min-small-angle", "min-sum-abn"})
    for (const Index k : {0, 1, 3}) {
      const Objective objective = objective_from_name(name);
      const Optimum optimum = optimize(graph, delaunay.vertices.z, objective, {.order = k});
      const Value value = *triangulate(set, {.order = k, .objective = objective}).report.value;
      EXPECT_EQ(optimum.value.delaunay, value.delaunay) << name << k;
      EXPECT_EQ(optimum.value.result, value.result) << name << k;
      EXPECT_EQ(optimum.value.bound, value.bound) << name << k;
      EXPECT_EQ(optimum.value.optimal, value.optimal) << name << k;
      const TriangleMesh mesh = optimum.change.applied_to(delaunay.mesh);
      EXPECT_EQ(embedding_problem(delaunay.vertices.xy, mesh), "") << name << k;
      EXPECT_EQ(order_problem(graph, mesh, k), "") << name << k;
      EXPECT_EQ(order_histogram(graph, optimum.change), order_histogram(graph, mesh)) << name << k;
    }
}

TEST(Optimize, none_changes_nothing) {
  const PointSet set{support::uniform(50, 3), {}};
  const Delaunay delaunay = hodt::delaunay(set);
  const Optimum optimum = optimize(DelaunayGraph(delaunay), {}, Objective::none);
  EXPECT_TRUE(support::same_arrays(optimum.change.applied_to(delaunay.mesh), delaunay.mesh));
  EXPECT_TRUE(optimum.value.optimal);
}

TEST(Optimize, says_what_is_missing) {
  const PointSet set{support::uniform(50, 3), {}};
  const Delaunay delaunay = hodt::delaunay(set);
  const DelaunayGraph graph(delaunay);
  EXPECT_THROW(optimize(graph, {}, Objective::min_local_minima), ParameterError);
  EXPECT_THROW(optimize(graph, {}, Objective::min_max_degree, {.method = Method::greedy}),
               ParameterError);
}

}  // namespace
}  // namespace hodt
