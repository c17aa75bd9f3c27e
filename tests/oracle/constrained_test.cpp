// The facts that order with constraints rests on, by enumeration of all triangulations: in
// general position, with ties, and with constraints of every shape, that touch, close rings and end
// inside circles.
#include "constrained.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "constraint_shapes.h"
#include "families.h"
#include "optima_check.h"
#include <gtest/gtest.h>

namespace {

using oracle::Catalogue;
using oracle::Constrained;
using oracle::ConstrainedCatalogue;
using oracle::describe;
using oracle::Domain;
using oracle::Edge;
using oracle::families_for_constraints;
using oracle::fits;
using oracle::Instance;
using oracle::kUnrestricted;
using oracle::Points;
using oracle::random_domain;
using oracle::random_edges;
using oracle::ring_within;
using oracle::Rings;
using oracle::Triangle;
using oracle::Triangles;

bool slow() {
  return std::getenv("HODT_SLOW") != nullptr;
}

/// Calls check(instance, seed) for points of every family.
void for_each_point_set(int smallest, int largest, int seeds,
                        const std::function<void(const Instance&, std::uint64_t)>& check) {
  for (const auto& family : families_for_constraints()) {
    for (int n = smallest; n <= largest; ++n) {
      for (int seed = 0; seed < (slow() ? 20 : 1) * seeds; ++seed) {
        check(Instance(family.make(n, seed)), 1000 * n + seed);
        if (testing::Test::HasFailure()) return;  // one example is enough, and it may be long
      }
    }
  }
}

// ---- The facts ------------------------------------------------------------------------------

void expect_one_of_order_0(const Constrained& constrained, const Catalogue& catalogue) {
  Triangles found;
  int number = 0;
  for (const auto& t : catalogue.triangulations()) {
    if (t.order > 0) continue;
    ++number;
    found = t.triangles;
  }
  EXPECT_EQ(number, 1) << describe(constrained);
  EXPECT_EQ(found, constrained.delaunay()) << describe(constrained);
  for (const Edge& e : constrained.edges()) EXPECT_EQ(catalogue.useful_order(e[0], e[1]), 0);
}

void expect_lemma_4(const Constrained& constrained, const Catalogue& catalogue) {
  for (int u = 0; u < constrained.instance().size(); ++u) {
    for (int v = 0; v < u; ++v) {
      EXPECT_EQ(catalogue.useful_order(u, v), constrained.useful_order_by_lemma(u, v))
          << u << '-' << v << ' ' << describe(constrained);
    }
  }
}

void expect_fixed_edges_are_those_of_all(const Constrained& constrained,
                                         const Catalogue& catalogue) {
  for (int k = 0; k + 3 <= constrained.instance().size(); ++k) {
    EXPECT_EQ(catalogue.fixed_edges(k), catalogue.edges_in_all(k))
        << "k " << k << ' ' << describe(constrained);
  }
}

/// Useful first order edges that are not fixed come in crossing pairs, the diagonals of
/// quadrilaterals; one of each pair is in the triangulation, and every choice is possible.
void expect_first_order_flips_are_independent(const Constrained& constrained,
                                              const Catalogue& catalogue) {
  const auto useful = catalogue.useful_edges(1);
  const std::size_t fixed = catalogue.fixed_edges(1).size();
  for (const Edge& e : useful) {
    const auto crossed = std::ranges::count_if(useful, [&](const Edge& f) {
      return constrained.instance().segments_cross(e[0], e[1], f[0], f[1]);
    });
    EXPECT_LE(crossed, 1) << e[0] << '-' << e[1] << ' ' << describe(constrained);
  }
  const std::size_t number =
      std::ranges::count_if(catalogue.triangulations(), [](const auto& t) { return t.order <= 1; });
  EXPECT_EQ(number, std::size_t{1} << (useful.size() - fixed) / 2) << describe(constrained);
}

/// A conjecture for larger k, so far without an exception: what is valid is used.
void expect_valid_triangles_are_those_used(const Constrained& constrained,
                                           const Catalogue& catalogue) {
  for (int k = 0; k < 4; ++k) {
    const Triangles valid = catalogue.valid_triangles(k);
    std::set<Triangle> used;
    for (const auto& t : catalogue.triangulations()) {
      if (t.order <= k) used.insert(t.triangles.begin(), t.triangles.end());
    }
    EXPECT_TRUE(std::ranges::equal(valid, used)) << "k " << k << ' ' << describe(constrained);
  }
}

void expect_facts(const Instance& instance, const std::vector<Edge>& edges) {
  const Constrained constrained(instance, edges);
  const ConstrainedCatalogue catalogue(constrained);
  expect_one_of_order_0(constrained, catalogue);
  expect_lemma_4(constrained, catalogue);
  expect_fixed_edges_are_those_of_all(constrained, catalogue);
  expect_first_order_flips_are_independent(constrained, catalogue);
  expect_valid_triangles_are_those_used(constrained, catalogue);
}

TEST(Constrained, facts_of_random_sets) {
  for_each_point_set(4, 8, 20, [](const Instance& instance, std::uint64_t seed) {
    expect_facts(instance, random_edges(instance, seed));
  });
}

/// Calls visit(edges) for every set of at most `most` edges that do not cross.
void for_each_set_of_edges(const Instance& instance, std::size_t most, const Edge& last,
                           std::vector<Edge>& edges,
                           const std::function<void(const std::vector<Edge>&)>& visit) {
  visit(edges);
  if (edges.size() == most) return;
  for (int v = 0; v < instance.size(); ++v) {
    for (int u = 0; u < v; ++u) {
      if (Edge{u, v} <= last || !fits(instance, edges, u, v)) continue;
      edges.push_back({u, v});
      for_each_set_of_edges(instance, most, {u, v}, edges, visit);
      edges.pop_back();
    }
  }
}

void expect_facts_of_all_sets_of_edges(const Points& points, std::size_t most) {
  const Instance instance(points);
  std::vector<Edge> edges;
  for_each_set_of_edges(instance, most, {-1, -1}, edges, [&](const std::vector<Edge>& chosen) {
    if (!testing::Test::HasFailure()) expect_facts(instance, chosen);
  });
}

TEST(Constrained, facts_of_all_sets_of_edges) {
  expect_facts_of_all_sets_of_edges({{0, 0}, {2, 0}, {0, 2}, {2, 2}, {1, 1}}, 8);
  expect_facts_of_all_sets_of_edges({{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}}, 9);
  expect_facts_of_all_sets_of_edges({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1, 1}, {1, -1}}, 9);
  expect_facts_of_all_sets_of_edges(families::ring(6, 1, 25), slow() ? 9 : 3);
  expect_facts_of_all_sets_of_edges(ring_within(7, 1), slow() ? 4 : 2);
  expect_facts_of_all_sets_of_edges(families::lattice(3, 3), slow() ? 3 : 1);
}

