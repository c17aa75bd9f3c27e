#include "hodt/order/triangles.h"

#include <algorithm>
#include <array>
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
#include "hodt/order/useful_edges.h"

namespace hodt {

void PrintTo(const TriangleRecord& t, std::ostream* out) {
  *out << t.a << '-' << t.b << '-' << t.c << ':' << t.order;
}

namespace {

using Records = std::vector<TriangleRecord>;

constexpr std::array kClasses{TriangleClass::kod, TriangleClass::valid};

std::array<Index, 3> corners_of(const TriangleRecord& t) {
  return {t.a, t.b, t.c};
}

bool before(const TriangleRecord& s, const TriangleRecord& t) {
  return corners_of(s) < corners_of(t);
}

/// The records piece by piece, as the sink gets them.
std::vector<Records> pieces_of(const DelaunayGraph& graph, TriangleClass triangle_class, Index k,
                               const Numbering& numbering) {
  std::vector<Records> pieces;
  for_each_triangle(graph, triangle_class, k, numbering,
                    [&](std::span<const TriangleRecord> piece) {
                      pieces.emplace_back(piece.begin(), piece.end());
                    });
  return pieces;
}

/// All records; checks what the header says of every list.
Records list(const DelaunayGraph& graph, TriangleClass triangle_class, Index k,
             const Numbering& numbering) {
  Records all;
  for (const Records& piece : pieces_of(graph, triangle_class, k, numbering))
    all.insert(all.end(), piece.begin(), piece.end());
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_TRUE(all[i].a < all[i].b && all[i].b < all[i].c);
    EXPECT_LE(all[i].order, k);
    EXPECT_TRUE(i == 0 || before(all[i - 1], all[i])) << "not sorted, or found twice";
  }
  return all;
}

Records list(const DelaunayGraph& graph, TriangleClass triangle_class, Index k) {
  return list(graph, triangle_class, k, own_numbering(graph.xy.size()));
}

// ---- Small sets, against the oracle ----

/// The least k for which the triangle is valid; empty if it is for none.
std::optional<int> valid_order(const oracle::Instance& instance, int a, int b, int c) {
  if (!instance.is_triangle_empty(a, b, c)) return std::nullopt;
  int order = instance.triangle_order(a, b, c);
  for (const auto& [u, v] : {std::pair{a, b}, {b, c}, {a, c}}) {
    const std::optional<int> useful = instance.useful_order_by_lemma(u, v);
    if (!useful) return std::nullopt;
    order = std::max(order, *useful);
  }
  return order;
}

Records expected_of(const oracle::Instance& instance, TriangleClass triangle_class, int k) {
  Records records;
  for (int a = 0; a < instance.size(); ++a)
    for (int b = a + 1; b < instance.size(); ++b)
      for (int c = b + 1; c < instance.size(); ++c) {
        if (instance.orient(a, b, c) == 0) continue;
        const std::optional<int> order = triangle_class == TriangleClass::kod
                                             ? instance.triangle_order(a, b, c)
                                             : valid_order(instance, a, b, c);
        if (order && *order <= k) records.push_back({Index(a), Index(b), Index(c), Index(*order)});
      }
  return records;
}

std::set<std::array<int, 3>> ascending_corners(const oracle::Triangles& triangles) {
  std::set<std::array<int, 3>> sets;
  for (oracle::Triangle t : triangles) {
    std::sort(t.begin(), t.end());
    sets.insert(t);
  }
  return sets;
}

std::set<std::array<int, 3>> corner_sets(const Records& records) {
  std::set<std::array<int, 3>> sets;
  for (const auto& [a, b, c, order] : records) sets.insert({int(a), int(b), int(c)});
  return sets;
}

class TriangleFamilies : public testing::TestWithParam<families::Family> {};

TEST_P(TriangleFamilies, equal_the_oracle_in_both_classes) {
  for (const int n : {4, 5, 7, 9, 12}) {
    const Delaunay d = delaunay(support::to_point_set(GetParam().make(n, n + 20)));
    const DelaunayGraph graph(d);
    const oracle::Instance instance(support::to_oracle(d.vertices.xy));
    for (const TriangleClass triangle_class : kClasses)
      for (const int k : {0, 1, 2, 3, 4, 5, 6, n - 3, 1000})
        ASSERT_EQ(list(graph, triangle_class, Index(k)), expected_of(instance, triangle_class, k))
            << "class " << int(triangle_class) << " k " << k << ' '
            << support::to_source(d.vertices.xy);
  }
}

/// With edges that are useful not by the lemma but because a triangulation has them.
TEST_P(TriangleFamilies, valid_ones_equal_the_catalogue_of_triangulations) {
  for (const int n : {6, 8}) {
    const Delaunay d = delaunay(support::to_point_set(GetParam().make(n, n + 30)));
    const DelaunayGraph graph(d);
    const oracle::Instance instance(support::to_oracle(d.vertices.xy));
    const oracle::Catalogue catalogue(instance);
    for (int k = 0; k <= 6; ++k)
      ASSERT_EQ(corner_sets(list(graph, TriangleClass::valid, Index(k))),
                ascending_corners(catalogue.valid_triangles(k)))
          << "k " << k << ' ' << support::to_source(d.vertices.xy);
  }
}

TEST_P(TriangleFamilies, of_order_0_are_the_delaunay_triangles) {
  for (const int n : {12, 40}) {
    if (GetParam().name == "wide_range" && n > 12) continue;
    const Delaunay d = delaunay(support::to_point_set(GetParam().make(n, n + 40)));
    const DelaunayGraph graph(d);
    const auto expected = ascending_corners(support::triangles_of(d.mesh));
    for (const TriangleClass triangle_class : kClasses)
      ASSERT_EQ(corner_sets(list(graph, triangle_class, 0)), expected)
          << support::to_source(d.vertices.xy);
  }
}

INSTANTIATE_TEST_SUITE_P(All, TriangleFamilies, testing::ValuesIn(families::all()),
                         [](const auto& each) { return each.param.name; });

// ---- A hundred points, against plain loops ----

/// With a, b, c counter-clockwise: whether another point is inside or on a side.
bool holds_a_point(std::span<const Point> p, Index a, Index b, Index c) {
  for (Index q = 0; q < p.size(); ++q)
    if (q != a && q != b && q != c && orient(p[a], p[b], p[q]) >= 0 &&
        orient(p[b], p[c], p[q]) >= 0 && orient(p[c], p[a], p[q]) >= 0)
      return true;
  return false;
}

/// The useful orders of all pairs; empty for no edge. That they are right is tested elsewhere.
std::vector<std::vector<std::optional<Index>>> useful_orders(const DelaunayGraph& graph) {
  const auto n = static_cast<Index>(graph.xy.size());
  using Row = std::vector<std::optional<Index>>;
  std::vector<Row> orders(n, Row(n));
  UsefulEdgeSearch search(graph);
  for (Index u = 0; u < n; ++u)
    for (Index v = 0; v < n; ++v)
      if (u != v) orders[u][v] = search.useful_order(VertexId(u), VertexId(v), n);
  return orders;
}

class HundredPoints : public testing::TestWithParam<support::Shape> {
 protected:
  /// All triples whose circle holds at most `limit` points, by trying all.
  Records plain_kod(Index limit) const {
    const std::span<const Point> p = graph_.xy;
    Records records;
    for (Index a = 0; a < p.size(); ++a)
      for (Index b = a + 1; b < p.size(); ++b)
        for (Index c = b + 1; c < p.size(); ++c) {
          const int turn = orient(p[a], p[b], p[c]);
          if (turn == 0) continue;
          const Circle circle = turn > 0 ? Circle(p[a], p[b], p[c]) : Circle(p[b], p[a], p[c]);
          Index inside = 0;
          for (Index q = 0; q < p.size() && inside <= limit; ++q) inside += circle.contains(p[q]);
          if (inside <= limit) records.push_back({a, b, c, inside});
        }
    return records;
  }

