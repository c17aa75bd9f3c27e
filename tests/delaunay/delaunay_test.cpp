#include "hodt/delaunay/delaunay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "../support/connectivity_problem.h"
#include "../support/convert.h"
#include "../support/shapes.h"
#include "../support/triangulation_problems.h"
#include <gtest/gtest.h>

#include "hodt/base/error.h"
#include "hodt/base/parallel.h"
#include "hodt/geometry/predicates.h"

namespace hodt {
namespace {

using support::rows_of;
using support::to_point_set;

/// All that the points alone can prove about a Delaunay triangulation.
std::string problem(const Delaunay& d) {
  if (auto p = connectivity_problem(d.mesh, Surface::disk); !p.empty()) return p;
  if (auto p = embedding_problem(d.vertices.xy, d.mesh); !p.empty()) return p;
  return delaunay_problem(d.vertices.xy, d.mesh);
}

void expect_oracle_agrees(const families::Points& points, const std::string& name) {
  const oracle::Instance instance(points);
  const PointSet set = to_point_set(points);
  const Delaunay d = delaunay(set);
  ASSERT_EQ(d.vertices.size(), points.size()) << name;
  ASSERT_EQ(problem(d), "") << name << ' ' << support::to_source(set.xy);
  ASSERT_EQ(rows_of(d), instance.delaunay()) << name << ' ' << support::to_source(set.xy);
}

// ---- Against the oracle; tests/exhaustive has the families through the pipeline. ----

class Families : public testing::TestWithParam<families::Family> {};

TEST_P(Families, equal_the_oracle) {
  const bool slow = GetParam().name == "wide_range";  // fractions of 2000 bits
  for (const int n : {4, 5, 7, 11, 17, 26, 33})
    for (int seed = 100; seed < 104; ++seed)
      expect_oracle_agrees(GetParam().make(slow ? std::min(n, 12) : n, seed), GetParam().name);
}

INSTANTIATE_TEST_SUITE_P(All, Families, testing::ValuesIn(families::all()),
                         [](const auto& each) { return each.param.name; });

TEST(DelaunayOracle, larger_degenerate_sets) {
  expect_oracle_agrees(families::lattice(7, 7), "lattice");
  expect_oracle_agrees(families::lattice(2, 25), "strip");
  expect_oracle_agrees(families::lattice(25, 2), "strip");
  expect_oracle_agrees(families::ring(64, 1), "a whole ring");
  expect_oracle_agrees(families::ring(65, 1, 32045, true), "a whole ring with its centre");
  expect_oracle_agrees(families::fan(60, 2), "fan");
  expect_oracle_agrees(families::collinear_on_hull(60, 3), "collinear_on_hull");
  expect_oracle_agrees(families::subnormal_lattice(49, 4), "subnormal_lattice");
  expect_oracle_agrees(families::tiny_gaps(40, 5), "tiny_gaps");
}

/// Every subset of three, four and five points of a 3 × 3 lattice: all the ways to be tiny.
TEST(DelaunayOracle, all_small_subsets_of_a_lattice) {
  const families::Points lattice = families::lattice(3, 3);
  int triangulated = 0, on_a_line = 0;
  for (unsigned set = 0; set < 1u << 9; ++set) {
    families::Points points;
    for (int i = 0; i < 9; ++i)
      if (set >> i & 1) points.push_back(lattice[i]);
    if (points.size() < 3) continue;
    if (oracle::Instance(points).all_collinear()) {
      EXPECT_THROW(delaunay(to_point_set(points)), InputError);
      ++on_a_line;
      continue;
    }
    expect_oracle_agrees(points, "subset");
    ++triangulated;
  }
  EXPECT_EQ(on_a_line, 8);
  EXPECT_EQ(triangulated, 512 - 1 - 9 - 36 - 8);
}

/// Every subset of a 4 × 4 lattice: too many for the oracle, so by what proves itself.
TEST(DelaunayExhaustive, all_subsets_of_a_lattice) {
  int triangulated = 0;
  for (unsigned set = 0; set < 1u << 16; ++set) {
    PointSet points;
    for (unsigned i = 0; i < 16; ++i)
      if (set >> i & 1) points.xy.push_back({double(i % 4), double(i / 4)});
    const auto is_off_the_line = [&](std::size_t i) {
      return orient(points.xy[0], points.xy[1], points.xy[i]) != 0;
    };
    bool on_a_line = true;
    for (std::size_t i = 2; i < points.size(); ++i) on_a_line = on_a_line && !is_off_the_line(i);
    if (on_a_line) continue;
    ASSERT_EQ(problem(delaunay(points)), "") << support::to_source(points.xy);
    ++triangulated;
  }
  // All but the empty one, 16 single points, 120 pairs, and 44 + 10 lines of three and four.
  EXPECT_EQ(triangulated, 65536 - 1 - 16 - 120 - 54);
}

/// The same shapes far out, tiny, and mirrored: cuts and ties in every direction.
TEST(DelaunayOracle, moved_and_turned_lattices) {
  for (int seed = 0; seed < 20; ++seed) {
    for (const auto& [xx, xy, yx, yy] :
         std::vector<std::array<double, 4>>{{1, 0, 0, 1},
                                            {0, -1, 1, 0},
                                            {-1, 0, 0, -1},
                                            {1, 1, -1, 1},
                                            {3, 1, -1, 3},
                                            {0x1p-30, 0, 0, 0x1p+30},
                                            {1e150, 0, 0, 1e150},
                                            {1e-170, 0, 0, 1e-170}}) {
      families::Points points = families::lattice_subset(16, seed, 5);
      for (auto& [x, y] : points) {
        const double px = x, py = y;
        x = xx * px + xy * py;
        y = yx * px + yy * py;
      }
      expect_oracle_agrees(points, "turned lattice");
    }
  }
}

// ---- Lines ----

TEST(DelaunayLines, runs_on_the_hull_are_kept_whole) {
  // A 50 × 50 square with points only on its sides, and one inside.
  PointSet points;
  for (int i = 0; i < 50; ++i) {
    points.xy.push_back({double(i), 0});
    points.xy.push_back({50, double(i)});
    points.xy.push_back({50.0 - i, 50});
    points.xy.push_back({0, 50.0 - i});
  }
  points.xy.push_back({13, 29});
  const Delaunay d = delaunay(points);
  EXPECT_EQ(problem(d), "");
  EXPECT_EQ(std::count(d.mesh.twins().begin(), d.mesh.twins().end(), kNone), 200);
  EXPECT_EQ(d.mesh.triangle_count(), 200u);
}

TEST(DelaunayLines, a_line_and_one_point) {
  for (const Point direction : {Point{1, 0}, Point{0, 1}, Point{1, 1}, Point{-3, 1}}) {
    for (const double side : {1.0, -1.0}) {
      PointSet points;
      for (int i = 0; i < 2000; ++i) points.xy.push_back({i * direction.x, i * direction.y});
      points.xy.push_back(
          {5 * direction.x - side * direction.y, 5 * direction.y + side * direction.x});
      const Delaunay d = delaunay({support::shuffled(points.xy, 6), {}});
      EXPECT_EQ(problem(d), "");
      EXPECT_EQ(d.mesh.triangle_count(), 1999u);
    }
  }
}

TEST(DelaunayLines, two_parallel_lines) {
  for (const bool upright : {false, true}) {
    PointSet points;
    for (int i = 0; i < 1000; ++i)
      for (const double y : {0.0, 1.0})
        points.xy.push_back(upright ? Point{y, double(i)} : Point{double(i), y});
    const Delaunay d = delaunay(points);
    EXPECT_EQ(problem(d), "");
    EXPECT_EQ(d.mesh.triangle_count(), 1998u);
  }
}

// ---- What the result must not depend on ----

std::vector<support::Shape> shapes() {
  using namespace support;
  return {
      {"uniform", [] { return uniform(30000, 1); }},
      {"clustered", [] { return clustered(30000, 2); }},
      {"lattice", [] { return lattice(170, 170); }},
      {"utm_lattice", [] { return utm_lattice(170, 170); }},
      {"noisy_lattice", [] { return noisy_lattice(170, 170, 1e-10, 3); }},
      {"lattice_of_ulps", [] { return lattice_of_ulps(170, 170); }},
      {"cocircular_rings", [] { return cocircular_rings(60); }},
  };
}

class Shapes : public testing::TestWithParam<support::Shape> {};

TEST_P(Shapes, are_delaunay) {
  EXPECT_EQ(problem(delaunay({GetParam().make(), {}})), "");
}

TEST_P(Shapes, input_order_does_not_matter) {
  const support::Points points = GetParam().make();
  const Delaunay first = delaunay({points, {}});
  for (int seed = 0; seed < 2; ++seed) {
    const support::Points moved = support::shuffled(points, seed);
    const Delaunay other = delaunay({moved, {}});
    ASSERT_TRUE(std::ranges::equal(first.vertices.xy, other.vertices.xy));
    ASSERT_TRUE(support::same_arrays(first.mesh, other.mesh));
    for (Index v = 0; v < other.vertices.size(); ++v)
      ASSERT_EQ(moved[other.vertices.row[v]], other.vertices.xy[v]);
  }
}

TEST_P(Shapes, threads_do_not_matter) {
  const PointSet points{GetParam().make(), {}};
  const auto with_threads = [&](std::size_t threads) {
    const ThreadLimit limit(threads);
    return delaunay(points);
  };
  const Delaunay one = with_threads(1);
  for (const std::size_t threads : {2, 3}) {
    const Delaunay other = with_threads(threads);
    EXPECT_TRUE(support::same_arrays(one.mesh, other.mesh));
    EXPECT_TRUE(std::ranges::equal(one.vertices.row, other.vertices.row));
  }
}

INSTANTIATE_TEST_SUITE_P(Large, Shapes, testing::ValuesIn(shapes()),
                         [](const auto& each) { return each.param.name; });

TEST(DelaunayLarge, a_million_points) {
  const Delaunay d = delaunay({support::uniform(1000000, 7), {}});
  EXPECT_EQ(d.vertices.size(), 1000000u);
  EXPECT_EQ(problem(d), "");
}

// ---- Duplicates ----

TEST(DelaunayDuplicates, the_lowest_stays) {
  PointSet points;
  points.xy = {{1, 1}, {0, 0}, {1, 1}, {4, 0}, {1, 1}, {0, 3}, {0, 0}, {1, 1}};
  points.z = {5, 2, 3, 1, 3, 7, -1, 9};
  const Delaunay d = delaunay(points);
  ASSERT_EQ(d.vertices.size(), 4u);
  std::vector<Index> rows(d.vertices.row.begin(), d.vertices.row.end());
  std::sort(rows.begin(), rows.end());
  // Of rows 0, 2, 4 and 7 the lowest, of these the first; of rows 1 and 6 the lowest.
  EXPECT_EQ(rows, (std::vector<Index>{2, 3, 5, 6}));
  for (Index v = 0; v < d.vertices.size(); ++v) {
    EXPECT_EQ(d.vertices.z[v], points.z[d.vertices.row[v]]);
    EXPECT_EQ(d.vertices.xy[v], points.xy[d.vertices.row[v]]);
  }
  const auto vertex_of = vertices_of_rows(points, d.vertices);
  ASSERT_EQ(vertex_of.size(), points.size());
  for (std::size_t row = 0; row < points.size(); ++row)
    EXPECT_EQ(d.vertices.xy[vertex_of[row]], points.xy[row]);
}

TEST(DelaunayDuplicates, without_heights_the_first_stays) {
  const Delaunay d = delaunay(PointSet{{{0, 0}, {1, 0}, {0, 0}, {0, 1}, {1, 0}}, {}});
  std::vector<Index> rows(d.vertices.row.begin(), d.vertices.row.end());
  std::sort(rows.begin(), rows.end());
  EXPECT_EQ(rows, (std::vector<Index>{0, 1, 3}));
  EXPECT_TRUE(d.vertices.z.empty());
}

TEST(DelaunayDuplicates, minus_zero_is_zero) {
  const Delaunay d = delaunay(PointSet{{{0.0, 0.0}, {-0.0, 0.0}, {1, 0}, {0, 1}, {0.0, -0.0}}, {}});
  EXPECT_EQ(d.vertices.size(), 3u);
}

TEST(DelaunayDuplicates, many_change_nothing_but_rows) {
  for (const support::Points& distinct :
       {support::uniform(3000, 8), support::lattice(50, 50), support::lattice_of_ulps(50, 50)}) {
    const Delaunay once = delaunay({distinct, {}});
    PointSet points{distinct, {}};
    families::Random random(3);
    for (int i = 0; i < 5000; ++i) points.xy.push_back(distinct[random.bits() % distinct.size()]);
    for (int i = 0; i < 300; ++i) points.xy.push_back(distinct[0]);  // one heap
    points.xy = support::shuffled(points.xy, 4);
    const Delaunay often = delaunay(points);
    ASSERT_TRUE(std::ranges::equal(once.vertices.xy, often.vertices.xy));
    ASSERT_TRUE(support::same_arrays(once.mesh, often.mesh));
    const auto vertex_of = vertices_of_rows(points, often.vertices);
    for (std::size_t row = 0; row < points.size(); ++row)
      ASSERT_EQ(often.vertices.xy[vertex_of[row]], points.xy[row]);
  }
}

TEST(DelaunayDuplicates, input_numbering_leaves_them_out) {
  const PointSet points{{{0, 0}, {2, 0}, {0, 0}, {0, 2}, {2, 2}, {2, 0}, {1, 1}}, {}};
  const Delaunay d = delaunay(points);
  const TriangleMesh mesh = in_input_numbering(d.mesh, d.vertices, points.size());
  EXPECT_EQ(mesh.vertex_count(), points.size());
  EXPECT_EQ(connectivity_problem(mesh, Surface::disk), "");
  EXPECT_EQ(support::triangles_of(mesh), rows_of(d));
  EXPECT_EQ(rows_of(d), (oracle::Triangles{{0, 1, 6}, {0, 6, 3}, {1, 4, 6}, {3, 6, 4}}));
  EXPECT_TRUE(std::ranges::equal(mesh.twins(), d.mesh.twins()));
}

// ---- Errors ----

void expect_error(const PointSet& points, const std::string& words) {
  try {
    delaunay(points);
    ADD_FAILURE() << "no error";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(DelaunayErrors, too_few_points) {
  expect_error({}, "0 distinct points: a triangulation needs at least three");
  expect_error({{{1, 2}}, {}}, "1 distinct point:");
  expect_error({{{1, 2}, {3, 4}}, {}}, "2 distinct points:");
  expect_error({{{1, 2}, {3, 4}, {1, 2}, {3, 4}}, {}}, "2 distinct points:");
  expect_error({std::vector<Point>(1000, Point{5, 5}), {}}, "1 distinct point:");
}

TEST(DelaunayErrors, all_on_one_line) {
  expect_error({{{0, 0}, {1, 1}, {2, 2}}, {}}, "all 3 distinct points lie on one line");
  expect_error({{{0, 0}, {1, 1}, {2, 2}, {1, 1}}, {}}, "all 3 distinct points lie on one line");
  for (const Point direction : {Point{1, 0}, Point{0, 1}, Point{-7, 3}}) {
    PointSet points;
    for (int i = 0; i < 30000; ++i) points.xy.push_back({i * direction.x, i * direction.y});
    expect_error(points, "all 30000 distinct points lie on one line");
    // Moved by the least that there is, it is no line any more.
    points.xy[12345].y = std::nextafter(points.xy[12345].y, 1e9);
    points.xy[12345].x = std::nextafter(points.xy[12345].x, -1e9);
    EXPECT_EQ(problem(delaunay(points)), "");
  }
}

TEST(DelaunayErrors, what_is_not_finite_is_named) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {kInfinity, -kInfinity, kNan}) {
    expect_error({{{0, 0}, {1, 0}, {0, 1}, {bad, 1}}, {}}, "point 3 (counted from 0)");
    expect_error({{{0, 0}, {1, bad}, {0, 1}, {1, 1}}, {}}, "point 1 (counted from 0)");
    expect_error({{{0, 0}, {1, 0}, {0, 1}}, {0, 1, bad}}, "point 2 (counted from 0)");
    PointSet many{support::uniform(200000, 1), {}};
    many.xy[150001].x = bad;
    many.xy[150007].y = bad;
    expect_error(many, "point 150001 (counted from 0)");
  }
}

TEST(DelaunayErrors, any_finite_coordinates_will_do) {
  constexpr double kMax = std::numeric_limits<double>::max();
  constexpr double kMin = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(problem(delaunay(PointSet{{{-kMax, -kMax},
                                       {kMax, -kMax},
                                       {kMax, kMax},
                                       {-kMax, kMax},
                                       {0, 0},
                                       {kMin, 0},
                                       {0, -kMin},
                                       {1, 2}},
                                      {}})),
            "");
  EXPECT_EQ(problem(delaunay(PointSet{{{0, 0}, {kMin, 0}, {0, kMin}}, {}})), "");
}

}  // namespace
}  // namespace hodt
