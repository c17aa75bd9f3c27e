#include "hodt/order/edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "../support/convert.h"
#include "../support/shapes.h"
#include <gtest/gtest.h>

#include "hodt/base/parallel.h"
#include "hodt/geometry/circle.h"
#include "hodt/geometry/predicates.h"
#include "hodt/order/segment_walk.h"
#include "hodt/order/useful_edges.h"

namespace hodt {

void PrintTo(const EdgeRecord& e, std::ostream* out) {
  *out << e.u << '-' << e.v << ':' << e.order;
}

namespace {

using Records = std::vector<EdgeRecord>;

constexpr std::array kClasses{EdgeClass::useful, EdgeClass::kod, EdgeClass::fixed,
                              EdgeClass::delaunay};

std::string name_of(EdgeClass edge_class) {
  if (edge_class == EdgeClass::useful) return "useful";
  if (edge_class == EdgeClass::kod) return "kod";
  return edge_class == EdgeClass::fixed ? "fixed" : "delaunay";
}

bool before(const EdgeRecord& a, const EdgeRecord& b) {
  return a.u != b.u ? a.u < b.u : a.v < b.v;
}

/// The records piece by piece, as the sink gets them.
std::vector<Records> pieces_of(const DelaunayGraph& graph, EdgeClass edge_class, Index k,
                               const Numbering& numbering) {
  std::vector<Records> pieces;
  for_each_edge(graph, edge_class, k, numbering, [&](std::span<const EdgeRecord> piece) {
    pieces.emplace_back(piece.begin(), piece.end());
  });
  return pieces;
}

/// All records; checks what the header says of every list.
Records list(const DelaunayGraph& graph, EdgeClass edge_class, Index k,
             const Numbering& numbering) {
  Records all;
  for (const Records& piece : pieces_of(graph, edge_class, k, numbering))
    all.insert(all.end(), piece.begin(), piece.end());
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_LT(all[i].u, all[i].v);
    EXPECT_LE(all[i].order, k);
    EXPECT_TRUE(i == 0 || before(all[i - 1], all[i])) << "not sorted, or found twice";
  }
  return all;
}

Records list(const DelaunayGraph& graph, EdgeClass edge_class, Index k) {
  return list(graph, edge_class, k, own_numbering(graph.xy.size()));
}

// ---- Small sets, against the oracle ----

/// Calls f(u, v) for all u < v, and lists those for which it gives an order of at most k.
template <class OrderOf>
Records pairs_of_order(int n, int k, const OrderOf& order_of) {
  Records records;
  for (int u = 0; u < n; ++u)
    for (int v = u + 1; v < n; ++v) {
      const std::optional<int> order = order_of(u, v);
      if (order && *order <= k) records.push_back({Index(u), Index(v), Index(*order)});
    }
  return records;
}

Records without_crossed(const oracle::Instance& instance, const Records& useful) {
  const auto crossed = [&](const EdgeRecord& e) {
    return std::any_of(useful.begin(), useful.end(), [&](const EdgeRecord& f) {
      return instance.segments_cross(int(e.u), int(e.v), int(f.u), int(f.v));
    });
  };
  Records fixed;
  std::copy_if(useful.begin(), useful.end(), std::back_inserter(fixed),
               [&](const EdgeRecord& e) { return !crossed(e); });
  return fixed;
}

std::set<oracle::Edge> edges_of(const oracle::Triangles& triangles) {
  std::set<oracle::Edge> edges;
  for (const auto& [a, b, c] : triangles)
    for (const auto& [u, v] : {std::pair{a, b}, {b, c}, {c, a}})
      edges.insert({std::min(u, v), std::max(u, v)});
  return edges;
}

Records expected_of(const oracle::Instance& instance, EdgeClass edge_class, int k) {
  const auto useful_order = [&](int u, int v) { return instance.useful_order_by_lemma(u, v); };
  if (edge_class == EdgeClass::useful) return pairs_of_order(instance.size(), k, useful_order);
  if (edge_class == EdgeClass::kod)
    return pairs_of_order(instance.size(), k,
                          [&](int u, int v) { return instance.edge_order(u, v); });
  if (edge_class == EdgeClass::fixed)
    return without_crossed(instance, pairs_of_order(instance.size(), k, useful_order));
  const auto edges = edges_of(instance.delaunay());
  return pairs_of_order(instance.size(), k, [&](int u, int v) {
    return edges.contains({u, v}) ? std::optional(0) : std::nullopt;
  });
}

std::set<oracle::Edge> pairs_of(const Records& records) {
  std::set<oracle::Edge> pairs;
  for (const auto& [u, v, order] : records) pairs.insert({int(u), int(v)});
  return pairs;
}

std::set<oracle::Edge> as_set(const std::vector<oracle::Edge>& edges) {
  return {edges.begin(), edges.end()};
}

class EdgeFamilies : public testing::TestWithParam<families::Family> {};

TEST_P(EdgeFamilies, equal_the_oracle_in_every_class) {
  for (const int n : {4, 5, 7, 9, 12}) {
    const Delaunay d = delaunay(support::to_point_set(GetParam().make(n, n + 70)));
    const DelaunayGraph graph(d);
    const oracle::Instance instance(support::to_oracle(d.vertices.xy));
    for (const EdgeClass edge_class : kClasses)
      for (int k = 0; k <= 6; ++k)
        ASSERT_EQ(list(graph, edge_class, Index(k)), expected_of(instance, edge_class, k))
            << name_of(edge_class) << " k " << k << ' ' << support::to_source(d.vertices.xy);
  }
}

/// Not by the lemma: by all triangulations there are.
TEST_P(EdgeFamilies, equal_the_catalogue_of_triangulations) {
  for (const int n : {6, 8}) {
    const Delaunay d = delaunay(support::to_point_set(GetParam().make(n, n + 80)));
    const DelaunayGraph graph(d);
    const oracle::Instance instance(support::to_oracle(d.vertices.xy));
    const oracle::Catalogue catalogue(instance);
    for (int k = 0; k <= 6; ++k) {
      const Records useful = pairs_of_order(
          instance.size(), k, [&](int u, int v) { return catalogue.useful_order(u, v); });
      ASSERT_EQ(list(graph, EdgeClass::useful, Index(k)), useful)
          << "k " << k << ' ' << support::to_source(d.vertices.xy);
      const Records fixed = list(graph, EdgeClass::fixed, Index(k));
      ASSERT_EQ(pairs_of(fixed), as_set(catalogue.fixed_edges(k)))
          << "k " << k << ' ' << support::to_source(d.vertices.xy);
      ASSERT_EQ(pairs_of(fixed), as_set(catalogue.edges_in_all(k)))
          << "k " << k << ' ' << support::to_source(d.vertices.xy);
    }
  }
}

TEST_P(EdgeFamilies, unrestricted_order_lists_every_free_segment) {
  const Delaunay d = delaunay(support::to_point_set(GetParam().make(12, 90)));
  const DelaunayGraph graph(d);
  const oracle::Instance instance(support::to_oracle(d.vertices.xy));
  for (const EdgeClass edge_class : {EdgeClass::useful, EdgeClass::kod})
    for (const int k : {9, 10, 12, 1000})
      ASSERT_EQ(list(graph, edge_class, Index(k)), expected_of(instance, edge_class, k))
          << "k " << k << ' ' << support::to_source(d.vertices.xy);
}

/// They are at most 3 (k + 1) n - 3 (k + 1) (k + 2) for k <= n / 2 - 2.
TEST_P(EdgeFamilies, are_within_the_bound_on_kod_edges) {
  for (const int n : {12, 30}) {
    if (GetParam().name == "wide_range" && n > 12) continue;
    const Delaunay d = delaunay(support::to_point_set(GetParam().make(n, 91)));
    const DelaunayGraph graph(d);
    const std::size_t size = graph.xy.size();
    for (Index k = 0; 2 * (k + 2) <= size; ++k)
      ASSERT_LE(list(graph, EdgeClass::kod, k).size(), 3 * (k + 1) * (size - (k + 2)))
          << "k " << k << ' ' << support::to_source(d.vertices.xy);
  }
}

TEST_P(EdgeFamilies, useful_order_of_any_two_vertices) {
  for (const int n : {5, 9, 14}) {
    const Delaunay d = delaunay(support::to_point_set(GetParam().make(n, n + 92)));
    const DelaunayGraph graph(d);
    const oracle::Instance instance(support::to_oracle(d.vertices.xy));
    UsefulEdgeSearch search(graph);
    for (int u = 0; u < instance.size(); ++u)
      for (int v = 0; v < instance.size(); ++v) {
        if (u == v) continue;
        const std::optional<int> known = instance.useful_order_by_lemma(u, v);
        for (const int limit : {0, 1, 2, 3, 5, 100}) {
          std::optional<Index> expected;
          if (known && *known <= limit) expected = Index(*known);
          ASSERT_EQ(search.useful_order(VertexId(Index(u)), VertexId(Index(v)), Index(limit)),
                    expected)
              << u << ' ' << v << " limit " << limit << ' ' << support::to_source(d.vertices.xy);
        }
      }
  }
}

/// The edges that the segment uv crosses, with the right end first; checks that each leads into
/// the triangle that the next one leaves.
std::set<oracle::Edge> crossed_edges(const DelaunayGraph& graph, VertexId u, VertexId v) {
  std::set<oracle::Edge> crossed;
  TriangleId entered;
  for_each_crossed(graph.mesh, graph.xy, graph.outgoing, u, v, [&](HalfEdgeId h) {
    EXPECT_TRUE(!entered.valid() || TriangleMesh::triangle(h) == entered);
    entered = TriangleMesh::triangle(graph.mesh.twin(h));
    crossed.insert({int(graph.mesh.origin(h)), int(graph.mesh.target(h))});
  });
  return crossed;
}

TEST_P(EdgeFamilies, a_segment_walk_meets_what_the_segment_crosses) {
  const Delaunay d = delaunay(support::to_point_set(GetParam().make(14, 93)));
  const DelaunayGraph graph(d);
  const oracle::Instance instance(support::to_oracle(d.vertices.xy));
  const auto delaunay_edges = edges_of(instance.delaunay());
  for (int u = 0; u < instance.size(); ++u)
    for (int v = 0; v < instance.size(); ++v) {
      if (u == v || !instance.is_segment_free(u, v)) continue;
      if (delaunay_edges.contains({std::min(u, v), std::max(u, v)})) continue;
      std::set<oracle::Edge> expected;
      for (const auto& [a, b] : delaunay_edges)
        if (instance.segments_cross(u, v, a, b))
          expected.insert(instance.orient(u, v, a) < 0 ? oracle::Edge{a, b} : oracle::Edge{b, a});
      ASSERT_EQ(crossed_edges(graph, VertexId(Index(u)), VertexId(Index(v))), expected)
          << u << ' ' << v << ' ' << support::to_source(d.vertices.xy);
    }
}

INSTANTIATE_TEST_SUITE_P(All, EdgeFamilies, testing::ValuesIn(families::all()),
                         [](const auto& each) { return each.param.name; });

// ---- A thousand points, against plain loops ----

int side_of(std::span<const Point> p, Index u, Index v, Index w) {
  return w == u || w == v ? 0 : orient(p[u], p[v], p[w]);
}

/// The circle through u, v and a point off their line.
Circle circle_of(std::span<const Point> p, Index u, Index v, Index w) {
  return side_of(p, u, v, w) > 0 ? Circle(p[u], p[v], p[w]) : Circle(p[v], p[u], p[w]);
}

bool passes_through_a_point(std::span<const Point> p, Index u, Index v) {
  const auto& [low, high] = std::minmax(p[u], p[v], lexicographically_less);
  return std::any_of(p.begin(), p.end(), [&, &low = low, &high = high](const Point& q) {
    return lexicographically_less(low, q) && lexicographically_less(q, high) &&
           orient(low, high, q) == 0;
  });
}

/// Lemma 4.
Index plain_useful_order(std::span<const Point> p, Index u, Index v) {
  std::array<Index, 2> first{kNone, kNone};  // on the left and on the right
  for (Index w = 0; w < p.size(); ++w) {
    const int side = side_of(p, u, v, w);
    if (side == 0) continue;
    Index& best = first[side < 0];
    if (best == kNone || circle_of(p, u, v, best).contains(p[w])) best = w;
  }
  if (first[0] == kNone || first[1] == kNone) return 0;
  Index order = 0;
  for (const Index w : first) {
    const Circle circle = circle_of(p, u, v, w);
    const auto inside =
        std::count_if(p.begin(), p.end(), [&](const Point& q) { return circle.contains(q); });
    order = std::max(order, static_cast<Index>(inside));
  }
  return order;
}

/// The cosine of the angle at w, squared.
double squared_cosine_at(const Point& w, const Point& u, const Point& v) {
  const double ux = u.x - w.x, uy = u.y - w.y, vx = v.x - w.x, vy = v.y - w.y;
  const double dot = ux * vx + uy * vy;
  return dot * dot / ((ux * ux + uy * uy) * (vx * vx + vy * vy));
}

/// Every circle through u and v holds one side of any given one: the left part if it bulges
/// further to the left, else the right part. So the lesser part of any circle bounds the order of
/// the edge from below; one whose diameter is about uv does it well.
Index lower_bound_of_order(std::span<const Point> p, Index u, Index v) {
  Index through = kNone;
  double least = 0;
  for (Index w = 0; w < p.size(); ++w) {
    if (side_of(p, u, v, w) == 0) continue;
    const double cosine = squared_cosine_at(p[w], p[u], p[v]);
    if (through != kNone && !(cosine < least)) continue;
    least = cosine;
    through = w;
  }
  const Circle circle = circle_of(p, u, v, through);
  std::array<Index, 2> inside{};
  for (Index w = 0; w < p.size(); ++w)
    if (circle.contains(p[w])) ++inside[side_of(p, u, v, w) < 0];
  return std::min(inside[0], inside[1]);
}

/// The least number of points in a circle through u and v. It is attained just beside one through
/// a third point, which then is outside: the least count over all third points. Vertices near in
/// the plane mostly have near numbers, so counting from u on exceeds the least early.
Index plain_edge_order(std::span<const Point> p, Index u, Index v, Index limit) {
  const auto n = static_cast<Index>(p.size());
  Index least = limit + 1;
  for (Index i = 0; i < n && least > 0; ++i) {
    const Index w = (u + i) % n;
    if (side_of(p, u, v, w) == 0) continue;
    const Circle circle = circle_of(p, u, v, w);
    Index inside = 0;
    for (Index j = 0; j < n && inside < least; ++j) inside += circle.contains(p[(u + j) % n]);
    least = std::min(least, inside);
  }
  return least;
}

using Ends = std::map<Index, Index>;  // other end -> order

Ends plain_ends(std::span<const Point> p, Index u, EdgeClass edge_class, Index limit) {
  Ends ends;
  for (Index v = 0; v < p.size(); ++v) {
    if (v == u || passes_through_a_point(p, u, v)) continue;
    const bool useful = edge_class == EdgeClass::useful;
    if (!useful && lower_bound_of_order(p, u, v) > limit) continue;
    const Index order = useful ? plain_useful_order(p, u, v) : plain_edge_order(p, u, v, limit);
    if (order <= limit) ends.emplace(v, order);
  }
  return ends;
}

Ends ends_at(const Records& records, Index w, Index limit) {
  Ends ends;
  for (const auto& [u, v, order] : records)
    if ((u == w || v == w) && order <= limit) ends.emplace(u == w ? v : u, order);
  return ends;
}

/// A vertex at (x, 0) with all of 140 around it for neighbours: nearly on a circle, but too far
/// from it for exact arithmetic, which would make plain loops slow.
support::Points hub(double x) {
  families::Random random(11);
  support::Points points{{x, 0}};
  for (int i = 0; i < 140; ++i) {
    const double angle = 2 * std::numbers::pi * (i + random.real(0, 0.2)) / 140;
    const double radius = 1 + random.real(0, 1e-5);
    points.push_back({x + radius * std::cos(angle), radius * std::sin(angle)});
  }
  return points;
}

/// Two of them, who have neighbours in common.
support::Points two_hubs() {
  support::Points points = hub(0);
  for (const Point& p : hub(2.001)) points.push_back(p);
  return points;
}

support::Points fan() {
  return support::to_point_set(families::fan(200, 11)).xy;
}

class ThousandPoints : public testing::TestWithParam<support::Shape> {
 protected:
  /// The lists for k = 1, 4 and 10, seen from some vertices.
  void expect_plain(EdgeClass edge_class, int vertices) const {
    constexpr Index kLimit = 10;
    std::map<Index, Records> lists;
    for (const Index k : {1, 4, 10}) {
      lists[k] = list(graph_, edge_class, k);
      ASSERT_EQ(list(listed(), edge_class, k), lists[k]) << "k " << k;
    }
    families::Random random(7);
    for (int i = 0; i < vertices; ++i) {
      const auto u =
          i == 0 ? of_highest_degree() : static_cast<Index>(random.bits() % graph_.xy.size());
      const Ends expected = plain_ends(graph_.xy, u, edge_class, kLimit);
      for (const auto& [k, records] : lists) {
        Ends within = expected;
        std::erase_if(within, [k = k](const auto& end) { return end.second > k; });
        ASSERT_EQ(ends_at(records, u, kLimit), within) << "k " << k << " from " << u;
      }
    }
  }

