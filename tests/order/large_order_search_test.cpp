#include "hodt/order/search/large_order_search.h"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "../support/convert.h"
#include "../support/shapes.h"
#include <gtest/gtest.h>

#include "hodt/geometry/predicates.h"
#include "hodt/order/circle_counter.h"
#include "hodt/order/useful_edges.h"

namespace hodt {
namespace {

using Orders = std::map<Index, Index>;  // other end -> order

Orders orders_from(LargeOrderSearch& search, VertexId u, Index limit) {
  Orders orders;
  search.from(
      u, limit, [](VertexId) { return true; },
      [&](VertexId v, Index order) {
        EXPECT_TRUE(orders.emplace(v, order).second) << "found twice";
      });
  return orders;
}

class LargeOrderFamilies : public testing::TestWithParam<families::Family> {};

TEST_P(LargeOrderFamilies, equal_lemma_4) {
  const bool slow = GetParam().name == "wide_range";
  for (const int n : {4, 5, 9, 15, 24, 40}) {
    if (slow && n > 15) continue;
    const Delaunay d = delaunay(support::to_point_set(GetParam().make(n, n + 70)));
    const DelaunayGraph graph(d);
    const PointTree tree(graph.xy);
    LargeOrderSearch search(graph, tree);
    const oracle::Instance instance(support::to_oracle(d.vertices.xy));
    for (const Index limit : {1u, 2u, 5u, static_cast<Index>(n), kNone - 1}) {
      for (int u = 0; u < instance.size(); ++u) {
        Orders expected;
        for (int v = 0; v < instance.size(); ++v) {
          if (v == u) continue;
          const std::optional<int> order = instance.useful_order_by_lemma(u, v);
          if (order && *order > 0 && Index(*order) <= limit) expected[Index(v)] = Index(*order);
        }
        ASSERT_EQ(orders_from(search, VertexId(Index(u)), limit), expected)
            << "from " << u << " limit " << limit << ' ' << support::to_source(d.vertices.xy);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, LargeOrderFamilies, testing::ValuesIn(families::all()),
                         [](const auto& each) { return each.param.name; });

/// The two ways to all useful edges share nothing but the predicates. Together, one goes on where
/// the other meets a crowd.
TEST(LargeOrderSearch, equals_the_search_for_small_orders) {
  const auto circle = [](int n) {
    support::Points points;
    families::Random random(8);
    for (const Point& p : support::uniform(std::size_t(n), 9)) {
      const double angle = 6.283 * p.x, radius = 1 + 0.01 * p.y;
      points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return points;
  };
  const auto star = [&](int n) {  // the centre is a neighbour of all others
    support::Points points = circle(n);
    points.push_back({0, 0});
    return points;
  };
  // Seen from one of them, the images of the others are close together and close to it.
  const auto far_clouds = [](int n) {
    support::Points points;
    for (const Point& p : support::uniform(std::size_t(n), 10)) {
      const double size = std::pow(0.001, double(points.size() % 4));
      points.push_back({double(points.size() % 4) + size * p.x, size * p.y});
    }
    return points;
  };
  for (const support::Points& points :
       {support::uniform(3000, 1), support::lattice(50, 60), support::clustered(3000, 2),
        support::utm_lattice(40, 40), circle(1500), star(500), far_clouds(1600)}) {
    const Delaunay d = delaunay({points, {}});
    DelaunayGraph graph(d);
    graph.list_neighbours();
    const PointTree tree(graph.xy);
    LargeOrderSearch large(graph, tree);
    UsefulEdgeSearch small(graph), both(graph, tree);
    for (const Index limit : {3u, 20u, 100u, 600u, 2998u}) {
      for (Index u = limit % 97; u < graph.xy.size(); u += 311) {
        const auto all = [](VertexId) { return true; };
        Orders expected, together;
        for (const UsefulEdge& e : small.from(VertexId(u), limit, all)) expected[e.to] = e.order;
        for (const UsefulEdge& e : both.from(VertexId(u), limit, all)) together[e.to] = e.order;
        ASSERT_EQ(together, expected) << u << " limit " << limit;
        ASSERT_EQ(orders_from(large, VertexId(u), limit), expected) << u << " limit " << limit;
      }
    }
  }
}

TEST(PointTree, counts_what_is_inside) {
  for (const support::Points& points :
       {support::uniform(3000, 3), support::lattice(50, 60), support::clustered(3000, 4),
        support::utm_lattice(40, 40), support::Points{{0, 0}, {1, 0}, {0, 1}}}) {
    const Delaunay d = delaunay({points, {}});
    const std::span<const Point> p = d.vertices.xy;
    const PointTree tree(p);
    families::Random random(5);
    const auto any = [&] { return VertexId(Index(random.bits() % p.size())); };
    for (int i = 0; i < 300; ++i) {
      const VertexId a = any(), b = any(), c = any();
      if (orient(p[a], p[b], p[c]) <= 0) continue;
      Index inside = 0;
      VertexId first = c;
      for (Index j = 0; j < p.size(); ++j) {
        inside += in_circle(p[a], p[b], p[c], p[j]);
        if (orient(p[a], p[b], p[j]) > 0 && in_circle(p[a], p[b], p[first], p[j]))
          first = VertexId(j);
      }
      ASSERT_EQ(tree.count(a, b, c, kUnlimited), inside);
      ASSERT_EQ(tree.count(a, b, c, inside), inside);
      if (inside > 0) {
        ASSERT_GT(tree.count(a, b, c, inside - 1), inside - 1);
      }
      ASSERT_EQ(tree.first_on_left(a, b, c), first);
    }
  }
}

TEST(KLevel, proofs_hold) {
  families::Random random(6);
  const auto number = [&] { return double(random.bits() % 2001) / 1000 - 1; };
  std::size_t proven = 0, asked = 0;
  for (const Index n : {1u, 10u, 100u, 3000u}) {
    std::vector<Point> points(n);
    for (Point& p : points) {
      const double x = number(), y = number(), r = x * x + y * y + 1e-3;
      p = {x / r, y / r};
    }
    for (const Index k : {0u, 3u, 50u, 1000u, 5000u}) {
      KLevel level;
      level.build(points, k);
      for (int i = 0; i < 300; ++i) {
        const double angle = 3.1416 * number(), distance = std::fabs(number()) * 5 + 1e-3;
        const Point normal{std::cos(angle), std::sin(angle)};
        const auto beyond = std::count_if(points.begin(), points.end(), [&](const Point& p) {
          return p.x * normal.x + p.y * normal.y > distance;
        });
        const bool more = beyond > std::ptrdiff_t(k);
        ASSERT_FALSE(level.surely_more(normal, distance) && !more);
        proven += more && level.surely_more(normal, distance);
        asked += more;
        // Any line through a deep point has more beyond it.
        const Point through{distance * normal.x, distance * normal.y};
        if (level.surely_deep(through)) {
          ASSERT_TRUE(more);
        }
      }
    }
  }
  EXPECT_GT(proven, asked * 99 / 100) << "proofs are for lines clear of rounding";
  EXPECT_GT(asked, 1000u);
}

}  // namespace
}  // namespace hodt