// ---- The count ------------------------------------------------------------------------------

TEST(Constrained, the_count_is_the_same_in_all_triangulations) {
  for_each_point_set(5, 7, 8, [](const Instance& instance, std::uint64_t seed) {
    const Constrained constrained(instance, random_edges(instance, seed));
    const auto triangulations = ConstrainedCatalogue(constrained).triangulations();
    for (const Triangle& t : constrained.possible_triangles()) {
      const auto inside = constrained.reachable_inside(t);
      for (const auto& in : triangulations) {
        ASSERT_EQ(constrained.reachable_inside(t, in.triangles), inside)
            << t[0] << ' ' << t[1] << ' ' << t[2] << ' ' << describe(constrained);
      }
    }
  });
}

/// Points in the hull. On a lattice they lie on circles.
Points with_further_points(const Points& points, families::Random& random) {
  Points all = points;
  for (int tries = 0; tries < 4; ++tries) {
    const auto& [ax, ay] = points[random.bits() % points.size()];
    const auto& [bx, by] = points[random.bits() % points.size()];
    const auto& [cx, cy] = points[random.bits() % points.size()];
    const std::pair between{(ax + bx) / 2 + (cx - bx) / 4, (ay + by) / 2 + (cy - by) / 4};
    if (std::ranges::find(all, between) == all.end()) all.push_back(between);
  }
  return all;
}

