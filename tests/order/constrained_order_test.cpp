// Order under constraints against the definition: circles, useful and fixed edges, triangles,
// flips, hulls and whole triangulations, by the enumeration of all triangulations with the
// constraints.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "../oracle/constrained.h"
#include "../oracle/constraint_shapes.h"
#include "../support/convert.h"
#include <gtest/gtest.h>

#include "hodt/order/circle_counter.h"
#include "hodt/order/constrained/constrained_delaunay.h"
#include "hodt/order/constrained/domain.h"
#include "hodt/order/edges.h"
#include "hodt/order/first_order/first_order.h"
#include "hodt/order/hull.h"
#include "hodt/order/triangles.h"
#include "hodt/order/triangulation_order.h"
#include "hodt/order/useful_edges.h"

namespace hodt {
namespace {

using oracle::Constrained;
using oracle::ConstrainedCatalogue;
using oracle::Domain;
using oracle::Edge;
using oracle::edge_of;
using oracle::Instance;
using oracle::Triangle;
using oracle::Triangles;

/// Calls f with each of the corners first, the turn as it is.
std::array<Triangle, 3> turned(const Triangle& t) {
  return {{{t[0], t[1], t[2]}, {t[1], t[2], t[0]}, {t[2], t[0], t[1]}}};
}

std::set<Edge> edges_of(const Triangles& triangles) {
  std::set<Edge> edges;
  for (const Triangle& t : triangles)
    for (const auto& [u, v, w] : turned(t)) edges.insert(edge_of(u, v));
  return edges;
}

/// One set of points with constraints, by hodt and by the oracle. The oracle's points are the rows
/// of hodt's; a row can be several vertices where a domain touches itself.
class Walled {
 public:
  Walled(const Instance& instance, const std::vector<Edge>& edges,
         const std::optional<Domain>& domain)
      : constrained(instance, edges),
        domain_(domain),
        catalogue(domain ? ConstrainedCatalogue(constrained, domain->rings)
                         : ConstrainedCatalogue(constrained)),
        delaunay(made(instance, edges, domain)),
        graph(delaunay),
        copies_(std::size_t(instance.size())) {
    for (Index v = 0; v < delaunay.vertices.size(); ++v)
      copies_[delaunay.vertices.row[v]].push_back(VertexId(v));
    for (const Triangle& t : constrained.possible_triangles())
      if (is_inside(t)) possible.push_back(t);
  }

  bool is_inside(const Triangle& t) const {
    return !domain_ || oracle::is_in_domain(constrained.instance(), domain_->rings, t);
  }
  Triangles those_inside(const Triangles& triangles) const {
    Triangles inside;
    std::ranges::copy_if(triangles, std::back_inserter(inside),
                         [&](const Triangle& t) { return is_inside(t); });
    return inside;
  }

  int row(Index v) const { return static_cast<int>(delaunay.vertices.row[v]); }
  Edge rows(Index u, Index v) const { return edge_of(row(u), row(v)); }
  Triangle rows(const std::array<VertexId, 3>& t) const {
    return support::canonical({row(t[0]), row(t[1]), row(t[2])});
  }

  /// The vertices that are the corners of a possible triangle.
  std::array<VertexId, 3> vertices(const Triangle& t) const {
    std::array<VertexId, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = vertex_at(turned(t)[i]);
    return corners;
  }

  const Constrained constrained;

 private:
  const std::optional<Domain> domain_;

  static Delaunay made(const Instance& instance, const std::vector<Edge>& edges,
                       const std::optional<Domain>& domain) {
    const PointSet points = support::to_point_set(instance.points());
    Delaunay d = hodt::delaunay(points);
    const Buffer<VertexId> vertex_of = vertices_of_rows(points, d.vertices);
    std::vector<std::array<VertexId, 2>> walls, boundary;
    for (const auto& [u, v] : edges) walls.push_back({vertex_of[u], vertex_of[v]});
    if (domain)
      for (const auto& [u, v] : domain->edges) boundary.push_back({vertex_of[u], vertex_of[v]});
    EXPECT_TRUE(insert_walls(d, walls).empty());
    restrict_to_domain(d, boundary, std::numeric_limits<double>::infinity());
    return d;
  }

