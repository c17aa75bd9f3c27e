// Filling, streams and slopes of rasters, against what they are by definition.
#include "hodt/hydrology/raster_flow.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "hodt/base/error.h"

namespace hodt {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

HeightRaster raster(std::size_t columns, std::vector<double> z) {
  return {columns, z.size() / columns, 1, 1, std::move(z)};
}

/// Neighbours by their distance, from all pairs of cells.
std::vector<std::size_t> neighbours(const HeightRaster& r, std::size_t cell) {
  std::vector<std::size_t> found;
  for (std::size_t other = 0; other < r.z.size(); ++other) {
    const auto apart = [](std::size_t a, std::size_t b) { return a > b ? a - b : b - a; };
    if (other != cell && !std::isnan(r.z[other]) &&
        apart(cell / r.columns, other / r.columns) <= 1 &&
        apart(cell % r.columns, other % r.columns) <= 1)
      found.push_back(other);
  }
  return found;
}

/// The least level at which water leaves: the least, over all ways out, of the largest height. By
/// taking neighbours' levels over until nothing changes.
std::vector<double> filled(const HeightRaster& r) {
  std::vector<double> level(r.z.size(), std::numeric_limits<double>::infinity());
  for (bool changes = true; changes;) {
    changes = false;
    for (std::size_t cell = 0; cell < r.z.size(); ++cell) {
      if (std::isnan(r.z[cell])) continue;
      const auto beside = neighbours(r, cell);
      double least = beside.size() < 8 ? r.z[cell] : std::numeric_limits<double>::infinity();
      for (const std::size_t other : beside)
        least = std::min(least, std::max(r.z[cell], level[other]));
      if (least >= level[cell]) continue;
      level[cell] = least;
      changes = true;
    }
  }
  return level;
}

double descent(const HeightRaster& r, const std::vector<double>& level, std::size_t from,
               std::size_t to) {
  const double rows = double(from / r.columns) - double(to / r.columns);
  const double columns = double(from % r.columns) - double(to % r.columns);
  return (level[from] - level[to]) / std::hypot(rows * r.height, columns * r.width);
}

void expect_flow(const HeightRaster& r) {
  const RasterFlow flow = raster_flow(r);
  const std::vector<double> level = filled(r);
  std::vector<Index> passed(r.z.size(), 0);
  double volume = 0;
  for (std::size_t cell = 0; cell < r.z.size(); ++cell) {
    if (std::isnan(r.z[cell])) continue;
    ASSERT_EQ(flow.filled[cell], level[cell]) << cell;
    volume += (level[cell] - r.z[cell]) * r.width * r.height;
    const auto beside = neighbours(r, cell);
    double steepest = 0;
    for (const std::size_t other : beside)
      steepest = std::max(steepest, descent(r, level, cell, other));
    const Index next = flow.downstream[cell];
    if (next == kNone) {
      EXPECT_EQ(steepest, 0) << cell;
      EXPECT_LT(beside.size(), 8u) << cell;
    } else {
      EXPECT_EQ(descent(r, level, cell, next), steepest) << cell;
      EXPECT_NE(std::find(beside.begin(), beside.end(), next), beside.end()) << cell;
    }
    std::size_t steps = 0;
    for (Index at = Index(cell); at != kNone; at = flow.downstream[at]) {
      ++passed[at];
      ASSERT_LE(++steps, r.z.size()) << "water goes in a circle";
    }
  }
  for (std::size_t cell = 0; cell < r.z.size(); ++cell)
    EXPECT_EQ(flow.upstream[cell], passed[cell]) << cell;  // 0 where there is no height
  EXPECT_NEAR(fill_totals(r, flow).volume, volume, 1e-9 * (1 + volume));
}

TEST(RasterFlow, is_what_it_is_by_definition) {
  std::mt19937 random(5);
  for (int round = 0; round < 150; ++round) {
    HeightRaster r = raster(3 + random() % 7, {});
    r.rows = 1 + random() % 9;
    r.width = 1 + double(random() % 3);
    r.height = 1 + double(random() % 3);
    const unsigned levels = std::vector<unsigned>{2, 4, 1000}[random() % 3];  // few make flats
    for (std::size_t i = 0; i < r.columns * r.rows; ++i)
      r.z.push_back(round % 3 == 0 && random() % 8 == 0 ? kNaN : double(random() % levels));
    expect_flow(r);
  }
}

TEST(RasterFlow, fills_a_pit_to_its_lowest_outlet) {
  const HeightRaster r = raster(5, {9, 9, 9, 9, 9,  //
                                    9, 1, 2, 9, 9,  //
                                    9, 9, 9, 4, 3,  //
                                    9, 9, 9, 9, 9});
  const RasterFlow flow = raster_flow(r);
  EXPECT_EQ(flow.filled[6], 4);
  EXPECT_EQ(flow.filled[7], 4);
  const FillTotals totals = fill_totals(r, flow);
  EXPECT_EQ(totals.volume, 5);
  EXPECT_EQ(totals.depth, 3);
  EXPECT_EQ(flow.downstream[13], 14u);
  EXPECT_EQ(flow.downstream[14], kNone);
}

TEST(RasterFlow, water_leaves_beside_cells_without_a_height) {
  const HeightRaster r = raster(5, {9, 9, 9,    9, 9,  //
                                    9, 1, 1,    1, 9,  //
                                    9, 1, kNaN, 1, 9,  //
                                    9, 1, 1,    1, 9,  //
                                    9, 9, 9,    9, 9});
  EXPECT_EQ(fill_totals(r, raster_flow(r)).volume, 0);
  expect_flow(r);
}

TEST(RasterFlow, of_nothing_and_of_one_row) {
  expect_flow(raster(1, {}));
  expect_flow(raster(4, {3, 1, 2, 5}));
  expect_flow(raster(1, {kNaN}));
}

/// A valley in the middle of the columns, which drains to the south.
HeightRaster valley(std::size_t columns, std::size_t rows, std::size_t middle) {
  HeightRaster r = raster(columns, {});
  r.rows = rows;
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < columns; ++column)
      r.z.push_back(10 * std::fabs(double(column) - double(middle)) - double(row));
  return r;
}

