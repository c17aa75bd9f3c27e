#include "hodt/tin/raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "families.h"
#include "oracle.h"
#include <gtest/gtest.h>

#include "hodt/base/error.h"
#include "hodt/base/parallel.h"
#include "hodt/delaunay/delaunay.h"

namespace hodt {
namespace {

/// The Delaunay triangulation of random points on a lattice, so that centres of cells are on
/// vertices and edges.
Tin random_tin(int count, int side, std::uint64_t seed, double scale = 1, double offset = 0) {
  families::Random random(seed);
  PointSet points;
  for (int i = 0; i < count; ++i) {
    points.xy.push_back(
        {offset + scale * random.integer(0, side), offset + scale * random.integer(0, side)});
    points.z.push_back(random.integer(-50, 50));
  }
  const Delaunay d = delaunay(points);
  Tin tin;
  tin.points.xy.assign(d.vertices.xy.begin(), d.vertices.xy.end());
  tin.points.z.assign(d.vertices.z.begin(), d.vertices.z.end());
  for (Index t = 0; t < d.mesh.triangle_count(); ++t) {
    const auto [a, b, c] = d.mesh.corners(TriangleId(t));
    tin.triangles.push_back({a, b, c});
    if (random.integer(0, 2) == 0) std::swap(tin.triangles[t][0], tin.triangles[t][1]);
  }
  return tin;
}

mpq_class doubled_area(const Point& a, const Point& b, const Point& c) {
  const mpq_class ax = a.x, ay = a.y, bx = b.x, by = b.y, cx = c.x, cy = c.y;
  return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
}

/// The first triangle that contains the place, and the height there, in rational arithmetic.
std::pair<Index, double> by_definition(const Tin& tin, const Point& p) {
  for (Index t = 0; t < tin.triangles.size(); ++t) {
    const auto& [a, b, c] = tin.triangles[t];
    const std::vector<Point>& xy = tin.points.xy;
    const mpq_class whole = doubled_area(xy[a], xy[b], xy[c]);
    const mpq_class at_a = doubled_area(p, xy[b], xy[c]) / whole,
                    at_b = doubled_area(p, xy[c], xy[a]) / whole,
                    at_c = doubled_area(p, xy[a], xy[b]) / whole;
    if (at_a < 0 || at_b < 0 || at_c < 0) continue;
    const std::vector<double>& z = tin.points.z;
    return {t, mpq_class(at_a * z[a] + at_b * z[b] + at_c * z[c]).get_d()};
  }
  return {kNone, std::numeric_limits<double>::quiet_NaN()};
}

struct Raster {
  std::vector<Index> triangles;
  std::vector<double> heights;
};

Raster raster_of(const Tin& tin, const Grid& grid, std::size_t rows_at_once) {
  Raster raster{std::vector<Index>(grid.columns * grid.rows),
                std::vector<double>(grid.columns * grid.rows)};
  const CellTriangles cells(tin, grid);
  for (std::size_t row = 0; row < grid.rows; row += rows_at_once) {
    const std::size_t from = row * grid.columns,
                      count = std::min(rows_at_once, grid.rows - row) * grid.columns;
    cells.fill(row, std::span(raster.triangles).subspan(from, count));
    heights_of_cells(tin, grid, row, std::span(raster.triangles).subspan(from, count),
                     std::span(raster.heights).subspan(from, count));
  }
  return raster;
}

void expect_by_definition(const Tin& tin, const Grid& grid) {
  const Raster raster = raster_of(tin, grid, grid.rows);
  for (std::size_t row = 0; row < grid.rows; ++row)
    for (std::size_t column = 0; column < grid.columns; ++column) {
      const std::size_t cell = row * grid.columns + column;
      const Point centre{grid.x(column), grid.y(row)};
      const auto [triangle, height] = by_definition(tin, centre);
      ASSERT_EQ(raster.triangles[cell], triangle) << row << " " << column;
      if (triangle == kNone) {
        ASSERT_TRUE(std::isnan(raster.heights[cell]));
        continue;
      }
      ASSERT_NEAR(raster.heights[cell], height, 1e-9);
      const auto vertex = std::find(tin.points.xy.begin(), tin.points.xy.end(), centre);
      if (vertex != tin.points.xy.end()) {
        ASSERT_EQ(raster.heights[cell],
                  tin.points.z[static_cast<std::size_t>(vertex - tin.points.xy.begin())]);
      }
    }
}

TEST(Raster, is_what_the_definition_says) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Tin tin = random_tin(60, 20, seed);
    expect_by_definition(tin, grid_over(tin, 1));
    expect_by_definition(tin, grid_over(tin, 0.75));
    // Centres on the lattice of the points; more than the points cover; cells of two sides.
    expect_by_definition(tin, {-3.5, 24.5, 1, 1, 28, 30});
    expect_by_definition(tin, {4.25, 11.5, 0.5, 0.25, 9, 40});
    expect_by_definition(tin, {100, 100, 1, 1, 3, 3});
  }
}