  Records valid_of(const Records& kod) const {
    const auto useful = useful_orders(graph_);
    Records valid;
    for (auto [a, b, c, order] : kod) {
      const bool left = orient(graph_.xy[a], graph_.xy[b], graph_.xy[c]) > 0;
      if (holds_a_point(graph_.xy, a, left ? b : c, left ? c : b)) continue;
      const auto &ab = useful[a][b], &bc = useful[b][c], &ac = useful[a][c];
      if (ab && bc && ac) valid.push_back({a, b, c, std::max({order, *ab, *bc, *ac})});
    }
    return valid;
  }

  Delaunay delaunay_ = delaunay({GetParam().make(), {}});
  DelaunayGraph graph_{delaunay_};
};

TEST_P(HundredPoints, equal_all_triples_tried) {
  constexpr Index kLimit = 12;
  const Records kod = plain_kod(kLimit), valid = valid_of(kod);
  for (const Index k : {1, 4, 8, 12})
    for (const TriangleClass triangle_class : kClasses) {
      Records expected = triangle_class == TriangleClass::kod ? kod : valid;
      std::erase_if(expected, [&](const TriangleRecord& t) { return t.order > k; });
      ASSERT_EQ(list(graph_, triangle_class, k), expected)
          << "class " << int(triangle_class) << " k " << k;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, HundredPoints,
    testing::Values(
        support::Shape{"uniform", [] { return support::uniform(110, 1); }},
        support::Shape{"lattice", [] { return support::lattice(11, 10); }},
        support::Shape{"utm_lattice", [] { return support::utm_lattice(10, 11); }},
        support::Shape{"clustered", [] { return support::clustered(110, 2); }},
        support::Shape{
            "ring", [] { return support::to_point_set(families::ring(60, 1, 32045, true)).xy; }}),
    [](const auto& each) { return each.param.name; });

/// Of n points, no three on a line, the circles with k points inside and those with k outside
/// are 2 (k + 1) (n - 2 - k) together (Ardila, Lee).
TEST(Triangles, circles_with_k_points_inside_and_outside_add_up) {
  for (const support::Points& points : {support::uniform(60, 3), support::clustered(51, 4)}) {
    const Delaunay d = delaunay({points, {}});
    const auto n = static_cast<Index>(points.size());
    std::vector<Index> circles(n - 2, 0);
    for (const TriangleRecord& t : list(DelaunayGraph(d), TriangleClass::kod, n))
      ++circles.at(t.order);
    for (Index k = 0; k <= n - 3; ++k)
      EXPECT_EQ(circles[k] + circles[n - 3 - k], 2 * (k + 1) * (n - 2 - k)) << "k " << k;
  }
}

// ---- Numbers and threads ----

TEST(Triangles, are_numbered_as_the_rows_of_the_input) {
  for (const auto& distinct : {families::random_square(12, 5), families::lattice(4, 3)}) {
    // Every point twice, in any order: the one with the lower height stays.
    PointSet points;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < 2 * distinct.size(); ++i) places.push_back(i);
    families::Random(6).shuffle(places);
    std::vector<Index> kept(distinct.size());
    for (const std::size_t place : places) {
      const auto& [x, y] = distinct[place / 2];
      if (place % 2 == 0) kept[place / 2] = static_cast<Index>(points.size());
      points.xy.push_back({x, y});
      points.z.push_back(double(place % 2));
    }
    const oracle::Instance instance(distinct);
    const Delaunay d = delaunay(points);
    const DelaunayGraph graph(d);
    const Numbering rows = row_numbering(d.vertices, points.size());
    for (const TriangleClass triangle_class : kClasses)
      for (const int k : {0, 2, 5}) {
        Records expected;
        for (const TriangleRecord& t : expected_of(instance, triangle_class, k)) {
          std::array corners{kept[t.a], kept[t.b], kept[t.c]};
          std::sort(corners.begin(), corners.end());
          expected.push_back({corners[0], corners[1], corners[2], t.order});
        }
        std::sort(expected.begin(), expected.end(), before);
        ASSERT_EQ(list(graph, triangle_class, Index(k), rows), expected);
      }
  }
}

TEST(Triangles, are_the_same_on_any_number_of_threads_and_with_listed_neighbours) {
  for (const support::Points& points :
       {support::uniform(3000, 7), support::shuffled(support::lattice(40, 40), 8)}) {
    const Delaunay d = delaunay({points, {}});
    const DelaunayGraph plain(d);
    DelaunayGraph listed(d);
    listed.list_neighbours();
    for (const TriangleClass triangle_class : kClasses)
      for (const Numbering& numbering :
           {own_numbering(points.size()), row_numbering(d.vertices, points.size())}) {
        const auto pieces = [&](const DelaunayGraph& graph, std::size_t threads) {
          const ThreadLimit limit(threads);
          return pieces_of(graph, triangle_class, 3, numbering);
        };
        const auto expected = pieces(plain, 1);
        EXPECT_TRUE(pieces(plain, 2) == expected);
        EXPECT_TRUE(pieces(listed, 2) == expected);
      }
  }
}

/// A valid triangle is a k-OD triangle, and its order never the lesser.
TEST(Triangles, valid_ones_are_kod) {
  const Delaunay d = delaunay({support::uniform(3000, 9), {}});
  const DelaunayGraph graph(d);
  const Records kod = list(graph, TriangleClass::kod, 5);
  for (const TriangleRecord& t : list(graph, TriangleClass::valid, 5)) {
    const auto found = std::lower_bound(kod.begin(), kod.end(), t, before);
    ASSERT_TRUE(found != kod.end() && corners_of(*found) == corners_of(t));
    ASSERT_LE(found->order, t.order);
  }
}

}  // namespace
}  // namespace hodt
