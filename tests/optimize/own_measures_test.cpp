#include "hodt/optimize/own_measures.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "../support/convert.h"
#include "../support/shapes.h"
#include <gtest/gtest.h>

#include "hodt/base/error.h"
#include "hodt/optimize/measure/edge_measures.h"
#include "hodt/optimize/measure/measures.h"
#include "hodt/optimize/optimize.h"

namespace hodt {
namespace {

constexpr Direction kDirections[] = {Direction::minimize, Direction::maximize};
constexpr Aggregate kAggregates[] = {Aggregate::sum, Aggregate::max, Aggregate::min};

struct Terrain {
  explicit Terrain(const support::Points& points)
      : delaunay(hodt::delaunay({points, support::rough_heights(points, 0.3, 6)})),
        graph(delaunay) {
    for (Index v = 0; v < delaunay.vertices.size(); ++v) {
      const Point& p = delaunay.vertices.xy[v];
      at[{p.x, p.y}] = VertexId(v);
    }
  }
  std::span<const double> z() const { return delaunay.vertices.z; }
  VertexId vertex(const Corner& c) const { return at.at({c.x, c.y}); }

  Delaunay delaunay;
  DelaunayGraph graph;
  std::map<std::pair<double, double>, VertexId> at;
};

/// The same values, bound and triangles.
void expect_same(const Terrain& terrain, const Objective& built_in, const Objective& own) {
  for (const Index k : {0u, 1u, 2u, 4u})
    for (const Method method : {Method::automatic, Method::flip}) {
      const OptimizeOptions options{.order = k, .method = method};
      const Optimum expected = optimize(terrain.graph, terrain.z(), built_in, options);
      const Optimum found = optimize(terrain.graph, terrain.z(), own, options);
      const std::string what = name_of(built_in) + ' ' + std::to_string(k);
      EXPECT_EQ(found.value.delaunay, expected.value.delaunay) << what;
      EXPECT_EQ(found.value.result, expected.value.result) << what;
      EXPECT_EQ(found.value.bound, expected.value.bound) << what;
      EXPECT_EQ(found.value.optimal, expected.value.optimal) << what;
      EXPECT_TRUE(support::same_arrays(found.change.applied_to(terrain.delaunay.mesh),
                                       expected.change.applied_to(terrain.delaunay.mesh)))
          << what;
    }
}

/// The same, and never asked for one edge where many are to be measured.
OwnEdgeMeasure asked_for_many(OwnEdgeMeasure measure) {
  measure.of_many = [of = measure.of](std::span<const std::array<Corner, 4>> edges,
                                      std::span<double> values) {
    ASSERT_EQ(edges.size(), values.size());
    for (std::size_t i = 0; i < edges.size(); ++i)
      values[i] = of(edges[i][0], edges[i][1], edges[i][2], edges[i][3]);
  };
  return measure;
}

TEST(OwnMeasures, equal_the_built_in_ones_that_they_call) {
  for (const support::Points& points : {support::uniform(300, 5), support::lattice(15, 15)}) {
    const Terrain terrain(points);
    for (const Direction d : kDirections)
      for (const Aggregate a : kAggregates) {
        for (const TriangleMeasure m :
             {TriangleMeasure(TriangleMeasure::area), TriangleMeasure(TriangleMeasure::inradius),
              TriangleMeasure(TriangleMeasure::circumradius),
              TriangleMeasure(TriangleMeasure::flat_area)}) {
          const Objective built_in(d, a, m);
          const TriangleValues values(built_in, terrain.graph.xy, terrain.z());
          const OwnTriangleMeasure own{"own", [&](const auto& p, const auto& q, const auto& r) {
                                         return values.of(terrain.vertex(p), terrain.vertex(q),
                                                          terrain.vertex(r));
                                       }};
          expect_same(terrain, built_in, Objective(d, a, own));
        }
        for (const EdgeMeasure::Kind m : {EdgeMeasure::abn, EdgeMeasure::jnd, EdgeMeasure::wabn}) {
          const Objective built_in(d, a, m);
          const EdgeValues values(built_in, terrain.graph.xy, terrain.z());
          const OwnEdgeMeasure own{
              "own", [&](const auto& p, const auto& q, const auto& left, const auto& right) {
                return values.of(terrain.vertex(p), terrain.vertex(q), terrain.vertex(left),
                                 terrain.vertex(right));
              }};
          const OwnEdgeMeasure many = asked_for_many(own);
          expect_same(terrain, built_in, Objective(d, a, own));
          expect_same(terrain, built_in, Objective(d, a, many));
        }
      }
  }
}

double radius_ratio(const Corner& a, const Corner& b, const Corner& c) {
  const double p = std::hypot(a.x - b.x, a.y - b.y), q = std::hypot(b.x - c.x, b.y - c.y);
  const double r = std::hypot(c.x - a.x, c.y - a.y);
  return std::max(0.0, (p + q - r) * (q + r - p) * (r + p - q)) / (p * q * r);
}

/// Not the same from both sides: the left is the side where the order of the ends says so.
double one_sided(const Corner& a, const Corner& b, const Corner& left, const Corner& right) {
  const double turn = (b.x - a.x) * (left.y - a.y) - (b.y - a.y) * (left.x - a.x);
  const double other = (b.x - a.x) * (right.y - a.y) - (b.y - a.y) * (right.x - a.x);
  EXPECT_GT(turn, 0);
  EXPECT_LT(other, 0);
  return std::fabs(left.z - right.z) + std::fabs(a.z - b.z) * turn;
}

double combined(Aggregate aggregate, const std::vector<double>& values) {
  if (values.empty()) return 0;
  if (aggregate == Aggregate::max) return *std::max_element(values.begin(), values.end());
  if (aggregate == Aggregate::min) return *std::min_element(values.begin(), values.end());
  double sum = 0;
  for (const double value : values) sum += value;
  return sum;
}

/// New measures against all triangulations of small sets: the optimum where that is said, never
/// past the bound.
class NewMeasures : public testing::Test {
 protected:
  template <class ValueOf>
  static void compare(const Terrain& terrain, const oracle::Catalogue& catalogue,
                      const Objective& objective, const ValueOf& value_of) {
    const double sign = objective.direction == Direction::minimize ? 1 : -1;
    for (const Index k : {0u, 1u, 2u, 3u, 100u}) {
      double best = sign * std::numeric_limits<double>::infinity();
      for (const oracle::Triangulation& t : catalogue.triangulations())
        if (t.order <= int(k)) best = sign * std::min(sign * best, sign * value_of(t.triangles));
      const Optimum found = optimize(terrain.graph, terrain.z(), objective, {.order = k});
      const std::string what = name_of(objective) + ' ' + std::to_string(k) + ' ' +
                               support::to_source(terrain.graph.xy, terrain.z());
      const double slack = 1e-9 * (1 + best);
      const double real =
          value_of(support::triangles_of(found.change.applied_to(terrain.delaunay.mesh)));
      ASSERT_NEAR(found.value.result, real, slack) << what;
      ASSERT_LE(sign * found.value.bound, sign * found.value.result) << what;
      ASSERT_LE(sign * found.value.result, sign * found.value.delaunay) << what;
      ASSERT_LE(sign * found.value.bound, sign * best + slack) << what;
      if (found.value.optimal) {
        ASSERT_NEAR(found.value.result, best, slack) << what;
      }
      if (k <= 1 || !is_of_edges(objective)) {
        ASSERT_TRUE(found.value.optimal) << what;
      }
    }
  }
};

TEST_F(NewMeasures, are_the_best_of_all_triangulations) {
  const OwnTriangleMeasure ratio{"radius-ratio", radius_ratio};
  const OwnEdgeMeasure sided{"one-sided", one_sided, true};
  for (const auto& family : families::all()) {
    if (family.name != "lattice_subset" && family.name != "random_square" &&
        family.name != "ring" && family.name != "outline" && family.name != "star")
      continue;
    const support::Points points = support::to_point_set(family.make(8, 5)).xy;
    const Terrain terrain(points);
    const oracle::Instance instance(support::to_oracle(terrain.graph.xy));
    const oracle::Catalogue catalogue(instance);
    const auto corner = [&](int v) {
      return Corner{terrain.graph.xy[v].x, terrain.graph.xy[v].y, terrain.z()[v]};
    };
    for (const Direction d : kDirections)
      for (const Aggregate a : kAggregates) {
        compare(terrain, catalogue, {d, a, ratio}, [&](const oracle::Triangles& triangles) {
          std::vector<double> values;
          for (const auto& [p, q, r] : triangles)
            values.push_back(radius_ratio(corner(p), corner(q), corner(r)));
          return combined(a, values);
        });
        compare(terrain, catalogue, {d, a, sided}, [&](const oracle::Triangles& triangles) {
          std::map<std::pair<int, int>, int> apex;
          for (const auto& [p, q, r] : triangles)
            apex[{p, q}] = r, apex[{q, r}] = p, apex[{r, p}] = q;
          std::vector<double> values;
          for (const auto& [edge, left] : apex) {
            const auto& [p, q] = edge;
            if (const auto right = apex.find({q, p}); p < q && right != apex.end())
              values.push_back(
                  one_sided(corner(p), corner(q), corner(left), corner(right->second)));
          }
          return combined(a, values);
        });
      }
  }
}

TEST(OwnMeasures, must_be_finite_and_not_negative) {
  const Terrain terrain(support::lattice(5, 5));
  for (const double value : {-1.0, std::numeric_limits<double>::infinity(), std::nan("")}) {
    const OwnTriangleMeasure triangle{"odd", [&](auto&&...) { return value; }};
    const OwnEdgeMeasure edge{"odd", [&](auto&&...) { return value; }};
    const OwnEdgeMeasure edges = asked_for_many(edge);
    for (const Objective& objective : {Objective(Direction::minimize, Aggregate::sum, triangle),
                                       Objective(Direction::minimize, Aggregate::sum, edge),
                                       Objective(Direction::minimize, Aggregate::sum, edges)})
      for (const Index k : {0u, 1u, 3u}) {
        try {
          optimize(terrain.graph, terrain.z(), objective, {.order = k});
          ADD_FAILURE() << value;
        } catch (const ParameterError& error) {
          EXPECT_NE(std::string(error.what()).find("min-sum-odd"), std::string::npos);
        }
      }
  }
}

TEST(OwnMeasures, that_need_heights_say_so) {
  const Terrain terrain(support::lattice(4, 4));
  for (const bool needs_heights : {false, true}) {
    const OwnTriangleMeasure triangle{"own", [](auto&& a, auto&&...) { return a.z; },
                                      needs_heights};
    const Objective objective(Direction::minimize, Aggregate::sum, triangle);
    EXPECT_EQ(hodt::needs_heights(objective), needs_heights);
    if (needs_heights) {
      EXPECT_THROW(optimize(terrain.graph, {}, objective), ParameterError);
    } else {
      EXPECT_EQ(optimize(terrain.graph, {}, objective).value.result, 0);
    }
  }
}

}  // namespace
}  // namespace hodt