  DelaunayGraph listed() const {
    DelaunayGraph graph(delaunay_);
    graph.list_neighbours();
    return graph;
  }

  Index of_highest_degree() const {
    std::vector<Index> degree(graph_.xy.size(), 0);
    for (const Index v : delaunay_.mesh.origins()) ++degree[v];
    return static_cast<Index>(std::max_element(degree.begin(), degree.end()) - degree.begin());
  }

  Delaunay delaunay_ = delaunay({GetParam().make(), {}});
  DelaunayGraph graph_{delaunay_};
};

TEST_P(ThousandPoints, useful_edges_equal_lemma_4) {
  expect_plain(EdgeClass::useful, 30);
}

TEST_P(ThousandPoints, kod_edges_equal_the_least_count_of_all_circles) {
  expect_plain(EdgeClass::kod, 10);
}

TEST_P(ThousandPoints, fixed_edges_are_the_useful_ones_that_none_crosses) {
  const auto crosses = [&](const EdgeRecord& e, const EdgeRecord& f) {
    const auto &a = graph_.xy[e.u], &b = graph_.xy[e.v], &c = graph_.xy[f.u], &d = graph_.xy[f.v];
    if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
        std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y))
      return false;
    return orient(a, b, c) * orient(a, b, d) < 0 && orient(c, d, a) * orient(c, d, b) < 0;
  };
  for (const Index k : {1, 4, 10}) {
    const Records useful = list(graph_, EdgeClass::useful, k);
    Records expected;
    for (const EdgeRecord& e : useful)
      if (std::none_of(useful.begin(), useful.end(),
                       [&](const EdgeRecord& f) { return crosses(e, f); }))
        expected.push_back(e);
    ASSERT_EQ(list(graph_, EdgeClass::fixed, k), expected) << "k " << k;
    ASSERT_EQ(list(listed(), EdgeClass::fixed, k), expected) << "k " << k;
  }
}