TEST(RasterFlow, streams_agree_within_a_cell) {
  const HeightRaster truth = valley(21, 30, 10);
  const RasterFlow flow = raster_flow(truth);
  const auto agreement = [&](std::size_t middle) {
    return stream_agreement(truth, raster_flow(valley(21, 30, middle)), flow);
  };
  EXPECT_EQ(agreement(10), 1);
  EXPECT_EQ(agreement(11), 1);
  EXPECT_EQ(agreement(13), 0);
  EXPECT_EQ(stream_agreement(truth, flow, flow, 1000), std::nullopt);
  // Half of it: 0.5 of what is found is right, and all that is true is known.
  HeightRaster few = raster(4, {5, 5, 5, 5});
  RasterFlow one{few.z, Buffer<Index>(4, kNone), Buffer<Index>(4, 60)};
  RasterFlow other{few.z, Buffer<Index>(4, kNone), Buffer<Index>(4, 0)};
  other.upstream[0] = 60;
  EXPECT_DOUBLE_EQ(*stream_agreement(few, one, other), 2 * 0.5 * 1 / 1.5);
}

TEST(RasterFlow, slopes_differ_by_degrees) {
  HeightRaster level = raster(3, std::vector<double>(9, 0));
  HeightRaster steep = raster(3, {0, 2, 4, 0, 2, 4, 0, 2, 4});
  steep.width = level.width = 2;
  EXPECT_NEAR(*slope_error(steep, level), 45, 1e-12);
  EXPECT_EQ(slope_error(steep, steep), 0);
  steep.z[3] = kNaN;
  EXPECT_EQ(slope_error(steep, level), std::nullopt);
}

}  // namespace
}  // namespace hodt
