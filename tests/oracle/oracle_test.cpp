// The oracle against facts that were worked out by hand or are in the literature, and against
// itself: what the lemmas say against what the definitions say.
#include "oracle.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>
#include <string>

#include "families.h"
#include "optima_check.h"
#include <gtest/gtest.h>

namespace {

using oracle::Catalogue;
using oracle::Edge;
using oracle::Instance;
using oracle::Points;
using oracle::Triangles;

bool slow() {
  return std::getenv("HODT_SLOW") != nullptr;
}

const Points kSquare{{0, 0}, {1, 0}, {0, 1}, {1, 1}};

// ---- Signs ----------------------------------------------------------------------------------

TEST(Predicates, orient) {
  const Instance square(kSquare);
  EXPECT_EQ(square.orient(0, 1, 2), 1);
  EXPECT_EQ(square.orient(1, 0, 2), -1);
  EXPECT_EQ(square.orient(2, 0, 1), 1);
  const Instance line({{0, 0}, {1, 1}, {2, 2}});
  EXPECT_EQ(line.orient(0, 1, 2), 0);
  EXPECT_TRUE(line.all_collinear());
}

TEST(Predicates, orient_is_exact) {
  // In doubles 0.1 + 0.2 is above 0.3, so the middle point is above the line by half an ulp.
  const Instance points({{0, 0}, {0.3, 0.1 + 0.2}, {1, 1}});
  EXPECT_EQ(points.orient(0, 2, 1), 1);
}

TEST(Predicates, in_circle_whichever_way_round) {
  const Instance points({{1, 0}, {0, 1}, {-1, 0}, {0.1, 0.1}, {0, -1}, {2, 2}});
  for (const auto& [a, b, c] : {std::array{0, 1, 2}, std::array{2, 1, 0}, std::array{1, 2, 0}}) {
    EXPECT_EQ(points.in_circle_plain(a, b, c, 3), 1);
    EXPECT_EQ(points.in_circle_plain(a, b, c, 4), 0);
    EXPECT_EQ(points.in_circle_plain(a, b, c, 5), -1);
    EXPECT_EQ(points.in_circle(a, b, c, 3), 1);
    EXPECT_EQ(points.in_circle(a, b, c, 5), -1);
    // The largest of 0, 1, 2, 4 is (1, 0): raising a corner takes in what is beyond the opposite
    // side of it only, and (0, -1) is on the corner's side of the line from (0, 1) to (-1, 0).
    EXPECT_EQ(points.in_circle(a, b, c, 4), points.orient(1, 2, 0) * points.orient(1, 2, 4));
  }
}

TEST(Predicates, the_largest_point_is_outside) {
  const Instance square(kSquare);
  EXPECT_EQ(square.in_circle_plain(0, 1, 2, 3), 0);
  EXPECT_EQ(square.in_circle(0, 1, 2, 3), -1);
  // Of the other three triangles, those along the other diagonal have the opposite corner inside.
  EXPECT_EQ(square.in_circle(1, 3, 2, 0), -1);
  EXPECT_EQ(square.in_circle(0, 1, 3, 2), 1);
  EXPECT_EQ(square.in_circle(0, 3, 2, 1), 1);
}

TEST(Predicates, perturbation_by_actual_numbers) {
  // The rule with real numbers in place of infinitesimals: raise the lifts of the points of a
  // lattice by 10^-9, 10^-18, ... and take the determinant of exact fractions.
  const Points points = families::lattice(3, 3);
  const Instance instance(points);
  std::vector<mpq_class> lift(9);
  mpq_class epsilon = 1;
  for (int i = 8; i >= 0; --i) {  // lattice() lists its points in lexicographic order
    epsilon /= 1000000000;
    lift[i] = points[i].first * points[i].first + points[i].second * points[i].second + epsilon;
  }
  const auto plane_test = [&](int a, int b, int c, int d) {
    const auto dx = [&](int p) { return mpq_class(points[p].first - points[d].first); };
    const auto dy = [&](int p) { return mpq_class(points[p].second - points[d].second); };
    const auto dw = [&](int p) { return mpq_class(lift[p] - lift[d]); };
    const mpq_class det = dx(a) * (dy(b) * dw(c) - dy(c) * dw(b)) -
                          dy(a) * (dx(b) * dw(c) - dx(c) * dw(b)) +
                          dw(a) * (dx(b) * dy(c) - dx(c) * dy(b));
    return sgn(det) * instance.orient(a, b, c);
  };
  for (int a = 0; a < 9; ++a) {
    for (int b = 0; b < 9; ++b) {
      for (int c = 0; c < 9; ++c) {
        for (int d = 0; d < 9; ++d) {
          if (std::set{a, b, c, d}.size() < 4 || instance.orient(a, b, c) == 0) continue;
          ASSERT_EQ(instance.in_circle(a, b, c, d), plane_test(a, b, c, d))
              << a << ' ' << b << ' ' << c << ' ' << d;
        }
      }
    }
  }
}

TEST(Predicates, equal_points_are_refused) {
  EXPECT_THROW(Instance({{0, 0}, {1, 1}, {0, 0}}), std::invalid_argument);
  EXPECT_THROW(Instance({{0, 0}, {1, 1}}, {1}), std::invalid_argument);
}

// ---- Numbers of triangulations --------------------------------------------------------------

TEST(Enumeration, convex_position_gives_catalan_numbers) {
  const std::vector<std::size_t> catalan{1, 1, 2, 5, 14, 42, 132, 429, 1430};
  for (int n = 3; n <= 10; ++n) {
    EXPECT_EQ(count_triangulations(Instance(families::convex_parabola(n, 1))), catalan[n - 2]);
    EXPECT_EQ(count_triangulations(Instance(families::ring(n, 1))), catalan[n - 2]);
  }
}

TEST(Enumeration, lattices) {
  // Known numbers of unimodular triangulations of lattice rectangles.
  EXPECT_EQ(count_triangulations(Instance(families::lattice(2, 2))), 2u);
  EXPECT_EQ(count_triangulations(Instance(families::lattice(3, 2))), 6u);
  EXPECT_EQ(count_triangulations(Instance(families::lattice(4, 2))), 20u);
  EXPECT_EQ(count_triangulations(Instance(families::lattice(3, 3))), 64u);
  EXPECT_EQ(count_triangulations(Instance(families::lattice(4, 3))), 852u);
  EXPECT_EQ(count_triangulations(Instance(families::lattice(4, 4))), 46456u);
}

TEST(Enumeration, two_lines) {
  // a points on one line and b on the other: the choice of a - 1 among a + b - 2 steps.
  EXPECT_EQ(count_triangulations(Instance(families::two_lines(9, 0))), 35u);  // 5 and 4
}

TEST(Enumeration, one_apex_gives_one) {
  EXPECT_EQ(count_triangulations(Instance(families::fan(7, 3))), 1u);
}

TEST(Enumeration, points_on_a_line_give_none) {
  EXPECT_EQ(count_triangulations(Instance({{0, 0}, {1, 1}, {2, 2}})), 0u);
}

TEST(Enumeration, one_interior_point) {
  // In a triangle: one. In a square, at the centre: only the four spokes, as both diagonals pass
  // through it. In a square, off centre: the point sees all four corners, or lies in a corner
  // triangle of either diagonal.
  EXPECT_EQ(count_triangulations(Instance({{0, 0}, {3, 0}, {0, 3}, {1, 1}})), 1u);
  EXPECT_EQ(count_triangulations(Instance({{0, 0}, {2, 0}, {0, 2}, {2, 2}, {1, 1}})), 1u);
  EXPECT_EQ(count_triangulations(Instance({{0, 0}, {8, 0}, {0, 8}, {8, 8}, {4, 1}})), 3u);
}

TEST(Enumeration, every_result_is_a_triangulation_and_they_differ) {
  for (const auto& family : families::all()) {
    const Instance instance(family.make(7, 5));
    std::set<Triangles> seen;
    for_each_triangulation(instance, oracle::kUnrestricted, [&](const Triangles& t, int order) {
      EXPECT_EQ(instance.why_not_triangulation(t), "") << family.name;
      EXPECT_EQ(instance.order(t), order) << family.name;
      EXPECT_TRUE(seen.insert(instance.canonical(t)).second) << family.name;
    });
    EXPECT_FALSE(seen.empty()) << family.name;
  }
}

TEST(Enumeration, flips_reach_no_other) {
  // All triangulations of a planar point set are connected by flips (Lawson), so a walk along
  // flips from one of them must find exactly the enumerated ones.
  const auto edges_of = [](const Triangles& triangles) {
    std::map<Edge, std::vector<int>> opposite;
    for (const auto& t : triangles) {
      for (int i = 0; i < 3; ++i) {
        const int a = t[i], b = t[(i + 1) % 3];
        opposite[{std::min(a, b), std::max(a, b)}].push_back(t[(i + 2) % 3]);
      }
    }
    return opposite;
  };
  for (const auto& family : families::all()) {
    const Instance instance(family.make(7, 11));
    std::set<Triangles> reached{instance.delaunay()};
    std::vector<Triangles> todo(reached.begin(), reached.end());
    while (!todo.empty()) {
      const Triangles triangles = todo.back();
      todo.pop_back();
      for (const auto& [edge, apexes] : edges_of(triangles)) {
        if (apexes.size() != 2) continue;
        if (!instance.segments_cross(edge[0], edge[1], apexes[0], apexes[1])) continue;
        Triangles flipped;
        for (const auto& t : triangles) {
          const bool goes = std::ranges::count(t, edge[0]) && std::ranges::count(t, edge[1]);
          if (!goes) flipped.push_back(t);
        }
        flipped.push_back({edge[0], apexes[0], apexes[1]});
        flipped.push_back({edge[1], apexes[0], apexes[1]});
        flipped = instance.canonical(flipped);
        if (reached.insert(flipped).second) todo.push_back(flipped);
      }
    }
    EXPECT_EQ(reached.size(), count_triangulations(instance)) << family.name;
  }
}

TEST(Enumeration, bound_on_the_order_only_leaves_out) {
  const Instance instance(families::random_square(8, 3));
  const Catalogue all(instance);
  for (int k = 0; k <= 5; ++k) {
    const auto within =
        std::ranges::count_if(all.triangulations(), [&](const auto& t) { return t.order <= k; });
    EXPECT_EQ(count_triangulations(instance, k), static_cast<std::size_t>(within));
  }
  EXPECT_EQ(count_triangulations(instance, 0), 1u);
  EXPECT_EQ(count_triangulations(instance, 5), all.triangulations().size());
}

TEST(Check, names_what_is_wrong) {
  const Instance square({{0, 0}, {2, 0}, {0, 2}, {2, 2}, {1, 1}});
  EXPECT_NE(square.why_not_triangulation({{0, 1, 4}, {1, 3, 4}, {2, 4, 3}}), "");
  EXPECT_NE(square.why_not_triangulation({{0, 1, 2}, {1, 3, 2}}), "");
  EXPECT_NE(square.why_not_triangulation({{0, 1, 4}, {0, 1, 4}}), "");
  EXPECT_NE(square.why_not_triangulation({{0, 4, 3}}), "");
  EXPECT_NE(square.why_not_triangulation({{0, 1, 5}}), "");
  EXPECT_EQ(square.why_not_triangulation({{0, 1, 4}, {1, 3, 4}, {2, 4, 3}, {4, 2, 0}}), "");
}

// ---- Delaunay -------------------------------------------------------------------------------

TEST(Delaunay, unit_square_has_the_diagonal_away_from_the_largest_corner) {
  const Triangles expected{{0, 1, 2}, {1, 3, 2}};
  EXPECT_EQ(Instance(kSquare).delaunay(), expected);
}

TEST(Delaunay, is_the_only_triangulation_of_order_0) {
  for (const auto& family : families::all()) {
    for (int n = 4; n <= 9; ++n) {
      for (std::uint64_t seed = 0; seed < 4; ++seed) {
        const Instance instance(family.make(n, seed));
        std::vector<Triangles> found;
        for_each_triangulation(
            instance, 0, [&](const Triangles& t, int) { found.push_back(instance.canonical(t)); });
        ASSERT_EQ(found.size(), 1u) << family.name << " n " << n << " seed " << seed;
        EXPECT_EQ(found.front(), instance.delaunay()) << family.name;
      }
    }
  }
}

TEST(Delaunay, larger_sets_are_triangulated) {
  for (const auto& family : families::all()) {
    const Instance instance(family.make(family.name == "wide_range" ? 16 : 40, 2));
    EXPECT_EQ(instance.why_not_triangulation(instance.delaunay()), "") << family.name;
    EXPECT_EQ(instance.order(instance.delaunay()), 0) << family.name;
  }
}

TEST(Delaunay, does_not_depend_on_the_order_of_the_input) {
  const Points points = families::lattice(4, 4);
  std::vector<int> shuffled(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) shuffled[i] = static_cast<int>(i);
  families::Random(7).shuffle(shuffled);
  Points moved;
  for (const int i : shuffled) moved.push_back(points[i]);
  Triangles named;
  for (const auto& [a, b, c] : Instance(moved).delaunay()) {
    named.push_back({shuffled[a], shuffled[b], shuffled[c]});
  }
  const Instance instance(points);
  EXPECT_EQ(instance.canonical(named), instance.delaunay());
}

// ---- Orders ---------------------------------------------------------------------------------

TEST(Order, of_a_quadrilateral) {
  // A kite: the short diagonal is Delaunay, the long one of order 1.
  const Instance kite({{0, -3}, {1, 0}, {0, 3}, {-1, 0}});
  EXPECT_EQ(kite.triangle_order(1, 3, 0), 0);
  EXPECT_EQ(kite.triangle_order(0, 2, 1), 1);
  EXPECT_EQ(kite.edge_order(1, 3), 0);
  EXPECT_EQ(kite.edge_order(0, 2), 1);
  EXPECT_EQ(kite.useful_order_by_lemma(0, 2), 1);
  EXPECT_EQ(Catalogue(kite).useful_order(0, 2), 1);
}

TEST(Order, the_rule_counts_at_least_what_the_plain_definition_counts) {
  const Instance square(kSquare);
  EXPECT_EQ(square.triangle_order(0, 1, 3), 1);
  EXPECT_EQ(square.triangle_order_plain(0, 1, 3), 0);
  for (const auto& family : families::all()) {
    const Instance instance(family.make(8, 9));
    for (const auto& [a, b, c] : instance.empty_triangles(oracle::kUnrestricted)) {
      EXPECT_GE(instance.triangle_order(a, b, c), instance.triangle_order_plain(a, b, c));
    }
  }
}

TEST(Order, no_edge_through_a_point) {
  const Instance points({{0, 0}, {1, 0}, {2, 0}, {0, 1}});
  EXPECT_EQ(points.edge_order(0, 2), std::nullopt);
  EXPECT_EQ(points.useful_order_by_lemma(0, 2), std::nullopt);
  EXPECT_EQ(Catalogue(points).useful_order(0, 2), std::nullopt);
  EXPECT_EQ(points.edge_order(0, 1), 0);
  EXPECT_EQ(points.useful_order_by_lemma(0, 1), 0);
}

TEST(Order, of_an_edge_is_that_of_its_best_triangle) {
  // Between two points that the sweep meets the count does not change, and it is least as the
  // circle passes through one of them: the two ways to say it agree.
  for (const auto& family : families::all()) {
    const Instance instance(family.make(9, 4));
    for (int u = 0; u < instance.size(); ++u) {
      for (int v = 0; v < u; ++v) {
        const auto order = instance.edge_order(u, v);
        if (!order) continue;
        int best = oracle::kUnrestricted;
        for (int w = 0; w < instance.size(); ++w) {
          if (instance.orient(u, v, w)) best = std::min(best, instance.triangle_order(u, v, w));
        }
        EXPECT_EQ(*order, best) << family.name << ' ' << u << ' ' << v;
        EXPECT_EQ(order, instance.edge_order(v, u));
        EXPECT_LE(*order, *instance.useful_order_by_lemma(u, v));
      }
    }
  }
}

TEST(Order, few_edges_of_each_order) {
  // At most 3 (k + 1) n - 3 (k + 1) (k + 2) k-OD edges, for k <= n / 2 - 2.
  for (const auto& family : families::all()) {
    const Instance instance(family.make(14, 6));
    const int n = instance.size();
    for (int k = 0; 2 * k <= n - 4; ++k) {
      int edges = 0;
      for (int u = 0; u < n; ++u) {
        for (int v = 0; v < u; ++v) {
          const auto order = instance.edge_order(u, v);
          edges += order && *order <= k;
        }
      }
      EXPECT_LE(edges, 3 * (k + 1) * n - 3 * (k + 1) * (k + 2)) << family.name << " k " << k;
    }
  }
}

// ---- Lemma 4 and what follows from it -------------------------------------------------------

void expect_lemma_4(const Instance& instance, const Catalogue& catalogue, const std::string& what) {
  for (int u = 0; u < instance.size(); ++u) {
    for (int v = 0; v < u; ++v) {
      EXPECT_EQ(catalogue.useful_order(u, v), instance.useful_order_by_lemma(u, v))
          << what << ": " << u << ' ' << v;
    }
  }
}

void expect_fixed_edges_are_those_of_all(const Catalogue& catalogue, int largest_order,
                                         const std::string& what) {
  for (int k = 0; k <= largest_order; ++k) {
    EXPECT_EQ(catalogue.fixed_edges(k), catalogue.edges_in_all(k)) << what << " k " << k;
  }
}

void expect_first_order_flips_are_independent(const Instance& instance, const Catalogue& catalogue,
                                              const std::string& what) {
  // Lemma 5: useful first order edges that are not fixed come in crossing pairs, one of each pair
  // is in the triangulation, and every choice is possible.
  const std::size_t useful = catalogue.useful_edges(1).size();
  const std::size_t fixed = catalogue.fixed_edges(1).size();
  ASSERT_EQ((useful - fixed) % 2, 0u) << what;
  EXPECT_EQ(count_triangulations(instance, 1), std::size_t{1} << (useful - fixed) / 2) << what;
}

TEST(Lemma4, is_the_definition) {
  const int largest = slow() ? 9 : 8;
  for (const auto& family : families::all()) {
    for (int n = 4; n <= largest; ++n) {
      for (std::uint64_t seed = 0; seed < (slow() ? 60 : 8); ++seed) {
        const Instance instance(family.make(n, seed));
        const Catalogue catalogue(instance);
        const std::string what =
            family.name + " n " + std::to_string(n) + " seed " + std::to_string(seed);
        expect_lemma_4(instance, catalogue, what);
        expect_fixed_edges_are_those_of_all(catalogue, n - 3, what);
        expect_first_order_flips_are_independent(instance, catalogue, what);
      }
    }
  }
}

TEST(Lemma4, hulls_are_what_a_useful_edge_needs) {
  // Useful edge and hull: the Delaunay triangles off the hull can stay.
  for (const auto& family : families::all()) {
    const Instance instance(family.make(8, 21));
    const Catalogue catalogue(instance);
    const Triangles delaunay = instance.delaunay();
    for (int u = 0; u < instance.size(); ++u) {
      for (int v = u + 1; v < instance.size(); ++v) {
        const auto order = catalogue.useful_order(u, v);
        if (!order || *order == 0) continue;
        const Triangles hull = instance.hull_of_edge(u, v);
        EXPECT_GE(hull.size(), 2u);
        EXPECT_LE(hull.size(), 2u * *order) << "at most 2k + 2 vertices, so 2k triangles";
        const bool stays = std::ranges::any_of(catalogue.triangulations(), [&](const auto& t) {
          if (t.order > *order) return false;
          Triangles common;
          std::ranges::set_intersection(t.triangles, delaunay, std::back_inserter(common));
          const bool has_edge = std::ranges::any_of(t.triangles, [&](const auto& corners) {
            return std::ranges::count(corners, u) && std::ranges::count(corners, v);
          });
          return has_edge && common.size() >= delaunay.size() - hull.size();
        });
        EXPECT_TRUE(stays) << family.name << ' ' << u << ' ' << v;
      }
    }
  }
}

TEST(Valid, triangles_of_a_triangulation_are_valid) {
  for (const auto& family : families::all()) {
    const Instance instance(family.make(7, 13));
    const Catalogue catalogue(instance);
    for (int k = 0; k <= 4; ++k) {
      const Triangles valid = catalogue.valid_triangles(k);
      for (const auto& t : instance.empty_triangles(oracle::kUnrestricted)) {
        const auto least = catalogue.least_order_with(t);
        ASSERT_TRUE(least) << "every empty triangle is in some triangulation";
        if (*least > k) continue;
        EXPECT_TRUE(std::ranges::binary_search(valid, t)) << family.name << " k " << k;
      }
    }
  }
}

// ---- Extrema --------------------------------------------------------------------------------

TEST(Extrema, of_a_strip) {
  // Two cells with the diagonals (1, 0)-(0, 1) and (2, 0)-(1, 1).
  const Points points{{0, 0}, {0, 1}, {1, 0}, {1, 1}, {2, 0}, {2, 1}};
  const Instance strip(points, {4, 0, 2, 3, 5, 1});
  const auto count = strip.count_extrema(strip.delaunay());
  EXPECT_EQ(count.minima.total(), 2);
  EXPECT_EQ(count.maxima.total(), 2);
  EXPECT_EQ(count.minima.interior, 0);
  const auto optima = Catalogue(strip).optima(strip);
  EXPECT_EQ(oracle::Optima::at(optima.extrema, 1), 4);
  // With the outline and the middle edge alone there would be six: two joined by both cells.
  EXPECT_EQ(Catalogue(strip).fixed_edges(1).size(), 7u);
}

TEST(Extrema, one_flip_drains_a_pit) {
  // A valley along the x axis, dammed by the edge between its banks.
  const Instance dam({{0, -1}, {4, 0}, {0, 1}, {-4, 0}, {-9, 9}}, {5, 1, 5, 0, 9});
  EXPECT_EQ(dam.count_extrema(dam.delaunay()).minima.total(), 2);
  const auto optima = Catalogue(dam).optima(dam);
  EXPECT_EQ(oracle::Optima::at(optima.minima, 0), 2);
  EXPECT_EQ(oracle::Optima::at(optima.minima, 1), 1);
  EXPECT_EQ(oracle::Optima::at(optima.minima, 99), 1);
}

TEST(Extrema, ties_are_broken_by_position) {
  const Instance flat({{0, 0}, {2, 0}, {0, 2}, {2, 2}, {1, 1}}, {7, 7, 7, 7, 7});
  const auto count = flat.count_extrema(flat.delaunay());
  EXPECT_EQ(count.minima, (oracle::SplitCount{0, 1}));  // (0, 0)
  EXPECT_EQ(count.maxima, (oracle::SplitCount{0, 1}));  // (2, 2)
  EXPECT_EQ(count.pits, (oracle::SplitCount{0, 1}));    // all of it, and it touches the boundary
}

TEST(Extrema, pits_are_connected_sets) {
  // A ring of height 1 around a hill, with an outer ring of height 3: one pit, inside.
  Points points{{0, 0}};
  oracle::Heights z{2};
  for (const int r : {1, 4}) {
    for (const auto& [x, y] : {std::pair{r, 0}, {0, r}, {-r, 0}, {0, -r}}) {
      points.emplace_back(x, y);
      z.push_back(r == 1 ? 1 : 3);
    }
  }
  const Instance moat(points, z);
  const auto count = moat.count_extrema(moat.delaunay());
  EXPECT_EQ(count.pits, (oracle::SplitCount{1, 0}));
  EXPECT_EQ(count.minima, (oracle::SplitCount{1, 0}));  // (-1, 0) beats (0, ±1), they beat (1, 0)
  EXPECT_EQ(count.maxima.interior, 1);                  // the hill
}

TEST(Extrema, optima_agree_with_counting_one_by_one) {
  for (const auto& family : families::all()) {
    const Points points = family.make(7, 17);
    Instance instance(points);
    const Catalogue catalogue(instance);
    for (const auto& heights : families::all_heights()) {
      instance.set_heights(heights.make(points, 3));
      oracle::expect_optima(catalogue, instance,
                            [&](const Triangles& t) { return instance.count_extrema(t); });
    }
  }
}

// ---- Families -------------------------------------------------------------------------------

TEST(Families, give_what_they_promise) {
  for (const auto& family : families::all()) {
    for (int n = 4; n <= 16; ++n) {
      for (std::uint64_t seed = 0; seed < 5; ++seed) {
        const Points points = family.make(n, seed);
        const Instance instance(points);  // throws on equal points
        EXPECT_FALSE(instance.all_collinear()) << family.name;
        EXPECT_LE(instance.size(), n) << family.name;
        EXPECT_GE(instance.size(), std::min(n, 12)) << family.name;
        EXPECT_EQ(points, family.make(n, seed)) << family.name;
      }
    }
  }
}

TEST(Families, rings_are_cocircular) {
  const Instance ring(families::ring(64, 1));
  ASSERT_EQ(ring.size(), 64);
  for (int i = 3; i < 64; ++i) EXPECT_EQ(ring.in_circle_plain(0, 1, 2, i), 0);
}

}  // namespace
