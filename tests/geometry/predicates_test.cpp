// The predicates against determinants in GMP integers, stage by stage, and the laws of
// predicates.h.
#include "hodt/geometry/predicates.h"

#include <array>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <ostream>
#include <vector>

#include "exact_oracle.h"
#include "quads.h"
#include <gmpxx.h>
#include <gtest/gtest.h>

#include "hodt/geometry/predicate_stages.h"

namespace hodt {

void PrintTo(const Point& p, std::ostream* out) {
  *out << std::hexfloat << "(" << p.x << ", " << p.y << ")" << std::defaultfloat;
}

namespace {

using exact::CircleFilter;
using exact::Filtered;
using exact::kUndecided;
using quads::Family;
using quads::Quad;
using quads::Random;

/// Puts the first three counter-clockwise. False if they are on a line.
bool make_ccw(Quad& q) {
  const int sign = exact_oracle::orient(q[0], q[1], q[2]);
  if (sign < 0) std::swap(q[1], q[2]);
  return sign != 0;
}

int filter_sign(const Filtered& f) {
  return f.certain() ? (f.value > 0) - (f.value < 0) : kUndecided;
}

// ---- Every stage, on every family, against the oracle ----

class Predicates : public testing::TestWithParam<Family> {
 protected:
  static constexpr int kCount = 1500;
};

std::string family_name(const testing::TestParamInfo<Family>& info) {
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Families, Predicates, testing::ValuesIn(quads::kFamilies), family_name);
INSTANTIATE_TEST_SUITE_P(Mixture, Predicates, testing::Values(Family{"mixture", quads::mixture}),
                         family_name);

TEST_P(Predicates, OrientIsExactInEveryStage) {
  Random random(1);
  for (int i = 0; i < kCount; ++i) {
    const Quad q = GetParam().make(random);
    const Point &a = q[0], &b = q[1], &c = q[2];
    SCOPED_TRACE(testing::PrintToString(q));
    const int truth = exact_oracle::orient(a, b, c);
    const Filtered f = exact::orient_rounded(a, b, c);
    for (const int sign : {filter_sign(f), exact::orient_lattice(f, a, b, c),
                           exact::orient_fixed(a, b, c), exact::orient_long(a, b, c)})
      if (sign != kUndecided) {
        ASSERT_EQ(sign, truth);
      }
    ASSERT_EQ(exact::orient_big(a, b, c), truth);
    ASSERT_EQ(exact::orient_after_filter(f, a, b, c), truth);
    ASSERT_EQ(orient(a, b, c), truth);
    ASSERT_EQ(orient(b, c, a), truth);
    ASSERT_EQ(orient(b, a, c), -truth);
  }
}

TEST_P(Predicates, InCirclePlainIsExactInEveryStage) {
  Random random(2);
  for (int i = 0; i < kCount; ++i) {
    Quad q = GetParam().make(random);
    if (!make_ccw(q)) continue;
    const Point &a = q[0], &b = q[1], &c = q[2], &d = q[3];
    SCOPED_TRACE(testing::PrintToString(q));
    const int truth = exact_oracle::in_circle_plain(a, b, c, d);
    const Filtered f = CircleFilter(a, b, c)(d);
    if (f.certain()) {
      ASSERT_EQ(f.value < 0 ? 1 : -1, truth);
    }
    if (exact::is_rectangle(a, b, c, d)) {
      ASSERT_EQ(truth, 0);
    }
    for (const int sign : {exact::in_circle_lattice(f, a, b, c, d),
                           exact::in_circle_fixed(a, b, c, d), exact::in_circle_long(a, b, c, d)})
      if (sign != kUndecided) {
        ASSERT_EQ(sign, truth);
      }
    ASSERT_EQ(exact::in_circle_big(a, b, c, d), truth);
    ASSERT_EQ(exact::in_circle_plain_after_filter(f, a, b, c, d), truth);
    ASSERT_EQ(in_circle_plain(a, b, c, d), truth);
    ASSERT_EQ(in_circle_plain(b, c, a, d), truth);
    ASSERT_EQ(in_circle_plain(c, a, b, d), truth);
  }
}

TEST_P(Predicates, InCircleIsExactForRaisedLifts) {
  Random random(3);
  for (int i = 0; i < kCount; ++i) {
    Quad q = GetParam().make(random);
    if (!make_ccw(q)) continue;
    const Point &a = q[0], &b = q[1], &c = q[2], &d = q[3];
    SCOPED_TRACE(testing::PrintToString(q));
    const bool is_corner = d == a || d == b || d == c;
    const bool truth = !is_corner && exact_oracle::in_circle(a, b, c, d);
    ASSERT_EQ(in_circle(a, b, c, d), truth);
    ASSERT_EQ(in_circle(b, c, a, d), truth);
    ASSERT_EQ(in_circle(c, a, b, d), truth);
    if (exact_oracle::in_circle_plain(a, b, c, d) == 0) {
      ASSERT_EQ(exact::in_circle_tie(a, b, c, d), truth);
      if (exact::is_rectangle(a, b, c, d)) {
        ASSERT_EQ(exact::rectangle_tie(a, b, c, d), truth);
      }
    }
  }
}

// The bounds are proved in comments; here they are held against true errors, also where the sign is
// not in doubt.
TEST_P(Predicates, BoundsHold) {
  Random random(4);
  for (int i = 0; i < kCount; ++i) {
    const Quad q = GetParam().make(random);
    const Filtered f = CircleFilter(q[0], q[1], q[2])(q[3]);
    if (!std::isfinite(f.value) || !(f.bound <= DBL_MAX)) continue;
    const mpz_class error = exact_oracle::integer(f.value, 4 * 1074) +
                            exact_oracle::in_circle_determinant(q[0], q[1], q[2], q[3]);
    ASSERT_LE(abs(error), exact_oracle::integer(f.bound, 4 * 1074)) << testing::PrintToString(q);
  }
}

// ---- Which stage decides ----

enum class Stage { kFilter, kRectangle, kLattice, kFixed, kLong, kBig };

Stage orient_stage(const Point& a, const Point& b, const Point& c) {
  const Filtered f = exact::orient_rounded(a, b, c);
  if (f.certain()) return Stage::kFilter;
  if (exact::orient_lattice(f, a, b, c) != kUndecided) return Stage::kLattice;
  if (exact::orient_fixed(a, b, c) != kUndecided) return Stage::kFixed;
  if (exact::orient_long(a, b, c) != kUndecided) return Stage::kLong;
  return Stage::kBig;
}

Stage in_circle_stage(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Filtered f = CircleFilter(a, b, c)(d);
  if (f.certain()) return Stage::kFilter;
  if (exact::is_rectangle(a, b, c, d)) return Stage::kRectangle;
  if (exact::in_circle_lattice(f, a, b, c, d) != kUndecided) return Stage::kLattice;
  if (exact::in_circle_fixed(a, b, c, d) != kUndecided) return Stage::kFixed;
  if (exact::in_circle_long(a, b, c, d) != kUndecided) return Stage::kLong;
  return Stage::kBig;
}

/// The share of in_circle questions of a family that a stage decides.
double share(Quad (*make)(Random&), Stage stage) {
  Random random(5);
  int all = 0, decided = 0;
  while (all < 10000) {
    Quad q = make(random);
    if (!make_ccw(q)) continue;
    ++all;
    decided += in_circle_stage(q[0], q[1], q[2], q[3]) == stage;
  }
  return static_cast<double>(decided) / all;
}

TEST(Stages, FilterDecidesRandomPoints) {
  EXPECT_GE(share(quads::random_square, Stage::kFilter), 0.999);
}

TEST(Stages, RectangleDecidesGridCells) {
  EXPECT_EQ(share(quads::decimal_rectangle, Stage::kRectangle), 1);
}

TEST(Stages, LatticeDecidesIntegerTies) {
  EXPECT_GE(share(quads::integer_ring, Stage::kLattice), 0.9);
  EXPECT_EQ(share(quads::integer_ring, Stage::kFixed) + share(quads::integer_ring, Stage::kBig), 0);
}

TEST(Stages, FixedWidthDecidesWideTiesAndLastBits) {
  EXPECT_GE(share(quads::wide_ring, Stage::kFixed), 0.9);
  EXPECT_GE(share(quads::nudged_ring, Stage::kFixed), 0.2);
  EXPECT_EQ(share(quads::nudged_ring, Stage::kBig), 0);
}

/// Whether long doubles are wider here: if not, their stage decides nothing.
bool has_long_stage() {
  return exact::orient_long({0, 0}, {1, 0}, {0, 1}) == 1;
}

Quad far_wider_than_high(Random& random) {
  Quad quad = quads::random_square(random);
  for (Point& p : quad) p = {1e150 * p.x, 1e-150 * p.y};
  return quad;
}

// Points x · 1e150, y · 1e-150 took big integers for every question, 1.4 ms a point for edges.
TEST(Stages, LongDoublesDecideWhatSpansMoreBits) {
  if (!has_long_stage()) GTEST_SKIP();
  // Where one number is larger than the others by more digits than there are, nothing is left.
  EXPECT_GE(share(quads::any_bits, Stage::kLong), 0.6);
  EXPECT_GE(share(far_wider_than_high, Stage::kLong), 0.999);
}

TEST(Stages, BigDecidesTiesThatSpanMoreBits) {
  EXPECT_GE(share(quads::huge_ring, Stage::kBig), 0.9);
}

TEST(Stages, OrientOfCollinearPoints) {
  EXPECT_EQ(orient_stage({0, 0}, {1, 0}, {0, 1}), Stage::kFilter);
  EXPECT_EQ(orient_stage({0, 0}, {1, 1}, {2, 2}), Stage::kLattice);
  EXPECT_EQ(orient_stage({412345, 5123456}, {412375, 5123486}, {412405, 5123516}), Stage::kLattice);
  EXPECT_EQ(orient_stage({0.1, 0.1}, {0.3, 0.3}, {0.7, 0.7}), Stage::kFixed);
  EXPECT_EQ(orient_stage({1e-20, 1e-20}, {1, 1}, {1e20, 1e20}), Stage::kBig);
}

// ---- Single cases ----

TEST(Orient, IsNotFooledByOverflow) {
  const double m = DBL_MAX;
  EXPECT_EQ(orient({-m, -m}, {m, m}, {0, 0}), 0);
  EXPECT_EQ(orient({-m, -m}, {m, m}, {-DBL_TRUE_MIN, 0}), 1);
  EXPECT_EQ(orient({-m, -m}, {m, m}, {DBL_TRUE_MIN, 0}), -1);
  EXPECT_EQ(orient({-m, -m}, {m, -m}, {m, m}), 1);
}

TEST(Orient, IsNotFooledByUnderflow) {
  const double s = DBL_TRUE_MIN;
  EXPECT_EQ(orient({0, 0}, {s, 0}, {0, s}), 1);
  EXPECT_EQ(orient({0, 0}, {s, s}, {2 * s, 2 * s}), 0);
  EXPECT_EQ(orient({0, 0}, {1, s}, {2, 3 * s}), 1);
}

// Both products underflow. The smaller one lands on the tie between 1 and 2 units, because a
// difference was rounded up, and becomes 2; the larger one is just below that tie and becomes 1.
TEST(Orient, IsNotFooledByRoundingInUnderflow) {
  const double s = std::ldexp(1, -537);
  const Point a = {s, (1 + 0x2p-52) * s}, b = {(1.5 - 0x3p-52) * s, 1.5 * s};
  const Point c = {std::ldexp(1, -597), 0};
  ASSERT_GT((a.x - c.x) * (b.y - c.y), (a.y - c.y) * (b.x - c.x));
  EXPECT_EQ(exact_oracle::orient(a, b, c), -1);
  EXPECT_EQ(orient(a, b, c), -1);
}

TEST(InCircle, UnitSquare) {
  const Point a = {0, 0}, b = {1, 0}, c = {1, 1}, d = {0, 1};
  for (const auto& q : {Quad{a, b, c, d}, Quad{b, c, d, a}, Quad{c, d, a, b}, Quad{d, a, b, c}})
    EXPECT_EQ(in_circle_plain(q[0], q[1], q[2], q[3]), 0);
  // c is the largest: its lift is raised, so the diagonal is bd.
  EXPECT_TRUE(in_circle(a, b, c, d));
  EXPECT_TRUE(in_circle(c, d, a, b));
  EXPECT_FALSE(in_circle(a, b, d, c));
  EXPECT_FALSE(in_circle(b, c, d, a));
}

TEST(InCircle, ACornerIsOutside) {
  const Point a = {0.1, 0.2}, b = {3.3, 0.7}, c = {1.9, 5.1};
  for (const Point& d : {a, b, c}) {
    EXPECT_EQ(in_circle_plain(a, b, c, d), 0);
    EXPECT_FALSE(in_circle(a, b, c, d));
  }
}

TEST(InCircle, IsNotFooledByOverflow) {
  const double m = DBL_MAX;
  EXPECT_EQ(in_circle_plain({-m, -m}, {m, -m}, {-m, m}, {m, m}), 0);
  EXPECT_EQ(in_circle_plain({-m, -m}, {m, -m}, {-m, m}, {m, std::nextafter(m, 0)}), 1);
  EXPECT_EQ(in_circle_plain({-m, 0}, {0, -m}, {m, 0}, {0, m}), 0);
  EXPECT_EQ(in_circle_plain({-m, 0}, {0, -m}, {m, 0}, {DBL_TRUE_MIN, m}), -1);
}

// One point far away, three so near each other that the squares of their differences underflow, but
// not the product of a square and the far one's: a bound that forgets underflow believes noise
// here.
TEST(InCircle, IsNotFooledByUnderflow) {
  const double s = std::ldexp(1, -538), far = std::ldexp(1, 500);
  for (int i = -8; i <= 8; ++i)
    for (int j = -8; j <= 8; ++j) {
      Quad q = {Point{0, 0}, {3 * s, 5 * s}, {far, far / 3}, {i * s, j * s}};
      ASSERT_TRUE(make_ccw(q));
      EXPECT_EQ(in_circle_plain(q[0], q[1], q[2], q[3]),
                exact_oracle::in_circle_plain(q[0], q[1], q[2], q[3]));
    }
}

// ---- Laws ----

/// The lattice points on the circle x² + y² = radius² about the origin.
std::vector<Point> lattice_circle(int radius_squared) {
  std::vector<Point> result;
  for (int x = -99; x <= 99; ++x)
    for (int y = -99; y <= 99; ++y)
      if (x * x + y * y == radius_squared)
        result.push_back({static_cast<double>(x), static_cast<double>(y)});
  return result;
}

TEST(Laws, OneDiagonalOfACocircularQuadrilateral) {
  Random random(6);
  for (int i = 0; i < 5000; ++i) {
    Quad q = quads::integer_ring(random);
    if (!make_ccw(q)) continue;
    // Only abdc, counter-clockwise: d on the other side of bc from a.
    const Point &a = q[0], &b = q[1], &c = q[2], &d = q[3];
    if (orient(c, b, d) <= 0) continue;
    const bool diagonal_bc = !in_circle(a, b, c, d);
    EXPECT_EQ(in_circle(d, c, b, a), !diagonal_bc);
    EXPECT_EQ(in_circle(a, b, d, c), diagonal_bc);
    EXPECT_EQ(in_circle(a, d, c, b), diagonal_bc);
  }
}

// A convex n-gon has n - 2 triangles. If the raised points are in convex position, exactly so many
// triples are empty.
TEST(Laws, CocircularPointsHaveOneTriangulation) {
  for (const int radius_squared : {1, 2, 5, 25, 325, 1105, 5525}) {
    const std::vector<Point> points = lattice_circle(radius_squared);
    ASSERT_GE(points.size(), 4u);
    std::size_t empty = 0;
    for (const Point& a : points)
      for (const Point& b : points)
        for (const Point& c : points) {
          if (!lexicographically_less(a, b) || !lexicographically_less(a, c) ||
              orient(a, b, c) <= 0)
            continue;
          std::size_t inside = 0;
          for (const Point& d : points) inside += in_circle(a, b, c, d);
          empty += inside == 0;
        }
    EXPECT_EQ(empty, points.size() - 2) << radius_squared;
  }
}

}  // namespace
}  // namespace hodt