TEST(Raster, of_survey_coordinates_and_needles) {
  const Tin survey = random_tin(80, 30, 4, 0.01, 4500000.37);
  expect_by_definition(survey, grid_over(survey, 0.013));
  const Point& first = survey.points.xy[0];
  expect_by_definition(survey, {first.x - 0.05, first.y + 0.05, 0.01, 0.01, 10, 10});
  Tin needle;
  needle.points = {{{0, 0}, {1000, 1e-9}, {500, 0}, {300, 400}}, {0, 10, 20, 30}};
  needle.triangles = {{0, 2, 1}, {0, 1, 3}};
  expect_by_definition(needle, {-0.5, 400.5, 1, 1, 1010, 402});
}

TEST(Raster, is_the_same_in_pieces_and_on_any_number_of_threads) {
  const Tin tin = random_tin(500, 300, 5);
  const Grid grid = grid_over(tin, 1.5);
  const Raster whole = raster_of(tin, grid, grid.rows);
  const ThreadLimit limit(3);
  for (const std::size_t rows : {1, 7, 32, 50}) {
    const Raster pieces = raster_of(tin, grid, rows);
    EXPECT_EQ(pieces.triangles, whole.triangles);
  }
}

TEST(Raster, borders_are_multiples_of_the_resolution) {
  Tin tin;
  tin.points.xy = {{12, -7}, {31, -7}, {12, 44}};
  const Grid grid = grid_over(tin, 10);
  EXPECT_EQ(grid.west, 10);
  EXPECT_EQ(grid.north, 50);
  EXPECT_EQ(grid.columns, 3u);
  EXPECT_EQ(grid.rows, 6u);
  EXPECT_EQ(grid.x(0), 15);
  EXPECT_EQ(grid.y(5), -5);
  for (const double resolution : {0., -1., 1e-15, 1e-9, 4e-324})
    EXPECT_THROW(grid_over(tin, resolution), ParameterError);
}

std::string refusal_of(const std::vector<Point>& points, double resolution) {
  try {
    grid_over(points, resolution);
  } catch (const ParameterError& error) {
    return error.what();
  }
  return {};
}

// The resolution that is suggested does, and it is the first one of the round numbers that does.
TEST(Grid, suggests_a_resolution_that_does) {
  const std::vector<std::vector<Point>> terrains = {
      {{0, 0}, {1000, 1000}},       {{0, 0}, {1, 1e7}},
      {{-3e6, 5e6}, {-2e6, 5.1e6}}, {{5e6, 5e6}, {5e6 + 1e-6, 5e6 + 1e-6}},
      {{-1e300, 0}, {1e300, 1}},    {{0, 0}, {1e-300, 1e-300}}};
  for (const std::vector<Point>& points : terrains)
    for (double resolution = 1e300; resolution > 0; resolution /= 1e4) {
      const std::string refusal = refusal_of(points, resolution);
      if (refusal.empty()) continue;
      const std::size_t at = refusal.find("choose a larger one, ");
      ASSERT_NE(at, std::string::npos) << refusal;
      const double does = std::stod(refusal.substr(at + 21));
      EXPECT_EQ(refusal_of(points, does), "");
      EXPECT_TRUE(does / 2.5 <= resolution || refusal_of(points, does / 2.5) != "") << refusal;
    }
}

TEST(Grid, has_a_largest_size) {
  EXPECT_NO_THROW(check_size({0, 0, 1, 1, kMostColumns, 2000}));
  EXPECT_NO_THROW(check_size({0, 0, 1, 1, 100000, 100000}));
  EXPECT_THROW(check_size({0, 0, 1, 1, kMostColumns + 1, 1}), ParameterError);
  EXPECT_THROW(check_size({0, 0, 1, 1, 1, kMostColumns + 1}), ParameterError);
  EXPECT_THROW(check_size({0, 0, 1, 1, 100001, 100000}), ParameterError);
}

TEST(Hillshade, faces_the_light) {
  Tin tin;
  // Facets that face south-east, north-west, up, and one that is steep.
  tin.points.xy = {{0, 0}, {1, 0}, {0, 1}};
  tin.triangles = {{0, 1, 2}};
  const auto shade = [&](std::vector<double> z) {
    tin.points.z = std::move(z);
    unsigned char code = 0;
    const Index triangle = 0;
    Hillshade(tin).shades_of_cells({&triangle, 1}, {&code, 1});
    return int(code);
  };
  EXPECT_EQ(shade({0, 0, 0}), 1 + int(std::lround(254 * std::sqrt(0.5))));
  // The slope falls to the north-west at 45 degrees: it faces the light.
  EXPECT_EQ(shade({0, std::sqrt(0.5), -std::sqrt(0.5)}), 255);
  EXPECT_EQ(shade({0, -std::sqrt(0.5), std::sqrt(0.5)}), 1);
  EXPECT_EQ(shade({0, -1e300, 1e300}), 1);
  std::swap(tin.triangles[0][1], tin.triangles[0][2]);
  EXPECT_EQ(shade({0, std::sqrt(0.5), -std::sqrt(0.5)}), 255);
  const Index none = kNone;
  unsigned char code = 9;
  Hillshade(tin).shades_of_cells({&none, 1}, {&code, 1});
  EXPECT_EQ(code, 0);
}

}  // namespace
}  // namespace hodt