/// Of two instances, the first with the points that the second begins with. Rounding can put a
/// point that was meant to be in the hull outside it.
bool have_one_hull(const Instance& coarse, const Instance& fine) {
  for (int u = 0; u < coarse.size(); ++u) {
    for (int v = 0; v < coarse.size(); ++v) {
      if (u == v || !coarse.is_hull_half_edge(u, v)) continue;
      for (int w = 0; w < fine.size(); ++w) {
        if (fine.orient(u, v, w) < 0) return false;
      }
    }
  }
  return true;
}

TEST(Constrained, further_points_in_the_hull_change_nothing_that_is_reached) {
  // They give the walk another way, in a finer triangulation.
  for_each_point_set(5, 8, 4, [](const Instance& instance, std::uint64_t seed) {
    families::Random random(seed);
    const Instance finer(with_further_points(instance.points(), random));
    if (!have_one_hull(instance, finer)) return;
    auto edges = random_edges(instance, seed);
    std::erase_if(edges, [&](const Edge& e) { return !finer.is_segment_free(e[0], e[1]); });
    const Constrained coarse(instance, edges), fine(finer, edges);
    for (const Triangle& t : coarse.possible_triangles()) {
      if (!fine.is_triangle_possible(t)) continue;
      auto inside = fine.reachable_inside(t);
      std::erase_if(inside, [&](int v) { return v >= instance.size(); });
      EXPECT_EQ(inside, coarse.reachable_inside(t))
          << t[0] << ' ' << t[1] << ' ' << t[2] << ' ' << describe(fine);
    }
  });
}

/// A walk in the constrained Delaunay triangulation that starts at one triangle and knows no
/// distances: it steps over an edge that is no constraint if an end of it is inside.
std::vector<int> walk_from_vertex_to_vertex(const Constrained& constrained, const Triangle& t,
                                            const Triangles& delaunay, const Triangle& start) {
  const auto is_inside = [&](int v) {
    return std::ranges::find(t, v) == t.end() &&
           constrained.instance().in_circle(t[0], t[1], t[2], v) > 0;
  };
  std::set<Triangle> met{start};
  std::vector<Triangle> open{start};
  std::set<int> reached;
  while (!open.empty()) {
    const Triangle at = open.back();
    open.pop_back();
    std::ranges::copy_if(at, std::inserter(reached, reached.end()), is_inside);
    for (const Triangle& next : delaunay) {
      std::vector<int> common;
      std::ranges::copy_if(next, std::back_inserter(common),
                           [&](int v) { return std::ranges::find(at, v) != at.end(); });
      if (common.size() != 2 || constrained.is_constraint(common[0], common[1])) continue;
      if (!is_inside(common[0]) && !is_inside(common[1])) continue;
      if (met.insert(next).second) open.push_back(next);
    }
  }
  return {reached.begin(), reached.end()};
}

TEST(Constrained, in_the_delaunay_triangulation_the_walk_goes_from_vertex_to_vertex) {
  // No edge there, both ends outside, has on both sides what counts or a corner of t. So an
  // edge through t has an end that counts, and the walk may start anywhere in t.
  for_each_point_set(5, 8, 8, [](const Instance& instance, std::uint64_t seed) {
    const Constrained constrained(instance, random_edges(instance, seed));
    const Triangles delaunay = constrained.delaunay();
    for (const Triangle& t : constrained.possible_triangles()) {
      for (const Triangle& start : delaunay) {
        if (!instance.triangles_overlap(t, start)) continue;
        EXPECT_EQ(walk_from_vertex_to_vertex(constrained, t, delaunay, start),
                  constrained.reachable_inside(t))
            << t[0] << ' ' << t[1] << ' ' << t[2] << ' ' << describe(constrained);
      }
    }
  });
}

