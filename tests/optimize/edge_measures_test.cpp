#include "hodt/optimize/measure/edge_measures.h"

#include <algorithm>
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
  for (const double steep : {1.0, 1e30, 1e200}) {
    z[7] = z[8] = steep;  // squares of slopes are out of range at last
    for (const EdgeMeasure::Kind measure :
         {EdgeMeasure::abn, EdgeMeasure::jnd, EdgeMeasure::wabn}) {
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
        ManyEdges many(values);
        for (std::size_t begin = 0; begin + 1 < edges.size(); begin += ManyEdges::kSize) {
          // On each side the gradients of two edges.
          const std::size_t size = std::min(ManyEdges::kSize, edges.size() - 1 - begin);
          for (std::size_t i = 0; i < size; ++i) {
            const Edge &edge = edges[begin + i], &other = edges[begin + i + 1];
            many.set(i, edge.a, edge.b, {edge.f, other.f}, {edge.g, other.g});
          }
          for (const int left : {0, 1})
            for (const int right : {0, 1}) {
              const double* const all = many.measure(size, left, right);
              for (std::size_t i = 0; i < size; ++i)
                ASSERT_EQ(all[i],
                          values.across(edges[begin + i].a, edges[begin + i].b,
                                        edges[begin + i + left].f, edges[begin + i + right].g));
            }
        }
      }
    }
  }
}

}  // namespace
}  // namespace hodt
