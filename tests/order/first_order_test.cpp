#include "hodt/order/first_order/first_order.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include "../support/convert.h"
#include "../support/inner_edges.h"
#include "../support/shapes.h"
#include <gtest/gtest.h>

#include "hodt/base/parallel.h"
#include "hodt/order/triangulation_order.h"
#include "hodt/order/useful_edges.h"

namespace hodt {
namespace {

std::set<oracle::Edge> delaunay_edges(const TriangleMesh& mesh) {
  std::set<oracle::Edge> edges;
  for (Index i = 0; i < mesh.halfedge_count(); ++i) {
    const int a = static_cast<int>(mesh.origin(HalfEdgeId(i)));
    const int b = static_cast<int>(mesh.target(HalfEdgeId(i)));
    edges.insert({std::min(a, b), std::max(a, b)});
  }
  return edges;
}

/// Checks the list itself, and returns its edges.
std::set<oracle::Edge> flippable(const DelaunayGraph& graph) {
  const auto found = first_order_edges(graph);
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
  std::set<oracle::Edge> edges;
  for (const HalfEdgeId h : found) {
    EXPECT_LT(h, graph.mesh.twin(h));
    EXPECT_TRUE(is_first_order_flippable(graph, h));
    EXPECT_TRUE(is_first_order_flippable(graph, graph.mesh.twin(h)));
    const int a = static_cast<int>(graph.mesh.origin(h));
    const int b = static_cast<int>(graph.mesh.target(h));
    EXPECT_TRUE(edges.insert({std::min(a, b), std::max(a, b)}).second) << "found twice";
  }
  return edges;
}

class FirstOrder : public testing::TestWithParam<families::Family> {};

TEST_P(FirstOrder, all_other_edges_are_fixed_by_the_definition) {
  for (const int n : {4, 5, 6, 7, 8, 9}) {
    const Delaunay d = delaunay(support::to_point_set(GetParam().make(n, 41)));
    const DelaunayGraph graph(d);
    const oracle::Instance instance(support::to_oracle(d.vertices.xy));
    const auto fixed = oracle::Catalogue(instance).fixed_edges(1);
    std::set<oracle::Edge> expected = delaunay_edges(d.mesh);
    for (const oracle::Edge& edge : fixed) ASSERT_EQ(expected.erase(edge), 1u);
    ASSERT_EQ(flippable(graph), expected) << support::to_source(d.vertices.xy);
  }
}

TEST_P(FirstOrder, are_those_that_a_useful_edge_crosses) {
  for (const int n : {12, 20, 36}) {
    if (GetParam().name == "wide_range" && n > 12) continue;
    const Delaunay d = delaunay(support::to_point_set(GetParam().make(n, 42)));
    const DelaunayGraph graph(d);
    const oracle::Instance instance(support::to_oracle(d.vertices.xy));
    std::set<oracle::Edge> expected;
    const auto edges = delaunay_edges(d.mesh);
    for (int u = 0; u < instance.size(); ++u)
      for (int v = u + 1; v < instance.size(); ++v)
        if (instance.useful_order_by_lemma(u, v) == 1)
          for (const auto& [a, b] : edges)
            if (instance.segments_cross(u, v, a, b)) expected.insert({a, b});
    ASSERT_EQ(flippable(graph), expected) << support::to_source(d.vertices.xy);
  }
}

INSTANTIATE_TEST_SUITE_P(All, FirstOrder, testing::ValuesIn(families::all()),
                         [](const auto& each) { return each.param.name; });

TEST(FirstOrderLarge, agrees_with_the_search_and_flips_independently) {
  families::Random random(1);
  for (const support::Points& points :
       {support::uniform(20000, 1), support::lattice(120, 120), support::utm_lattice(100, 100)}) {
    const Delaunay d = delaunay({points, {}});
    const DelaunayGraph graph(d);
    const auto found = first_order_edges(graph);
    UsefulEdgeSearch search(graph);
    std::size_t ends = 0;
    for (Index u = 0; u < points.size(); ++u)
      ends += search.from(VertexId(u), 1, [](VertexId) { return true; }).size();
    EXPECT_EQ(ends, 2 * found.size()) << "each quadrilateral has one useful diagonal more";
    for (int round = 0; round < 5; ++round) {  // any subset keeps order 1 (Corollary 3)
      TriangleMesh mesh = d.mesh;
      for (const HalfEdgeId h : found)
        if (random.integer(0, 1)) mesh.flip(h);
      EXPECT_EQ(order_histogram(graph, mesh).size(), 2u);
    }
    const auto with_threads = [&](std::size_t threads) {
      const ThreadLimit limit(threads);
      return first_order_edges(graph);
    };
    EXPECT_EQ(with_threads(1), with_threads(2));
  }
}

/// A hub, and so many points around it from one direction to another, near a circle.
support::Points fan(std::size_t n, double noise, double from, double to) {
  families::Random random(7);
  support::Points points = {{0, 0}};
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = from + (to - from) * double(i) / double(n), r = 1 + noise * random.real();
    points.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return points;
}

TEST(FirstOrderLarge, past_hubs_as_one_by_one) {
  constexpr double kTurn = 2 * std::numbers::pi;
  support::Points two = fan(600, 0, 0, kTurn);
  for (const Point& p : fan(500, 1e-12, 0, kTurn)) two.push_back({p.x + 3, p.y});
  std::size_t hub_flips = 0;
  for (const support::Points& points :
       {fan(700, 0, 0, kTurn), fan(700, 1e-15, 0, kTurn), fan(700, 1e-3, 0, kTurn),
        fan(700, 0, 0.1, 1), fan(700, 1e-4, 0.1, 1), fan(700, 0, 0, kTurn / 2), two}) {
    const Delaunay d = delaunay({points, {}});
    const DelaunayGraph graph(d);
    std::vector<HalfEdgeId> expected;
    for_each_inner_edge(d.mesh, [&](HalfEdgeId h) {
      if (is_first_order_flippable(graph, h)) expected.push_back(h);
    });
    EXPECT_EQ(first_order_edges(graph), expected);
    Index most = 0;
    for (Index v = 0; v < d.mesh.vertex_count(); ++v) {
      Index degree = 0;
      graph.for_each_neighbour(VertexId(v), [&](VertexId) { ++degree; });
      most = std::max(most, degree);
    }
    hub_flips += most > 300 ? expected.size() : 0;
  }
  EXPECT_GT(hub_flips, 1000u) << "there are hubs, and edges to flip beside them";
}

}  // namespace
}  // namespace hodt