TEST(Constrained, fewer_points_count_behind_constraints_and_by_the_plain_definition) {
  for_each_point_set(5, 8, 4, [](const Instance& instance, std::uint64_t seed) {
    auto edges = random_edges(instance, seed);
    if (edges.empty()) return;
    const Constrained all(instance, edges);
    edges.pop_back();
    const Constrained fewer(instance, edges);
    for (const Triangle& t : all.possible_triangles()) {
      EXPECT_LE(all.triangle_order(t), fewer.triangle_order(t));
      EXPECT_LE(all.triangle_order_plain(t), all.triangle_order(t));
      EXPECT_LE(all.triangle_order_plain(t), instance.triangle_order_plain(t[0], t[1], t[2]));
    }
  });
}

TEST(Constrained, without_constraints_all_is_as_ever) {
  for_each_point_set(4, 8, 2, [](const Instance& instance, std::uint64_t) {
    const Constrained none(instance, {});
    const ConstrainedCatalogue constrained(none);
    const Catalogue plain(instance);
    ASSERT_EQ(constrained.triangulations().size(), plain.triangulations().size());
    for (std::size_t i = 0; i < plain.triangulations().size(); ++i) {
      const auto& found = constrained.triangulations()[i];
      EXPECT_EQ(found.triangles, plain.triangulations()[i].triangles);
      EXPECT_EQ(found.order, plain.triangulations()[i].order);
      EXPECT_EQ(none.order_plain(found.triangles), instance.order_plain(found.triangles));
    }
    EXPECT_EQ(none.delaunay(), instance.delaunay());
    for (int u = 0; u < instance.size(); ++u) {
      for (int v = 0; v < u; ++v) {
        EXPECT_EQ(none.useful_order_by_lemma(u, v), instance.useful_order_by_lemma(u, v));
        EXPECT_EQ(constrained.useful_order(u, v), plain.useful_order(u, v));
      }
    }
    for (int k = 0; k < 4; ++k) {
      EXPECT_EQ(constrained.valid_triangles(k), plain.valid_triangles(k));
      EXPECT_EQ(constrained.fixed_edges(k), plain.fixed_edges(k));
    }
  });
}

// ---- Insertion ------------------------------------------------------------------------------

Constrained with_edges(const Constrained& constrained, const std::vector<Edge>& more) {
  std::vector<Edge> edges = constrained.edges();
  edges.insert(edges.end(), more.begin(), more.end());
  return {constrained.instance(), edges};
}

/// The triangles of a triangulation that the segment crosses.
Triangles hull_of(const Instance& instance, const Triangles& triangulation, const Edge& e) {
  Triangles hull;
  std::ranges::copy_if(triangulation, std::back_inserter(hull), [&](const Triangle& t) {
    return instance.segments_cross(e[0], e[1], t[0], t[1]) ||
           instance.segments_cross(e[0], e[1], t[1], t[2]) ||
           instance.segments_cross(e[0], e[1], t[2], t[0]);
  });
  return hull;
}

std::vector<Edge> useful_edges_by_lemma(const Constrained& constrained) {
  std::vector<Edge> useful;
  for (int v = 0; v < constrained.instance().size(); ++v) {
    for (int u = 0; u < v; ++u) {
      if (constrained.useful_order_by_lemma(u, v).value_or(0) > 0) useful.push_back({u, v});
    }
  }
  return useful;
}

TEST(Insertion, changes_the_hull_of_an_edge_only_and_has_its_order) {
  for_each_point_set(4, 8, 4, [](const Instance& instance, std::uint64_t seed) {
    const Constrained constrained(instance, random_edges(instance, seed));
    const Triangles delaunay = constrained.delaunay();
    for (const Edge& e : useful_edges_by_lemma(constrained)) {
      const int order = *constrained.useful_order_by_lemma(e[0], e[1]);
      const Triangles inserted = with_edges(constrained, {e}).delaunay();
      EXPECT_EQ(constrained.order(inserted), order) << describe(constrained);
      Triangles gone;
      std::ranges::set_difference(delaunay, inserted, std::back_inserter(gone));
      EXPECT_EQ(gone, hull_of(instance, delaunay, e)) << describe(constrained);
      // There may be more triangles than the 2k of a simple polygon: an edge between two vertices
      // on one side can have crossed triangles on both of its sides.
      std::set<int> vertices;
      for (const Triangle& t : gone) vertices.insert(t.begin(), t.end());
      EXPECT_LE(vertices.size(), 2u * order + 2) << describe(constrained);
    }
  });
}