  /// Whether the angles at the first corners have directions in common.
  bool overlap_at_first(const Triangle& s, const Triangle& t) const {
    const auto is_within = [&](int v, const Triangle& angle) {
      const Instance& at = constrained.instance();
      return at.orient(angle[0], angle[1], v) > 0 && at.orient(angle[0], v, angle[2]) > 0;
    };
    return s == t || is_within(s[1], t) || is_within(s[2], t) || is_within(t[1], s) ||
           is_within(t[2], s);
  }
  /// The vertex that is the first corner.
  VertexId vertex_at(const Triangle& t) const {
    const auto& copies = copies_[std::size_t(t[0])];
    if (copies.size() == 1) return copies[0];
    for (Index i = 0; i < delaunay.mesh.halfedge_count(); ++i) {
      const HalfEdgeId h(i);
      const Triangle s{row(delaunay.mesh.origin(h)), row(delaunay.mesh.target(h)),
                       row(delaunay.mesh.apex(h))};
      if (s[0] == t[0] && overlap_at_first(s, t)) return delaunay.mesh.origin(h);
    }
    ADD_FAILURE() << "no triangle where " << t[0] << " is";
    return {};
  }

 public:
  const ConstrainedCatalogue catalogue;
  const Delaunay delaunay;
  const DelaunayGraph graph;
  Triangles possible;

