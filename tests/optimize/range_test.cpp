#include "hodt/optimize/range.h"

#include <cfloat>
#include <cmath>
#include <string>
#include <vector>

#include "../support/convert.h"
#include "../support/shapes.h"
#include <gmpxx.h>
#include <gtest/gtest.h>

#include "hodt/base/error.h"
#include "hodt/optimize/measure/edge_measures.h"
#include "hodt/optimize/measure/measures.h"
#include "hodt/optimize/optimize.h"

namespace hodt {
namespace {

std::vector<Objective> all_objectives() {
  std::vector<Objective> all;
  for (const Direction d : {Direction::minimize, Direction::maximize})
    for (const Aggregate a : {Aggregate::sum, Aggregate::max, Aggregate::min}) {
      for (int m = 0; m < TriangleMeasure::own; ++m)
        all.emplace_back(d, a, TriangleMeasure::Kind(m));
      for (int m = 0; m < EdgeMeasure::own; ++m) all.emplace_back(d, a, EdgeMeasure::Kind(m));
    }
  return all;
}

/// Of what power of the unit of length.
int degree_of(const Objective& objective) {
  const std::string name = name_of(objective);
  if (name.ends_with("area")) return 2;
  return name.ends_with("angle") || name.ends_with("-abn") || name.ends_with("jnd") ? 0 : 1;
}

Value optimum(const support::Points& points, const std::vector<double>& z,
              const Objective& objective, Index k) {
  const Delaunay d = delaunay({points, z});
  const DelaunayGraph graph(d);
  return optimize(graph, d.vertices.z, objective, {.order = k}).value;
}

TEST(Range, plain_numbers) {
  const std::vector<double> plain{0, -0.0, 1, -1e30, 1e-29, 5e-17};
  EXPECT_TRUE(is_plain(plain));
  for (const double x : {1e31, 1e-30, -DBL_TRUE_MIN, DBL_MAX}) {
    std::vector<double> numbers(100000, 1);
    numbers[77777] = x;
    EXPECT_FALSE(is_plain(numbers)) << x;
    const std::vector<Point> as_x{{1, 2}, {x, 2}}, as_y{{1, x}, {1, 2}};
    EXPECT_FALSE(is_plain(as_x)) << x;
    EXPECT_FALSE(is_plain(as_y)) << x;
  }
}

/// Scaled by a power of two the values are what they were times one, or an error where no double
/// can hold them. They were capped, or zero.
TEST(Range, lattices_of_any_size_measure_the_same) {
  const support::Points points = support::lattice(4, 4);
  const std::vector<double> z = support::rough_heights(points, 0.5, 3);
  for (const Objective& objective : all_objectives())
    for (const Index k : {0u, 1u, 3u}) {
      const Value value = optimum(points, z, objective, k);
      for (const int scale : {-1000, -600, -520, -300, -90, 90, 120, 340, 498, 520, 1000}) {
        support::Points scaled = points;
        std::vector<double> heights = z;
        for (Point& p : scaled) p = {std::ldexp(p.x, scale), std::ldexp(p.y, scale)};
        for (double& height : heights) height = std::ldexp(height, scale);
        const int exponent = degree_of(objective) * scale;
        const std::string what =
            name_of(objective) + ' ' + std::to_string(k) + " 2^" + std::to_string(scale);
        if (exponent < -1000 || exponent > 1000) {
          if (value.delaunay == 0) continue;
          EXPECT_THROW(optimum(scaled, heights, objective, k), InputError) << what;
          continue;
        }
        try {
          const Value found = optimum(scaled, heights, objective, k);
          const auto expect_scaled = [&](double x, double unscaled) {
            EXPECT_NEAR(std::ldexp(x, -exponent), unscaled, 1e-13 * unscaled) << what;
          };
          expect_scaled(found.delaunay, value.delaunay);
          expect_scaled(found.result, value.result);
          expect_scaled(found.bound, value.bound);
          EXPECT_EQ(found.optimal, value.optimal) << what;
        } catch (const Error& error) {
          ADD_FAILURE() << what << ": " << error.what();
        }
      }
    }
}

/// The bound on sums of capped areas was larger than the result.
TEST(Range, areas_that_no_double_holds_are_an_error) {
  const support::Points points{
      {-1e307, 2e307}, {0, 0}, {-2e307, -1e307}, {-2e307, -2e307}, {2e307, -2e307}};
  const std::vector<double> z{6e307, -9e307, 0, -3e307, -9e307};
  for (const char* name : {"min-sum-area", "max-min-area", "min-max-area", "min-sum-length"})
    for (const Index k : {0u, 1u, 2u, 100u}) {
      try {
        optimum(points, z, objective_from_name(name), k);
        ADD_FAILURE() << name << ' ' << k;
      } catch (const InputError& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find("divide"), std::string::npos) << message;
        EXPECT_NE(message.find(name), std::string::npos) << message;
      }
    }
  for (const char* name : {"min-max-length", "min-max-circumradius", "max-sum-angle", "min-sum-abn",
                           "min-max-flat-area", "max-max-jnd"})
    for (const Index k : {0u, 1u, 2u, 100u}) {
      const Value value = optimum(points, z, objective_from_name(name), k);
      EXPECT_TRUE(std::isfinite(value.delaunay) && std::isfinite(value.bound)) << name;
      if (name[1] == 'i') {
        EXPECT_LE(value.bound, value.result) << name;
      } else {
        EXPECT_GE(value.bound, value.result) << name;
      }
    }
}

/// It was below the result by a last place, as sums were added up in another order.
TEST(Range, a_bound_for_the_largest_sum_is_no_less_than_the_result) {
  const support::Points points{{3, 2}, {4, 2}, {4, 1}, {0, 3}, {3, 3}};
  const Value value =
      optimum(points, {0, 4, 0, 2, 3}, objective_from_name("max-sum-enclosing-radius"), 3);
  EXPECT_GE(value.bound, value.result);
  EXPECT_LE(value.bound, value.result * (1 + 1e-14));
  EXPECT_GE(value.result, value.delaunay);
  EXPECT_TRUE(value.optimal);
}

/// Three points of a slanted line, rounded: the computed area was 0 and the radius 1e150, however
/// large it is.
TEST(Range, slivers_that_rounding_makes_are_measured) {
  std::size_t thin = 0;
  for (int i = 1; i < 200; ++i) {
    const double t = 0.1 * i;
    const support::Points p{
        {0.1, 0.1 / 3}, {t + 0.1, (t + 0.1) / 3}, {2 * t + 0.1, (2 * t + 0.1) / 3}};
    using Q = mpq_class;
    const Q twice =
        (Q(p[1].x) - p[0].x) * (Q(p[2].y) - p[0].y) - (Q(p[1].y) - p[0].y) * (Q(p[2].x) - p[0].x);
    if (twice == 0) continue;
    const double computed =
        (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
    const auto side = [&](int a, int b) { return std::hypot(p[a].x - p[b].x, p[a].y - p[b].y); };
    const double radius = side(0, 1) * side(1, 2) * side(2, 0) / (2 * std::fabs(twice.get_d()));
    const TriangleValues values(objective_from_name("min-sum-circumradius"), p, {});
    const double value = values.of(VertexId(0), VertexId(1), VertexId(2));
    EXPECT_TRUE(std::isfinite(value));
    if (computed != 0) continue;
    ++thin;
    EXPECT_EQ(values.of(VertexId(2), VertexId(0), VertexId(1)), value);
    // Unless another corner's product is not 0: then that counts, rounded.
    if (value > 0.9 * radius && value < 1.1 * radius) {
      EXPECT_NEAR(value, radius, 1e-13 * radius);
    }
    const std::vector<double> z{0, 1, 5};
    const EdgeValues slopes(objective_from_name("min-sum-jnd"), p, z);
    const auto g = slopes.gradient(VertexId(0), VertexId(1), VertexId(2));
    EXPECT_TRUE(std::isfinite(g.x) && std::isfinite(g.y));
  }
  EXPECT_GT(thin, 3u);
}

/// Sums of the very largest values are out of range as well, though each is not.
TEST(Range, sums_out_of_range_are_an_error) {
  support::Points points = support::lattice(6, 6);
  for (Point& p : points) p = {std::ldexp(p.x, 1020), std::ldexp(p.y, 1020)};
  EXPECT_THROW(optimum(points, {}, objective_from_name("min-sum-length"), 1), InputError);
  EXPECT_THROW(optimum(points, {}, objective_from_name("min-sum-length"), 3), InputError);
  const Value largest = optimum(points, {}, objective_from_name("min-max-length"), 3);
  EXPECT_EQ(largest.result, std::ldexp(std::sqrt(2.0), 1020));
  EXPECT_EQ(largest.bound, largest.result);
}

/// The better pair of triangles was not seen, as its sum was infinite, and the worse one said to be
/// the optimum.
TEST(Range, an_optimum_out_of_range_is_an_error) {
  support::Points points{{-1, -1}, {-3, -1}, {-1, -3}, {-3, -2}};
  for (Point& p : points) p = {std::ldexp(p.x, 1020), std::ldexp(p.y, 1020)};
  const OwnTriangleMeasure steps{"steps", [](const auto& a, const auto& b, const auto& c) {
                                   const auto side = [](const auto& p, const auto& q) {
                                     return std::fabs(p.x - q.x) + std::fabs(p.y - q.y);
                                   };
                                   return side(a, b) + side(b, c) + side(c, a);
                                 }};
  EXPECT_THROW(optimum(points, {}, Objective(Direction::maximize, Aggregate::sum, steps), 1),
               InputError);
}

/// Sizes of sums were infinite where sums were not, and no gain was more than that.
TEST(Range, the_largest_sums_are_improved) {
  support::Points points{{2, -2}, {2, -3}, {1, -3}, {0, -2}};
  for (Point& p : points) p = {std::ldexp(p.x, 1020), std::ldexp(p.y, 1020)};
  const OwnTriangleMeasure steps{"steps", [](const auto& a, const auto& b, const auto& c) {
                                   const auto side = [](const auto& p, const auto& q) {
                                     return std::fabs(p.x - q.x) + std::fabs(p.y - q.y);
                                   };
                                   return side(a, b) + side(b, c) + side(c, a);
                                 }};
  for (const Direction direction : {Direction::minimize, Direction::maximize})
    for (const Index k : {1u, 2u}) {
      const Objective objective(direction, Aggregate::sum, steps);
      const Value value = optimum(points, {}, objective, k);
      EXPECT_TRUE(value.optimal) << name_of(objective) << k;
    }
}

}  // namespace
}  // namespace hodt