TEST(Insertion, of_two_edges_has_the_larger_order_if_their_hulls_are_disjoint_or_it_is_2) {
  // Otherwise at most 2k - 2.
  for_each_point_set(6, 9, 2, [](const Instance& instance, std::uint64_t seed) {
    const Constrained constrained(instance, random_edges(instance, seed));
    const Triangles delaunay = constrained.delaunay();
    const auto useful = useful_edges_by_lemma(constrained);
    for (const Edge& e : useful) {
      for (const Edge& f : useful) {
        if (f <= e || instance.segments_cross(e[0], e[1], f[0], f[1])) continue;
        const int k = std::max(*constrained.useful_order_by_lemma(e[0], e[1]),
                               *constrained.useful_order_by_lemma(f[0], f[1]));
        const Triangles a = hull_of(instance, delaunay, e), b = hull_of(instance, delaunay, f);
        Triangles common;
        std::ranges::set_intersection(a, b, std::back_inserter(common));
        const int together = constrained.order(with_edges(constrained, {e, f}).delaunay());
        EXPECT_LE(together, common.empty() ? k : std::max(k, 2 * k - 2)) << describe(constrained);
      }
    }
  });
}

// ---- By hand --------------------------------------------------------------------------------

TEST(Constrained, a_wall_hides_what_is_behind_it) {
  // The wall 2-3 crosses the whole circle of 0, 1, 4; the point 5 is behind it.
  const Instance instance({{0, 0}, {4, 0}, {-9, 3}, {13, 3}, {2, 1}, {2, -3}, {2, 3.5}});
  const Triangle t{0, 1, 5};
  ASSERT_EQ(instance.triangle_order(0, 1, 5), 1);
  EXPECT_EQ(Constrained(instance, {}).reachable_inside(t), std::vector{4});
  EXPECT_EQ(Constrained(instance, {{0, 1}}).triangle_order(t), 0);
  EXPECT_EQ(Constrained(instance, {{2, 3}}).triangle_order(t), 1);
}

TEST(Constrained, a_path_goes_around_the_end_of_a_constraint) {
  // The circle of 0, 1, 2 is x² + y² = 100. The wall 3-4 ends inside it and hides 5 from the
  // triangle.
  Points points{{-10, 0}, {-8, -6}, {-8, 6}, {3, 2}, {3, -30}, {6, -1}, {3, 40}};
  const Triangle t{0, 1, 2};
  EXPECT_EQ(Constrained(Instance(points), {{3, 4}}).reachable_inside(t), (std::vector{3, 5}));
  // But it does not pass a chain at a vertex, though 3 is reached and is a neighbour of 5.
  EXPECT_EQ(Constrained(Instance(points), {{3, 4}, {3, 6}}).reachable_inside(t), std::vector{3});
  // With an end outside, the wall hides 5, and no end of it counts.
  points[3] = {3, 20};
  EXPECT_EQ(Constrained(Instance(points), {{3, 4}}).triangle_order(t), 0);
}

TEST(Constrained, no_path_leaves_the_hull) {
  // As before, but the wall ends on the hull: the path would have to go around outside.
  const Points points{{-10, 0}, {-8, -6}, {-8, 6}, {3, 2}, {3, -30}, {6, -1}};
  EXPECT_EQ(Constrained(Instance(points), {{3, 4}}).reachable_inside({0, 1, 2}), std::vector{3});
  for_each_point_set(5, 8, 2, [](const Instance& instance, std::uint64_t seed) {
    auto edges = random_edges(instance, seed);
    const Constrained without_hull(instance, edges);
    for (int u = 0; u < instance.size(); ++u) {
      for (int v = 0; v < instance.size(); ++v) {
        if (u != v && instance.is_hull_half_edge(u, v)) edges.push_back({u, v});
      }
    }
    const Constrained with_hull(instance, edges);
    for (const Triangle& t : with_hull.possible_triangles()) {
      EXPECT_EQ(with_hull.reachable_inside(t), without_hull.reachable_inside(t));
    }
  });
}