 private:
  std::vector<std::vector<VertexId>> copies_;
};

// ---- Every question ----

void expect_delaunay(const Walled& walled) {
  ASSERT_EQ(support::rows_of(walled.delaunay), walled.those_inside(walled.constrained.delaunay()));
  std::set<Edge> walls, expected;
  for (Index i = 0; i < walled.delaunay.mesh.halfedge_count(); ++i) {
    const HalfEdgeId h(i);
    const VertexId u = walled.delaunay.mesh.origin(h), v = walled.delaunay.mesh.target(h);
    if (walled.graph.is_wall(h)) walls.insert(walled.rows(u, v));
    ASSERT_EQ(walled.graph.is_wall(u, v), walled.graph.is_wall(h));
  }
  const std::set<Edge> inside = edges_of(support::rows_of(walled.delaunay));
  for (const Edge& e : walled.constrained.edges())
    if (inside.contains(e)) expected.insert(e);
  ASSERT_EQ(walls, expected);
}

void expect_counts(const Walled& walled) {
  CircleCounter counter(walled.graph);
  for (const Triangle& t : walled.possible) {
    const auto expected = walled.constrained.reachable_inside(t);
    const auto order = static_cast<Index>(expected.size());
    for (const Triangle& s : turned(t)) {
      const auto [a, b, c] = walled.vertices(s);
      ASSERT_EQ(counter.count(a, b, c, kUnlimited), order) << s[0] << ' ' << s[1] << ' ' << s[2];
      std::vector<int> found;
      for (const VertexId v : counter.inside()) found.push_back(walled.row(v));
      std::ranges::sort(found);
      ASSERT_EQ(found, expected);
      for (const Index limit : {0u, 1u, 2u, 4u})
        ASSERT_EQ(counter.count(a, b, c, limit), std::min(order, limit + 1));
    }
  }
}

using EdgeOrders = std::map<Edge, int>;

EdgeOrders useful_by_catalogue(const Walled& walled, int k) {
  EdgeOrders orders;
  const int n = walled.constrained.instance().size();
  for (int u = 0; u < n; ++u)
    for (int v = u + 1; v < n; ++v)
      if (const auto order = walled.catalogue.useful_order(u, v); order && *order <= k)
        orders[{u, v}] = *order;
  return orders;
}

EdgeOrders without_delaunay(EdgeOrders orders) {
  std::erase_if(orders, [](const auto& e) { return e.second == 0; });
  return orders;
}

EdgeOrders edges_of_class(const Walled& walled, EdgeClass edge_class, Index k) {
  EdgeOrders orders;
  for_each_edge(walled.graph, edge_class, k, [&](std::span<const EdgeRecord> piece) {
    for (const auto& [u, v, order] : piece) {
      const bool is_new = orders.emplace(walled.rows(u, v), order).second;
      EXPECT_TRUE(is_new) << "found twice";
    }
  });
  return orders;
}

void expect_searches(const Walled& walled, const EdgeOrders& useful, Index k) {
  UsefulEdgeSearch search(walled.graph);
  EdgeOrders to_larger;
  std::map<Edge, int> ends;
  const auto n = static_cast<Index>(walled.graph.xy.size());
  for (Index u = 0; u < n; ++u) {
    for (const auto& [v, order] : search.from(VertexId(u), k, [](VertexId) { return true; })) {
      const Edge e = walled.rows(u, v);
      ASSERT_TRUE(useful.contains(e)) << e[0] << '-' << e[1] << " is not useful";
      ASSERT_EQ(static_cast<int>(order), useful.at(e)) << e[0] << '-' << e[1];
      ++ends[e];
    }
    for (const auto& [v, order] : search.to_larger(VertexId(u), k)) {
      const bool is_new = to_larger.emplace(walled.rows(u, v), order).second;
      ASSERT_TRUE(is_new);
    }
  }
  for (const auto& [e, order] : useful) ASSERT_EQ(ends[e], 2) << e[0] << '-' << e[1];
  ASSERT_EQ(to_larger, useful);
}

void expect_useful_order_of_pairs(const Walled& walled, const EdgeOrders& useful, Index k) {
  UsefulEdgeSearch search(walled.graph);
  EdgeOrders found;
  const auto n = static_cast<Index>(walled.graph.xy.size());
  for (Index u = 0; u < n; ++u)
    for (Index v = 0; v < n; ++v)
      if (walled.row(u) != walled.row(v))
        if (const auto order = search.useful_order(VertexId(u), VertexId(v), k))
          found[walled.rows(u, v)] = static_cast<int>(*order);
  ASSERT_EQ(found, useful);
}

void expect_edges(const Walled& walled) {
  const int n = walled.constrained.instance().size();
  for (const int k : {0, 1, 2, 3, 4, n}) {
    const EdgeOrders useful = useful_by_catalogue(walled, k);
    ASSERT_EQ(edges_of_class(walled, EdgeClass::useful, Index(k)), useful) << "k " << k;
    EdgeOrders fixed;
    for (const Edge& e : walled.catalogue.fixed_edges(k)) fixed[e] = 0;
    ASSERT_EQ(edges_of_class(walled, EdgeClass::fixed, Index(k)), fixed) << "k " << k;
    ASSERT_EQ(edges_of_class(walled, EdgeClass::delaunay, Index(k)),
              useful_by_catalogue(walled, 0));
    expect_useful_order_of_pairs(walled, useful, Index(k));
    expect_searches(walled, without_delaunay(useful), Index(k));
    if (testing::Test::HasFatalFailure()) FAIL() << "k " << k;
  }
}

template <class Orders>
Orders up_to(Orders orders, int k) {
  std::erase_if(orders, [&](const auto& each) { return each.second > k; });
  return orders;
}

void expect_kod_edges(const Walled& walled) {
  const int n = walled.constrained.instance().size();
  EdgeOrders all;
  for (const auto& [u, v] : edges_of(walled.possible))
    all[{u, v}] = walled.constrained.edge_order(u, v).value();
  for (const int k : {0, 1, 2, 3, 4, n})
    ASSERT_EQ(edges_of_class(walled, EdgeClass::kod, Index(k)), up_to(all, k)) << "k " << k;
  for (const auto& [e, order] : useful_by_catalogue(walled, n)) ASSERT_LE(all.at(e), order);
}

using TriangleOrders = std::map<std::array<int, 3>, int>;

Triangle sorted(Triangle t) {
  std::ranges::sort(t);
  return t;
}

/// By the rows of the vertices.
TriangleOrders triangles_of_class(const Walled& walled, TriangleClass triangle_class, Index k) {
  TriangleOrders found;
  for_each_triangle(walled.graph, triangle_class, k, own_numbering(walled.graph.xy.size()),
                    [&](std::span<const TriangleRecord> piece) {
                      for (const auto& [a, b, c, order] : piece) {
                        const Triangle t{walled.row(a), walled.row(b), walled.row(c)};
                        const bool is_new = found.emplace(sorted(t), order).second;
                        EXPECT_TRUE(is_new) << "found twice";
                      }
                    });
  return found;
}

void expect_valid_triangles(const Walled& walled) {
  for (const int k : {0, 1, 2, 3, 4, walled.constrained.instance().size()}) {
    TriangleOrders expected;
    for (int at = k; at >= 0; --at)
      for (const Triangle& t : walled.catalogue.valid_triangles(at)) expected[sorted(t)] = at;
    ASSERT_EQ(triangles_of_class(walled, TriangleClass::valid, Index(k)), expected) << "k " << k;
  }
}

void expect_kod_triangles(const Walled& walled) {
  const int n = walled.constrained.instance().size();
  TriangleOrders all;
  for (int c = 0; c < n; ++c)
    for (int b = 0; b < c; ++b)
      for (int a = 0; a < b; ++a)
        if (const auto order = walled.constrained.open_triangle_order({a, b, c});
            order && walled.is_inside({a, b, c}))
          all[{a, b, c}] = *order;
  for (const int k : {0, 1, 2, 3, 4, n})
    ASSERT_EQ(triangles_of_class(walled, TriangleClass::kod, Index(k)), up_to(all, k)) << "k " << k;
}

/// By the rows of the vertices the lists are the same, and sorted, also where several vertices have
/// the same row.
void expect_lists_by_rows(const Walled& walled) {
  const auto numbering =
      row_numbering(walled.delaunay.vertices, std::size_t(walled.constrained.instance().size()));
  constexpr Index k = 2;
  for (const EdgeClass edge_class :
       {EdgeClass::useful, EdgeClass::kod, EdgeClass::fixed, EdgeClass::delaunay}) {
    std::vector<std::pair<Edge, int>> found;
    for_each_edge(walled.graph, edge_class, k, numbering, [&](std::span<const EdgeRecord> piece) {
      for (const auto& [u, v, order] : piece)
        found.push_back({{static_cast<int>(u), static_cast<int>(v)}, static_cast<int>(order)});
    });
    const EdgeOrders expected = edges_of_class(walled, edge_class, k);
    ASSERT_EQ(found, (std::vector<std::pair<Edge, int>>(expected.begin(), expected.end())));
  }
  for (const TriangleClass triangle_class : {TriangleClass::valid, TriangleClass::kod}) {
    std::vector<std::pair<std::array<int, 3>, int>> found;
    for_each_triangle(
        walled.graph, triangle_class, k, numbering, [&](std::span<const TriangleRecord> piece) {
          for (const auto& [a, b, c, order] : piece)
            found.push_back({{static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)},
                             static_cast<int>(order)});
        });
    const TriangleOrders expected = triangles_of_class(walled, triangle_class, k);
    ASSERT_EQ(found,
              (std::vector<std::pair<std::array<int, 3>, int>>(expected.begin(), expected.end())));
  }
}

void expect_first_order(const Walled& walled) {
  std::set<Edge> expected = edges_of(support::rows_of(walled.delaunay));
  for (const Edge& e : walled.catalogue.fixed_edges(1)) expected.erase(e);
  std::set<Edge> found;
  for (const HalfEdgeId h : first_order_edges(walled.graph)) {
    found.insert(walled.rows(walled.delaunay.mesh.origin(h), walled.delaunay.mesh.target(h)));
    ASSERT_TRUE(is_first_order_flippable(walled.graph, h));
  }
  ASSERT_EQ(found, expected);
}

std::vector<std::size_t> histogram_by_definition(const Walled& walled, const Triangles& triangles) {
  std::vector<std::size_t> histogram;
  for (const Triangle& t : triangles) {
    const std::size_t order = walled.constrained.triangle_order(t);
    histogram.resize(std::max(histogram.size(), order + 1));
    ++histogram[order];
  }
  return histogram;
}

/// Of up to 40 of the triangulations there are.
void expect_histograms(const Walled& walled) {
  const auto& all = walled.catalogue.triangulations();
  const std::size_t step = 1 + all.size() / 40;
  for (std::size_t i = 0; i < all.size(); i += step) {
    std::vector<std::array<Index, 3>> corners;
    for (const Triangle& t : all[i].triangles) {
      const auto [a, b, c] = walled.vertices(t);
      corners.push_back({a, b, c});
    }
    const TriangleMesh mesh = support::make_mesh(walled.graph.xy.size(), corners);
    ASSERT_EQ(order_histogram(walled.graph, mesh),
              histogram_by_definition(walled, all[i].triangles));
  }
}

Triangles without(const Triangles& all, const Triangles& others) {
  Triangles rest;
  std::ranges::set_difference(all, others, std::back_inserter(rest));
  return rest;
}

/// What an edge takes the place of, and what it brings, as the oracle inserts it.
void expect_hulls(const Walled& walled) {
  UsefulEdgeSearch search(walled.graph);
  const Triangles before = support::rows_of(walled.delaunay);
  for (Index i = 0; i < walled.graph.xy.size(); ++i) {
    const VertexId u(i);
    const auto n = static_cast<Index>(walled.constrained.instance().size());
    for (const auto& [v, order] : search.from(u, n, [](VertexId) { return true; })) {
      const Edge e = walled.rows(u, v);
      auto edges = walled.constrained.edges();
      edges.push_back(e);
      const Triangles after =
          walled.those_inside(Constrained(walled.constrained.instance(), edges).delaunay());
      const Hull hull = hull_of_edge(walled.graph, u, v);
      Triangles gone, greedy;
      for (const TriangleId t : hull.triangles)
        gone.push_back(walled.rows(walled.delaunay.mesh.corners(t)));
      for (const auto& t : greedy_triangulation(walled.graph, u, v)) {
        greedy.push_back(walled.rows(t));
        ASSERT_LE(walled.constrained.triangle_order(greedy.back()), static_cast<int>(order));
      }
      std::ranges::sort(gone);
      std::ranges::sort(greedy);
      ASSERT_EQ(gone, without(before, after)) << e[0] << '-' << e[1];
      ASSERT_EQ(greedy, without(after, before)) << e[0] << '-' << e[1];
    }
  }
}

void expect_all(const Instance& instance, const std::vector<Edge>& edges,
                const std::optional<Domain>& domain = std::nullopt) {
  if (domain && domain->inside.empty()) return;
  const Walled walled(instance, edges, domain);
  for (const auto& expect : {expect_delaunay, expect_counts, expect_edges, expect_kod_edges,
                             expect_valid_triangles, expect_kod_triangles, expect_lists_by_rows,
                             expect_first_order, expect_histograms, expect_hulls}) {
    expect(walled);
    if (!testing::Test::HasFailure()) continue;
    std::string text = oracle::describe(walled.constrained);
    if (domain) {
      text += " boundary";
      for (const auto& [u, v] : domain->edges)
        text += ' ' + std::to_string(u) + '-' + std::to_string(v);
    }
    FAIL() << text;
  }
}

// ---- Small sets ----

int times(int seeds) {
  return (std::getenv("HODT_SLOW") != nullptr ? 20 : 1) * seeds;
}

class ConstrainedOrder : public testing::TestWithParam<families::Family> {};

TEST_P(ConstrainedOrder, with_edges_of_every_shape) {
  for (int n = 4; n <= 8; ++n)
    for (int seed = 0; seed < times(12) && !HasFailure(); ++seed) {
      const Instance instance(GetParam().make(n, seed));
      expect_all(instance, oracle::random_edges(instance, 1000 * n + seed));
    }
}

TEST_P(ConstrainedOrder, in_domains) {
  for (int n = 4; n <= 8; ++n)
    for (int seed = 0; seed < times(12) && !HasFailure(); ++seed) {
      const Instance instance(GetParam().make(n, seed));
      families::Random random(1000 * n + seed);
      const Domain domain = oracle::random_domain(instance, random);
      auto edges = domain.edges;
      for (const auto& [u, v] : oracle::random_constraints(instance, random.integer(0, 2), seed))
        if (oracle::fits(instance, edges, u, v)) edges.push_back({u, v});
      expect_all(instance, edges, domain);
    }
}

INSTANTIATE_TEST_SUITE_P(Families, ConstrainedOrder,
                         testing::ValuesIn(oracle::families_for_constraints()),
                         [](const auto& each) { return each.param.name; });

// ---- By hand ----

/// Two edges at the walls of the hull that dangle beside an edge of order 3: the crossed edges come
/// back to their ends.
TEST(ConstrainedOrderByHand, an_edge_that_dangles_is_counted_once) {
  const oracle::Points points{{2.2000000000000002, 0.73333333333333339},
                              {-0.75378222612389578, 5},
                              {0.5, 0.16666666666666669},
                              {1.1000000000000001, 0.3666666666666667},
                              {0.90000000000000002, 0.29999999999999999},
                              {0.40000000000000002, 0.13333333333333333},
                              {0.60000000000000009, 0.20000000000000001},
                              {2.5822021934136519, -5}};
  expect_all(Instance(points), {{0, 1}, {0, 7}, {1, 5}, {5, 7}});
}

/// An edge of order 2 that crosses edges at one vertex, then at another one, and then at the first
/// again: to count that one twice loses the edge.
TEST(ConstrainedOrderByHand, a_vertex_that_crossed_edges_come_back_to_is_counted_once) {
  const oracle::Points points{{2, 4.25}, {18, 0.625}, {17, 4.25}, {16, 3},  {13, 4.875},
                              {27, 1.5}, {22, 2.25},  {18, 1.5},  {21, 4.5}};
  expect_all(Instance(points), {{4, 8}});
}

/// A hole that touches the outline at 4: around the hole, both sides of 4 are reached.
TEST(ConstrainedOrderByHand, a_place_where_a_domain_touches_itself_is_counted_once) {
  const Instance instance({{1, 2.25}, {1, 0}, {3, 0}, {0, 1}, {2, 1}, {1, 1}});
  const Constrained all(instance, oracle::random_constraints(instance, 99, 1));
  Triangles inside, outside;
  for (const Triangle& t : all.delaunay())
    (std::ranges::count(t, 5) > 0 && std::ranges::count(t, 0) > 0 ? outside : inside).push_back(t);
  const Domain domain = oracle::domain_of(inside, outside);
  expect_all(instance, domain.edges, domain);
}

}  // namespace
}  // namespace hodt
