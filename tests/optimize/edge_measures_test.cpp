#include "hodt/optimize/edge_measures.h"

#include <vector>

#include "../support/shapes.h"
#include <gtest/gtest.h>

#include "hodt/base/lanes.h"

namespace hodt {
namespace {

/// Values of single edges are checked with the optima, in optimize_measure_test.cpp.
TEST(ManyEdges, have_the_same_bits_as_one) {
  const std::vector<Point> xy = support::uniform(100, 8);
  std::vector<double> z;
  for (const Point& p : xy) z.push_back(p.x * p.x - p.y);
  z[7] = z[8] = 1e300;  // infinite and undefined values
  for (const Measure measure : {Measure::abn, Measure::jnd, Measure::wabn}) {
    const EdgeValues values({Direction::minimize, Aggregate::sum, measure}, xy, z);
    struct Edge {
      VertexId a, b;
      EdgeValues::Gradient f, g;
    };
    std::vector<Edge> edges;
    for (Index i = 0; i + 3 < xy.size(); ++i)
      for (Index j = i + 1; j + 2 < xy.size(); j += 7) {
        const VertexId a(i), b(j), c(j + 1), d(j + 2);
        edges.push_back({a, b, values.gradient(a, b, c), values.gradient(a, b, d)});
      }
    edges.push_back({VertexId(3), VertexId(3), {0, 0}, {0, 0}});
    ASSERT_GT(edges.size(), 500u);  // more than are measured at once
    for (const Index lanes : {4u, 8u, 16u}) {
      const LaneLimit limit(lanes);
      std::vector<double> all(edges.size(), -1);
      ManyEdges many(values);
      for (std::size_t i = 0; i < edges.size(); ++i)
        many.add(edges[i].a, edges[i].b, edges[i].f, edges[i].g, all[i]);
      many.measure();
      for (std::size_t i = 0; i < edges.size(); ++i)
        ASSERT_EQ(all[i], values.across(edges[i].a, edges[i].b, edges[i].f, edges[i].g));
    }
  }
}

}  // namespace
}  // namespace hodt
