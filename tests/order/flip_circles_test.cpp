#include "hodt/order/first_order/flip_circles.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "../support/convert.h"
#include "../support/inner_edges.h"
#include "../support/shapes.h"
#include "families.h"
#include <gtest/gtest.h>

#include "hodt/base/lanes.h"
#include "hodt/geometry/predicates.h"
#include "hodt/order/circle_counter.h"
#include "hodt/order/first_order/first_order.h"

namespace hodt {
namespace {

std::vector<HalfEdgeId> inner_edges(const TriangleMesh& mesh) {
  std::vector<HalfEdgeId> edges;
  for_each_inner_edge(mesh, [&](HalfEdgeId h) { edges.push_back(h); });
  return edges;
}

std::vector<bool> answers(const DelaunayGraph& graph, const std::vector<HalfEdgeId>& edges) {
  const auto found = std::make_unique<bool[]>(edges.size());
  FlipCircles(graph).hold_one_each(edges, found.get());
  return std::vector<bool>(found.get(), found.get() + edges.size());
}

/// By counts that begin at a corner, one circle after another.
std::vector<bool> counted(const DelaunayGraph& graph, const std::vector<HalfEdgeId>& edges) {
  CircleCounter counter(graph);
  const auto holds_one = [&](HalfEdgeId h) {
    const auto [a, b, c] = FlipCircles::corners(graph.mesh, h);
    return orient(graph.point(a), graph.point(b), graph.point(c)) > 0 &&
           counter.count(a, b, c, 1) == 1 && counter.inside().front() == graph.mesh.origin(h);
  };
  std::vector<bool> all;
  for (const HalfEdgeId h : edges) all.push_back(holds_one(h) && holds_one(graph.mesh.twin(h)));
  return all;
}

class FlipCirclesFamilies : public testing::TestWithParam<families::Family> {};

TEST_P(FlipCirclesFamilies, are_counted_one_by_one) {
  for (const int n : {4, 5, 8, 20, 80}) {
    if (GetParam().name == "wide_range" && n > 20) continue;
    const Delaunay d = delaunay(support::to_point_set(GetParam().make(n, 51)));
    const DelaunayGraph graph(d);
    const auto edges = inner_edges(d.mesh);
    ASSERT_EQ(answers(graph, edges), counted(graph, edges)) << support::to_source(d.vertices.xy);
  }
}

INSTANTIATE_TEST_SUITE_P(All, FlipCirclesFamilies, testing::ValuesIn(families::all()),
                         [](const auto& each) { return each.param.name; });

/// From either side, on any processor.
TEST(FlipCircles, same_answers_whatever_the_lanes) {
  for (const support::Points& points : {support::uniform(3000, 5), support::lattice(40, 40)}) {
    const Delaunay d = delaunay({points, {}});
    const DelaunayGraph graph(d);
    auto edges = inner_edges(d.mesh);
    const auto expected = counted(graph, edges);
    EXPECT_GT(std::count(expected.begin(), expected.end(), true), 1000);
    const auto flippable = first_order_edges(graph);
    for (const Index lanes : {4, 8, 16}) {
      const LaneLimit limit(lanes);
      EXPECT_EQ(answers(graph, edges), expected) << lanes;
      EXPECT_EQ(first_order_edges(graph), flippable) << lanes;
    }
    for (HalfEdgeId& h : edges) h = d.mesh.twin(h);
    EXPECT_EQ(answers(graph, edges), expected);
  }
}

}  // namespace
}  // namespace hodt