TEST_P(ThousandPoints, delaunay_edges_are_those_of_the_mesh) {
  std::set<oracle::Edge> expected = edges_of(support::triangles_of(delaunay_.mesh));
  for (const Index k : {0, 4}) {
    const Records found = list(graph_, EdgeClass::delaunay, k);
    ASSERT_EQ(pairs_of(found), expected);
    ASSERT_TRUE(std::all_of(found.begin(), found.end(), [](auto& e) { return e.order == 0; }));
  }
  ASSERT_EQ(list(graph_, EdgeClass::kod, 0), list(graph_, EdgeClass::delaunay, 0));
  ASSERT_EQ(list(graph_, EdgeClass::useful, 0), list(graph_, EdgeClass::delaunay, 0));
}

/// A larger order only adds edges.
TEST_P(ThousandPoints, a_list_is_the_beginning_of_the_next) {
  for (const EdgeClass edge_class : {EdgeClass::useful, EdgeClass::kod}) {
    const Records all = list(graph_, edge_class, 6);
    for (const Index k : {1, 3}) {
      Records within = all;
      std::erase_if(within, [&](const EdgeRecord& e) { return e.order > k; });
      ASSERT_EQ(list(graph_, edge_class, k), within) << "k " << k;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, ThousandPoints,
    testing::Values(support::Shape{"uniform", [] { return support::uniform(1000, 1); }},
                    support::Shape{"lattice", [] { return support::lattice(32, 32); }},
                    support::Shape{"clustered", [] { return support::clustered(1000, 2); }},
                    support::Shape{"hub", [] { return hub(0); }},
                    support::Shape{"two_hubs", two_hubs}, support::Shape{"fan", fan}),
    [](const auto& each) { return each.param.name; });

// ---- Numbers, threads, densities ----

struct Input {
  PointSet points;
  std::vector<Index> kept;  // rows that are not duplicates, in the order of the distinct points
};

/// The points in any order, some of them twice or three times with other heights.
Input with_duplicates(const families::Points& distinct, std::uint64_t seed) {
  families::Random random(seed);
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < distinct.size(); ++i)
    for (int copies = random.integer(1, 3); copies > 0; --copies) places.push_back(i);
  random.shuffle(places);
  Input input;
  input.kept.assign(distinct.size(), kNone);
  for (const std::size_t i : places) {
    const auto row = static_cast<Index>(input.points.size());
    input.points.xy.push_back({distinct[i].first, distinct[i].second});
    input.points.z.push_back(random.integer(0, 2));
    Index& kept = input.kept[i];  // the lowest, the first of those
    if (kept == kNone || input.points.z[row] < input.points.z[kept]) kept = row;
  }
  return input;
}

TEST(Edges, are_numbered_as_the_rows_of_the_input) {
  for (const auto& distinct :
       {families::random_square(12, 1), families::lattice(4, 3), families::outline(11, 2)}) {
    const oracle::Instance instance(distinct);
    for (const std::uint64_t seed : {3, 4, 5}) {
      const Input input = with_duplicates(distinct, seed);
      const Delaunay d = delaunay(input.points);
      const DelaunayGraph graph(d);
      const Numbering rows = row_numbering(d.vertices, input.points.size());
      for (const EdgeClass edge_class : kClasses)
        for (const int k : {0, 2, 5}) {
          Records expected = expected_of(instance, edge_class, k);
          for (auto& [u, v, order] : expected) {
            u = input.kept[u], v = input.kept[v];
            if (v < u) std::swap(u, v);
          }
          std::sort(expected.begin(), expected.end(), before);
          ASSERT_EQ(list(graph, edge_class, Index(k), rows), expected);
        }
    }
  }
}

void expect_ascending(const Numbering& numbering, std::size_t vertices) {
  ASSERT_EQ(numbering.number.size(), vertices);
  ASSERT_EQ(numbering.ascending.size(), vertices);
  std::set<Index> seen;
  for (std::size_t i = 0; i < vertices; ++i) {
    seen.insert(numbering.ascending[i]);
    if (i == 0) continue;
    ASSERT_LT(numbering.number[numbering.ascending[i - 1]],
              numbering.number[numbering.ascending[i]]);
  }
  ASSERT_EQ(seen.size(), vertices);
}

TEST(Numbering, lists_the_vertices_by_their_numbers) {
  const Input input = with_duplicates(families::random_square(200, 6), 7);
  const Delaunay d = delaunay(input.points);
  const Numbering own = own_numbering(d.vertices.size());
  const Numbering rows = row_numbering(d.vertices, input.points.size());
  expect_ascending(own, d.vertices.size());
  expect_ascending(rows, d.vertices.size());
  for (Index v = 0; v < d.vertices.size(); ++v) {
    EXPECT_EQ(own.number[v], v);
    EXPECT_EQ(rows.number[v], d.vertices.row[v]);
  }
}

class EdgeStream : public testing::TestWithParam<EdgeClass> {};

TEST_P(EdgeStream, is_the_same_on_any_number_of_threads_and_with_listed_neighbours) {
  for (const support::Points& points :
       {support::uniform(5000, 8), support::shuffled(support::lattice(50, 50), 9)}) {
    const Delaunay d = delaunay({points, {}});
    const DelaunayGraph plain(d);
    DelaunayGraph listed(d);
    listed.list_neighbours();
    for (const Numbering& numbering :
         {own_numbering(points.size()), row_numbering(d.vertices, points.size())}) {
      const auto pieces = [&](const DelaunayGraph& graph, std::size_t threads) {
        const ThreadLimit limit(threads);
        return pieces_of(graph, GetParam(), 3, numbering);
      };
      const auto expected = pieces(plain, 1);
      EXPECT_TRUE(pieces(plain, 2) == expected);
      EXPECT_TRUE(pieces(listed, 1) == expected);
      EXPECT_TRUE(pieces(listed, 2) == expected);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Classes, EdgeStream, testing::ValuesIn(kClasses),
                         [](const auto& each) { return name_of(each.param); });

/// Edges of each order or less for a point far from the border, an edge counted half for each end
/// there.
std::vector<double> densities(const DelaunayGraph& graph, EdgeClass edge_class, Index k) {
  const auto is_inner = [&](Index v) {
    const Point& p = graph.xy[v];
    return std::min({p.x, p.y, 1 - p.x, 1 - p.y}) >= 0.05;
  };
  double inner = 0;
  for (Index v = 0; v < graph.xy.size(); ++v) inner += is_inner(v);
  std::vector<double> density(k + 1, 0);
  for_each_edge(graph, edge_class, k, own_numbering(graph.xy.size()),
                [&](std::span<const EdgeRecord> piece) {
                  for (const auto& [u, v, order] : piece)
                    density[order] += (is_inner(u) + is_inner(v)) / (2 * inner);
                });
  for (Index order = 1; order <= k; ++order) density[order] += density[order - 1];
  return density;
}

TEST(Edges, densities_in_uniform_points_are_the_known_ones) {
  const std::map<Index, double> useful{{0, 3},    {1, 3.526}, {2, 4.087},
                                       {3, 4.56}, {4, 4.95},  {8, 6.17}};
  const std::map<Index, double> kod{{0, 3}, {1, 5.47}, {2, 7.81}, {3, 10.07}, {4, 12.30}};
  const Delaunay d = delaunay({support::uniform(100000, 10), {}});
  DelaunayGraph graph(d);
  graph.list_neighbours();
  const auto useful_found = densities(graph, EdgeClass::useful, 8);
  for (const auto& [k, density] : useful)
    EXPECT_NEAR(useful_found[k], density, 0.01 * density) << "useful, k " << k;
  const auto kod_found = densities(graph, EdgeClass::kod, 4);
  for (const auto& [k, density] : kod)
    EXPECT_NEAR(kod_found[k], density, 0.01 * density) << "kod, k " << k;
}

}  // namespace
}  // namespace hodt
