#include "hodt/hydrology/raster_flow.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <queue>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "hodt/base/error.h"

namespace hodt {

namespace {

/// The cells that have heights, and which of them are neighbours.
class Cells {
 public:
  explicit Cells(const HeightRaster& raster) : r_(raster) {}

  Index size() const { return static_cast<Index>(r_.z.size()); }
  bool has(Index cell) const { return !std::isnan(r_.z[cell]); }

  /// Calls f(neighbour, whether it is so by a corner alone) for the up to eight of them.
  template <class F>
  void for_each_neighbour(Index cell, const F& f) const {
    const auto row = std::int64_t(cell / r_.columns), column = std::int64_t(cell % r_.columns);
    for (std::int64_t i = row - 1; i <= row + 1; ++i)
      for (std::int64_t j = column - 1; j <= column + 1; ++j) {
        if ((i == row && j == column) || i < 0 || j < 0 || i >= std::int64_t(r_.rows) ||
            j >= std::int64_t(r_.columns))
          continue;
        const auto other = static_cast<Index>(i * std::int64_t(r_.columns) + j);
        if (has(other)) f(other, Step{i != row, j != column});
      }
  }
  /// Whether water leaves here.
  bool is_outlet(Index cell) const {
    int neighbours = 0;
    for_each_neighbour(cell, [&](Index, auto) { ++neighbours; });
    return neighbours < 8;
  }

  struct Step {
    bool is_across_rows, is_across_columns;
  };
  double length(Step step) const {
    return std::hypot(step.is_across_columns ? r_.width : 0, step.is_across_rows ? r_.height : 0);
  }

 private:
  const HeightRaster& r_;
};

/// Fills from the outlets inwards, the lowest cell first. Returns the cells in this order, by which
/// what is filled never falls; what each was filled from is `downstream` then, kNone for outlets.
std::vector<Index> fill(const Cells& cells, RasterFlow& flow) {
  using Entry = std::tuple<double, Index, Index>;  // level, number of the entry, cell
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> next;
  Buffer<bool> is_reached(cells.size(), false);
  Index entries = 0;
  const auto reach = [&](Index cell, Index from) {
    is_reached[cell] = true;
    flow.downstream[cell] = from;
    if (from != kNone) flow.filled[cell] = std::max(flow.filled[cell], flow.filled[from]);
    next.emplace(flow.filled[cell], entries++, cell);
  };
  for (Index cell = 0; cell < cells.size(); ++cell)
    if (cells.has(cell) && cells.is_outlet(cell)) reach(cell, kNone);
  std::vector<Index> order;
  while (!next.empty()) {
    const Index cell = std::get<2>(next.top());
    next.pop();
    order.push_back(cell);
    cells.for_each_neighbour(cell, [&](Index other, auto) {
      if (!is_reached[other]) reach(other, cell);
    });
  }
  return order;
}

/// Down the steepest descent, where there is one.
void go_down(const Cells& cells, Index cell, RasterFlow& flow) {
  double steepest = 0;
  cells.for_each_neighbour(cell, [&](Index other, Cells::Step step) {
    const double descent = (flow.filled[cell] - flow.filled[other]) / cells.length(step);
    if (descent <= steepest) return;
    steepest = descent;
    flow.downstream[cell] = other;
  });
}

bool is_stream(const RasterFlow& flow, const Cells& cells, Index cell, Index least) {
  return cells.has(cell) && flow.upstream[cell] > least;
}

/// Of the streams of one, how many cells there are, and how many of them are beside those of the
/// other.
std::pair<std::size_t, std::size_t> count_near(const Cells& cells, const RasterFlow& one,
                                               const RasterFlow& other, Index least) {
  std::size_t all = 0, near = 0;
  for (Index cell = 0; cell < cells.size(); ++cell) {
    if (!is_stream(one, cells, cell, least)) continue;
    ++all;
    bool is_near = is_stream(other, cells, cell, least);
    cells.for_each_neighbour(
        cell, [&](Index beside, auto) { is_near |= is_stream(other, cells, beside, least); });
    near += std::size_t{is_near};
  }
  return {all, near};
}

/// In degrees, or NaN.
double slope_at(const HeightRaster& r, std::size_t row, std::size_t column) {
  const std::size_t cell = row * r.columns + column;
  const double east = (r.z[cell + 1] - r.z[cell - 1]) / (2 * r.width);
  const double south = (r.z[cell + r.columns] - r.z[cell - r.columns]) / (2 * r.height);
  return std::atan(std::hypot(east, south)) * 180 / std::numbers::pi;
}

}  // namespace

RasterFlow raster_flow(const HeightRaster& raster) {
  if (raster.z.size() >= kNone)
    throw ParameterError(
        fmt::format("a raster of {} cells is too large to follow water on it; {} can be numbered",
                    raster.z.size(), kNone));
  const Cells cells(raster);
  RasterFlow flow{raster.z, Buffer<Index>(cells.size(), kNone), Buffer<Index>(cells.size(), 0)};
  const std::vector<Index> order = fill(cells, flow);
  for (const Index cell : order) go_down(cells, cell, flow);
  // What lies lower was filled earlier, and so was what level ground was filled from.
  for (auto cell = order.rbegin(); cell != order.rend(); ++cell) {
    const Index passed = ++flow.upstream[*cell];
    if (flow.downstream[*cell] != kNone) flow.upstream[flow.downstream[*cell]] += passed;
  }
  return flow;
}

FillTotals fill_totals(const HeightRaster& raster, const RasterFlow& flow) {
  FillTotals totals;
  for (std::size_t cell = 0; cell < raster.z.size(); ++cell) {
    if (std::isnan(raster.z[cell])) continue;
    const double depth = flow.filled[cell] - raster.z[cell];
    totals.volume += depth * raster.width * raster.height;
    totals.depth = std::max(totals.depth, depth);
  }
  return totals;
}

std::optional<double> stream_agreement(const HeightRaster& raster, const RasterFlow& found,
                                       const RasterFlow& truth, Index least) {
  const Cells cells(raster);
  const auto [of_found, right] = count_near(cells, found, truth, least);
  const auto [of_truth, known] = count_near(cells, truth, found, least);
  if (of_found + of_truth == 0) return std::nullopt;
  if (right == 0 || known == 0) return 0;
  const double precision = double(right) / double(of_found);
  const double recall = double(known) / double(of_truth);
  return 2 * precision * recall / (precision + recall);
}

std::optional<double> slope_error(const HeightRaster& found, const HeightRaster& truth) {
  double squares = 0;
  std::size_t count = 0;
  for (std::size_t row = 1; row + 1 < found.rows; ++row)
    for (std::size_t column = 1; column + 1 < found.columns; ++column) {
      const double error = slope_at(found, row, column) - slope_at(truth, row, column);
      if (std::isnan(error)) continue;
      squares += error * error;
      ++count;
    }
  if (count == 0) return std::nullopt;
  return std::sqrt(squares / double(count));
}

}  // namespace hodt