TEST(Constrained, a_path_goes_around_a_tie_that_is_inside) {
  // The points 0 to 4 are on one circle. Raising 1, the largest, takes in 3 and 4, on its side of
  // the line 0-2. The wall from the corner 0 to 3 hides 4 from the triangle.
  const Instance instance(
      {{-3, 4}, {5, 0}, {4, 3}, {4, -3}, {-4, 3}, {-21, -23}, {19, -18}, {-2, 23}});
  const Triangle t{0, 1, 2};
  EXPECT_EQ(Constrained(instance, {{0, 3}}).reachable_inside(t), (std::vector{3, 4}));
  EXPECT_EQ(Constrained(instance, {{0, 3}}).triangle_order_plain(t), 0);
  // Longer, it has only the end at the corner in the disc, and no path goes around a corner.
  EXPECT_EQ(Constrained(instance, {{0, 3}, {3, 6}}).reachable_inside(t), std::vector{3});
}

TEST(Constrained, wrong_input_is_refused) {
  const Instance square({{0, 0}, {1, 0}, {0, 1}, {1, 1}, {2, 0}});
  EXPECT_THROW(Constrained(square, {{0, 3}, {1, 2}}), std::invalid_argument);
  EXPECT_THROW(Constrained(square, {{0, 4}}), std::invalid_argument);
  EXPECT_THROW(Constrained(square, {{2, 2}}), std::invalid_argument);
  EXPECT_THROW(Constrained(square, {{2, 5}}), std::invalid_argument);
  EXPECT_THROW(Constrained(Instance({{0, 0}, {1, 0}}), {{0, 1}}), std::invalid_argument);
  const Constrained diagonal(square, {{3, 0}, {0, 3}});
  EXPECT_EQ(diagonal.edges(), (std::vector<Edge>{{0, 3}}));
  EXPECT_THROW(diagonal.triangle_order({0, 1, 2}), std::invalid_argument);
  EXPECT_THROW(diagonal.triangle_order({0, 1, 4}), std::invalid_argument);
  EXPECT_THROW(ConstrainedCatalogue(diagonal, Rings{{0, 1, 3}}), std::invalid_argument);
}

// ---- Domains --------------------------------------------------------------------------------

