#include "hodt/order/search/count_past_hubs.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "../support/convert.h"
#include "../support/shapes.h"
#include <gtest/gtest.h>

#include "hodt/geometry/predicates.h"

namespace hodt {
namespace {

/// Some point on the left of uv, and none if there is none or one is on the segment's line.
std::optional<VertexId> any_on_left(std::span<const Point> xy, VertexId u, VertexId v) {
  std::optional<VertexId> found;
  for (Index i = 0; i < xy.size(); ++i) {
    if (i == u || i == v) continue;
    const int side = orient(xy[u], xy[v], xy[i]);
    if (side == 0) return std::nullopt;
    if (side > 0) found = VertexId(i);
  }
  return found;
}

/// How many of the pairs are answered. None may be answered otherwise than by Lemma 4.
int compare_with_lemma(const Delaunay& d, int pairs, std::uint64_t seed) {
  DelaunayGraph graph(d);
  graph.list_neighbours();
  const oracle::Instance instance(support::to_oracle(d.vertices.xy));
  CountPastHubs count(graph);
  families::Random random(seed);
  const int n = instance.size();
  int answered = 0;
  for (int pair = 0; pair < pairs; ++pair) {
    const int u = random.integer(0, n - 1), v = random.integer(0, n - 1);
    if (u == v) continue;
    const VertexId a{Index(u)}, b{Index(v)};
    const auto left = any_on_left(graph.xy, a, b), right = any_on_left(graph.xy, b, a);
    if (!left || !right) continue;
    const auto expected = Index(instance.useful_order_by_lemma(u, v).value());
    for (const Index limit : {Index{0}, Index{3}, Index(n)}) {
      const Index order = count.useful_order(a, b, *left, *right, limit);
      if (order == kNone) continue;
      ++answered;
      if (expected <= limit)
        EXPECT_EQ(order, expected) << u << ' ' << v << " limit " << limit;
      else
        EXPECT_GT(order, limit) << u << ' ' << v << " limit " << limit;
    }
  }
  return answered;
}

class PastHubsFamilies : public testing::TestWithParam<families::Family> {};

TEST_P(PastHubsFamilies, equal_lemma_4) {
  for (const int n : {5, 9, 15}) {
    const Delaunay d = delaunay(support::to_point_set(GetParam().make(n, n + 30)));
    compare_with_lemma(d, 60, 4);
  }
}

INSTANTIATE_TEST_SUITE_P(All, PastHubsFamilies, testing::ValuesIn(families::all()),
                         [](const auto& each) { return each.param.name; });

TEST(CountPastHubs, around_a_hub_and_far_from_one) {
  for (const double roughness : {0.0, 0.001, 1.0}) {
    support::Points points = support::uniform(400, 6);
    for (Point& p : points) {
      const double a = 2 * std::numbers::pi * p.x, radius = 1 + roughness * p.y;
      p = {radius * std::cos(a), radius * std::sin(a)};
    }
    points[0] = {0, 0};
    EXPECT_GT(compare_with_lemma(delaunay({points, {}}), 300, 5), 600) << roughness;
  }
}

}  // namespace
}  // namespace hodt
