#include "hodt/order/voronoi/voronoi.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "../support/connectivity_problem.h"
#include "../support/convert.h"
#include "../support/shapes.h"
#include <gtest/gtest.h>

#include "hodt/base/error.h"

namespace hodt {
namespace {

using Set = std::vector<int>;

Set with(Set set, std::initializer_list<int> more) {
  set.insert(set.end(), more);
  std::sort(set.begin(), set.end());
  return set;
}

/// A diagram as sets: nothing in it depends on how things are numbered.
struct Sets {
  std::set<Set> cells;
  /// The three sites, and whether it is new.
  std::set<std::pair<Set, bool>> vertices;
  /// The two sites and the points inside the circles along the edge.
  std::set<std::pair<std::array<int, 2>, Set>> edges;

  friend bool operator==(const Sets&, const Sets&) = default;
};

// ---- By brute force, from circles alone ----

struct Triple {
  int a, b, c;
  Set inside;
};

std::vector<Triple> all_triples(const oracle::Instance& instance) {
  std::vector<Triple> triples;
  for (int a = 0; a < instance.size(); ++a)
    for (int b = a + 1; b < instance.size(); ++b)
      for (int c = b + 1; c < instance.size(); ++c) {
        if (instance.orient(a, b, c) == 0) continue;
        Triple triple{a, b, c, {}};
        for (int p = 0; p < instance.size(); ++p)
          if (p != a && p != b && p != c && instance.in_circle(a, b, c, p) > 0)
            triple.inside.push_back(p);
        triples.push_back(std::move(triple));
      }
  return triples;
}

/// Circles through u and v, swept from the half-plane right of uv to that left of it.
void add_edges_on_bisector(const oracle::Instance& instance, int u, int v, int m, Sets& sets) {
  std::vector<int> met;
  std::set<int> inside;
  for (int w = 0; w < instance.size(); ++w) {
    const int side = instance.orient(u, v, w);
    if (side != 0) met.push_back(w);
    const auto &p = instance.points()[w], &a = instance.points()[u], &b = instance.points()[v];
    const bool between = side == 0 && std::min(a, b) < p && p < std::max(a, b);
    if (side < 0 || between) inside.insert(w);
  }
  std::sort(met.begin(), met.end(), [&](int a, int b) {
    if (a == b) return false;
    return instance.orient(u, v, b) > 0 ? instance.in_circle(u, v, a, b) < 0
                                        : instance.in_circle(u, v, a, b) > 0;
  });
  for (std::size_t i = 0; i <= met.size(); ++i) {
    if (static_cast<int>(inside.size()) == m - 1)
      sets.edges.insert({{u, v}, Set(inside.begin(), inside.end())});
    if (i == met.size()) break;
    if (instance.orient(u, v, met[i]) > 0) {
      inside.insert(met[i]);
    } else {
      inside.erase(met[i]);
    }
  }
}

Sets by_brute_force(const oracle::Instance& instance, const std::vector<Triple>& triples, int m) {
  Sets sets;
  for (const auto& [a, b, c, inside] : triples) {
    const int count = static_cast<int>(inside.size());
    if (count != m - 1 && count != m - 2) continue;
    sets.vertices.insert({{a, b, c}, count == m - 1});
    if (count == m - 1) {
      for (const int site : {a, b, c}) sets.cells.insert(with(inside, {site}));
    } else {
      sets.cells.insert(with(inside, {a, b}));
      sets.cells.insert(with(inside, {b, c}));
      sets.cells.insert(with(inside, {c, a}));
    }
  }
  for (int u = 0; u < instance.size(); ++u)
    for (int v = u + 1; v < instance.size(); ++v) add_edges_on_bisector(instance, u, v, m, sets);
  return sets;
}

// ---- By hodt ----

Set as_set(std::span<const VertexId> members) {
  EXPECT_TRUE(std::is_sorted(members.begin(), members.end()));
  return {members.begin(), members.end()};
}

/// The points of a cell at corner h of a triangle, less those that are not inside the circle.
void expect_corner_fits(const VoronoiDiagram& diagram, HalfEdgeId h) {
  const Set cell = as_set(diagram.members_of(diagram.dual.origin(h)));
  const auto has = [&](HalfEdgeId g) {
    return std::binary_search(cell.begin(), cell.end(), static_cast<int>(diagram.sites[g]));
  };
  const bool is_new = diagram.is_new(TriangleMesh::triangle(h));
  EXPECT_EQ(has(h), is_new);
  EXPECT_EQ(has(TriangleMesh::next(h)), !is_new);
  EXPECT_EQ(has(TriangleMesh::prev(h)), !is_new);
}

Sets sets_of(const VoronoiDiagram& diagram) {
  Sets sets;
  EXPECT_EQ(connectivity_problem(diagram.dual, Surface::disk), "");
  for (Index cell = 0; cell < diagram.cell_count(); ++cell)
    EXPECT_TRUE(sets.cells.insert(as_set(diagram.members_of(cell))).second) << "a cell twice";
  for (Index t = 0; t < diagram.dual.triangle_count(); ++t) {
    Set sites;
    for (Index h = 3 * t; h < 3 * t + 3; ++h) {
      sites.push_back(static_cast<int>(diagram.sites[h]));
      expect_corner_fits(diagram, HalfEdgeId(h));
    }
    EXPECT_TRUE(sets.vertices.insert({with(sites, {}), diagram.is_new(TriangleId(t))}).second);
  }
  for (Index i = 0; i < diagram.dual.halfedge_count(); ++i) {
    const HalfEdgeId h(i), twin = diagram.dual.twin(h);
    if (twin.valid() && twin < h) continue;
    const auto u = static_cast<int>(diagram.leaving(h)), v = static_cast<int>(diagram.entering(h));
    const Set from = as_set(diagram.members_of(diagram.dual.origin(h)));
    const Set to = as_set(diagram.members_of(diagram.dual.target(h)));
    Set inside;
    std::set_intersection(from.begin(), from.end(), to.begin(), to.end(),
                          std::back_inserter(inside));
    EXPECT_EQ(from, with(inside, {u}));
    EXPECT_EQ(to, with(inside, {v}));
    EXPECT_TRUE(sets.edges.insert({{std::min(u, v), std::max(u, v)}, inside}).second);
  }
  return sets;
}

std::set<std::array<int, 2>> pairs_of(const VoronoiDiagram& diagram) {
  std::set<std::array<int, 2>> pairs;
  for (const auto& [u, v] : bisector_pairs(diagram))
    pairs.insert({static_cast<int>(u), static_cast<int>(v)});
  return pairs;
}

/// Lemma 2, for the pairs to which it applies.
void expect_lemma_2(const oracle::Instance& instance, const VoronoiDiagram& diagram,
                    const std::string& what) {
  const int k = static_cast<int>(diagram.order) - 1;
  const auto pairs = pairs_of(diagram);
  for (int u = 0; u < instance.size(); ++u)
    for (int v = u + 1; v < instance.size(); ++v) {
      if (!instance.is_segment_free(u, v)) continue;
      int left = 0, right = 0;
      for (int w = 0; w < instance.size(); ++w) {
        left += instance.orient(u, v, w) > 0;
        right += instance.orient(u, v, w) < 0;
      }
      if (std::max(left, right) < k) continue;
      ASSERT_EQ(pairs.contains({u, v}), *instance.edge_order(u, v) <= k)
          << u << ' ' << v << ' ' << what;
    }
}

class VoronoiFamilies : public testing::TestWithParam<families::Family> {};

TEST_P(VoronoiFamilies, equal_brute_force) {
  const int largest = GetParam().name == "wide_range" ? 9 : 14;
  for (int n = 4; n <= largest; ++n) {
    for (int seed = 0; seed < (n < 9 ? 6 : 2); ++seed) {
      const Delaunay d = delaunay(support::to_point_set(GetParam().make(n, 100 * n + seed)));
      const DelaunayGraph graph(d);
      const oracle::Instance instance(support::to_oracle(d.vertices.xy));
      const std::vector<Triple> triples = all_triples(instance);
      for (int m = 1; m < instance.size(); ++m) {
        const std::string what = "m " + std::to_string(m) + ' ' + support::to_source(d.vertices.xy);
        const VoronoiDiagram diagram = voronoi_diagram(graph, Index(m));
        ASSERT_EQ(diagram.order, Index(m));
        const Sets found = sets_of(diagram), expected = by_brute_force(instance, triples, m);
        ASSERT_EQ(found.cells, expected.cells) << what;
        ASSERT_EQ(found.vertices, expected.vertices) << what;
        ASSERT_EQ(found.edges, expected.edges) << what;
        ASSERT_NO_FATAL_FAILURE(expect_lemma_2(instance, diagram, what));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, VoronoiFamilies, testing::ValuesIn(families::all()),
                         [](const auto& each) { return each.param.name; });

TEST(Voronoi, refuses_orders_without_a_diagram) {
  const Delaunay d = delaunay({support::lattice(2, 2), {}});
  const DelaunayGraph graph(d);
  for (const Index order : {0u, 4u, 5u, kNone})
    EXPECT_THROW(voronoi_diagram(graph, order), ParameterError) << order;
  EXPECT_EQ(voronoi_diagram(graph, 3).cell_count(), 4u);  // of the furthest point
}

/// Lee's formula, for which every unbounded cell of a lower order counts too.
TEST(Voronoi, has_as_many_cells_as_lee_says) {
  for (const support::Points& points :
       {support::uniform(1000, 1), support::lattice(32, 32), support::clustered(1000, 2),
        support::cocircular_rings(4), support::utm_lattice(32, 32)}) {
    const Delaunay d = delaunay({points, {}});
    const DelaunayGraph graph(d);
    const auto n = static_cast<long>(points.size());
    long unbounded_before = 0;
    for (long m = 1; m <= 12; ++m) {
      const VoronoiDiagram diagram = voronoi_diagram(graph, Index(m));
      ASSERT_EQ(connectivity_problem(diagram.dual, Surface::disk), "");
      const auto cells = static_cast<long>(diagram.cell_count());
      EXPECT_EQ(cells, (2 * m - 1) * n - (m * m - 1) - unbounded_before) << m;
      for (Index h = 0; h < diagram.dual.halfedge_count(); ++h)
        unbounded_before += diagram.dual.is_boundary(HalfEdgeId(h));
    }
  }
}

/// A hub that nearly all cells contain, and cells with as many corners as there are points.
TEST(Voronoi, of_a_star_takes_no_quadratic_time) {
  const Delaunay d = delaunay(support::to_point_set(families::star(20000, 1)));
  const VoronoiDiagram diagram = voronoi_diagram(DelaunayGraph(d), 4);
  EXPECT_EQ(connectivity_problem(diagram.dual, Surface::disk), "");
}

TEST(Voronoi, pairs_are_the_kod_edges_of_larger_sets) {
  for (const families::Points& points : {families::random_square(30, 5), families::lattice(6, 5),
                                         families::ring(30, 5, 32045, true)}) {
    const Delaunay d = delaunay(support::to_point_set(points));
    const oracle::Instance instance(support::to_oracle(d.vertices.xy));
    for (Index m = 1; m < 12; ++m)
      ASSERT_NO_FATAL_FAILURE(
          expect_lemma_2(instance, voronoi_diagram(DelaunayGraph(d), m), std::to_string(m)));
  }
}

}  // namespace
}  // namespace hodt