TEST(Domains, of_a_square_with_a_hole_and_an_island) {
  // Three squares in one another, and a point in the middle of the least.
  Points points{{0, 0}};
  Rings rings(3);
  std::vector<Edge> edges;
  for (const int size : {1, 2, 4}) {
    const int first = static_cast<int>(points.size());
    for (const auto& [x, y] : {std::pair{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}) {
      points.emplace_back(size * x, size * y);
    }
    for (int i = 0; i < 4; ++i) {
      rings[size / 2].push_back(first + i);
      edges.push_back({first + i, first + (i + 1) % 4});
    }
  }
  const Instance instance(points, {-5, 1, 2, 2, 2, 3, 3, 3, 3, 7, 7, 7, 7});
  const Constrained constrained(instance, edges);
  const std::size_t island = 4, hole = 8, land = 8;
  EXPECT_EQ(ConstrainedCatalogue(constrained).triangulations()[0].triangles.size(),
            island + hole + land);
  const auto triangles_of = [&](const Rings& domain) {
    return ConstrainedCatalogue(constrained, domain).triangulations()[0].triangles.size();
  };
  EXPECT_EQ(triangles_of(rings), land + island);
  EXPECT_EQ(triangles_of({rings[2], rings[1]}), land);
  EXPECT_EQ(triangles_of({rings[0]}), island);
  EXPECT_EQ(triangles_of({}), 0u);

  const ConstrainedCatalogue catalogue(constrained, {rings[2], rings[1]});
  EXPECT_EQ(catalogue.useful_order(0, 1), std::nullopt);
  EXPECT_EQ(catalogue.useful_order(5, 6), 0);
  const Triangles mesh = catalogue.triangulations()[0].triangles;
  const auto boundary = oracle::boundary_vertices(instance, mesh);
  EXPECT_FALSE(boundary[0] || boundary[1]) << "not of the mesh";
  EXPECT_TRUE(boundary[5] && boundary[9]);
  const auto count = instance.count_extrema(mesh, boundary);
  EXPECT_EQ(count.minima, (oracle::SplitCount{0, 1}));
  EXPECT_EQ(count.pits, (oracle::SplitCount{0, 1}));
  EXPECT_EQ(oracle::Optima::at(catalogue.optima(instance).minima, 0), 1);
}

TEST(Domains, the_inside_is_what_the_rings_surround) {
  for_each_point_set(4, 8, 8, [](const Instance& instance, std::uint64_t seed) {
    families::Random random(seed);
    const Domain domain = random_domain(instance, random);
    for (const Triangle& t : domain.inside) {
      EXPECT_TRUE(oracle::is_in_domain(instance, domain.rings, t));
    }
    for (const Triangle& t : domain.outside) {
      EXPECT_FALSE(oracle::is_in_domain(instance, domain.rings, t));
    }
  });
}

TEST(Domains, facts) {
  for_each_point_set(4, 8, 8, [](const Instance& instance, std::uint64_t seed) {
    families::Random random(seed);
    const Domain domain = random_domain(instance, random);
    auto edges = domain.edges;
    for (const Edge& e : oracle::random_constraints(instance, 2, seed)) {
      if (fits(instance, edges, e[0], e[1])) edges.push_back(e);
    }
    const Constrained constrained(instance, edges);
    const ConstrainedCatalogue catalogue(constrained, domain.rings);
    int order_0 = 0;
    for (const auto& t : catalogue.triangulations()) order_0 += t.order == 0;
    EXPECT_EQ(order_0, 1) << describe(constrained);
    std::set<Edge> inside;
    std::set<int> used;
    std::vector<Triangle> triangles;
    for (const Triangle& t : constrained.possible_triangles()) {
      if (!oracle::is_in_domain(instance, domain.rings, t)) continue;
      triangles.push_back(t);
      for (int i = 0; i < 3; ++i) {
        used.insert(t[i]);
        inside.insert({std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])});
      }
    }
    for (const Triangle& t : triangles) {
      for (const int v : constrained.reachable_inside(t)) EXPECT_TRUE(used.contains(v));
    }
    for (int u = 0; u < instance.size(); ++u) {
      for (int v = u + 1; v < instance.size(); ++v) {
        const auto by_lemma =
            inside.contains({u, v}) ? constrained.useful_order_by_lemma(u, v) : std::nullopt;
        EXPECT_EQ(catalogue.useful_order(u, v), by_lemma) << describe(constrained);
      }
    }
    expect_fixed_edges_are_those_of_all(constrained, catalogue);
    expect_first_order_flips_are_independent(constrained, catalogue);
    expect_valid_triangles_are_those_used(constrained, catalogue);
  });
}

TEST(Domains, optima_agree_with_counting_one_by_one) {
  for (const auto& family : families_for_constraints()) {
    const Points points = family.make(7, 17);
    Instance instance(points);
    families::Random random(5);
    const Domain domain = random_domain(instance, random);
    const Constrained constrained(instance, domain.edges);
    const ConstrainedCatalogue catalogue(constrained, domain.rings);
    for (const auto& heights : families::all_heights()) {
      instance.set_heights(heights.make(points, 3));
      oracle::expect_optima(catalogue, instance, [&](const Triangles& t) {
        return instance.count_extrema(t, oracle::boundary_vertices(instance, t));
      });
    }
  }
}

TEST(Domains, the_boundary_of_a_whole_triangulation_is_the_hull) {
  for_each_point_set(4, 8, 2, [](const Instance& instance, std::uint64_t) {
    const auto boundary = oracle::boundary_vertices(instance, instance.delaunay());
    for (int v = 0; v < instance.size(); ++v) EXPECT_EQ(boundary[v], instance.is_on_hull(v));
  });
}

}  // namespace
