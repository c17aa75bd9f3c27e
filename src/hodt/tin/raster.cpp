#include "hodt/tin/raster.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/base/parallel.h"
#include "hodt/geometry/predicates.h"
#include "hodt/tin/counter_clockwise.h"
#include "hodt/tin/interpolate.h"
#include "hodt/tin/round_number.h"
#include "hodt/tin/slope.h"

namespace hodt {

namespace {

constexpr std::size_t kStripRows = 32;
constexpr std::size_t kGrain = 1 << 14;

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

/// The numbers of the cells that have their centres in the range, and one more on each side for
/// what is rounded; of `count` cells.
std::pair<std::size_t, std::size_t> cells_in(double low, double high, std::size_t count) {
  const auto clamped = [&](double cell) {
    return static_cast<std::size_t>(std::clamp(cell, 0., static_cast<double>(count)));
  };
  return {clamped(std::ceil(low - 0.5) - 1), clamped(std::floor(high - 0.5) + 2)};
}

std::pair<std::size_t, std::size_t> rows_of(const Tin& tin, const Grid& grid, std::size_t t) {
  Range y;
  for (const Index v : tin.triangles[t]) y.add(tin.points.xy[v].y);
  return cells_in((grid.north - y.high) / grid.height, (grid.north - y.low) / grid.height,
                  grid.rows);
}

bool is_too_large(double columns, double rows) {
  const double most = static_cast<double>(kMostColumns);
  // What is infinite, or no number at all, is too large as well.
  return !(columns <= most && rows <= most && columns * rows <= static_cast<double>(kMostCells));
}

std::string limits() {
  return fmt::format("it may have {} columns, as many rows, and {} cells", kMostColumns,
                     kMostCells);
}

/// Square cells that cover a box, their borders counted from the origin.
struct Cells {
  double west, east, south, north;

  Cells(const Range& x, const Range& y, double width)
      : west(std::floor(x.low / width)),
        east(std::ceil(x.high / width)),
        south(std::floor(y.low / width)),
        north(std::ceil(y.high / width)) {}

  double columns() const { return std::max(east - west, 1.); }
  double rows() const { return std::max(north - south, 1.); }
  bool are_too_many() const { return is_too_large(columns(), rows()); }
  /// Whether the centres of neighbouring cells may not be told apart.
  bool are_too_small() const {
    constexpr double most = 0x1p50;
    const auto is_far = [](double border) { return !(std::fabs(border) < most); };
    return is_far(west) || is_far(east) || is_far(south) || is_far(north);
  }
};

/// One to suggest in place of a resolution that does not do.
double larger_resolution(const Range& x, const Range& y, double resolution) {
  return next_round_number(resolution, [&](double width) {
    const Cells cells(x, y, width);
    return !cells.are_too_many() && !cells.are_too_small();
  });
}

}  // namespace

void check_size(const Grid& grid) {
  if (is_too_large(static_cast<double>(grid.columns), static_cast<double>(grid.rows)))
    throw ParameterError(fmt::format("a raster of {} columns and {} rows is too large: {}",
                                     grid.columns, grid.rows, limits()));
}

Grid grid_over(std::span<const Point> points, double resolution) {
  if (!(resolution > 0) || !std::isfinite(resolution))
    throw ParameterError(
        fmt::format("the resolution must be a positive number, not {}", resolution));
  if (points.empty()) throw InputError("the mesh has no points: there is no raster of it");
  Range x, y;
  for (const Point& p : points) {
    x.add(p.x);
    y.add(p.y);
  }
  const Cells cells(x, y, resolution);
  if (cells.are_too_many())
    throw ParameterError(fmt::format(
        "a resolution of {} makes {} columns and {} rows, which is too large a raster: {}; choose "
        "a larger one, {} does",
        resolution, cells.columns(), cells.rows(), limits(), larger_resolution(x, y, resolution)));
  if (cells.are_too_small())
    throw ParameterError(fmt::format(
        "a resolution of {} is too fine for coordinates as large as these; choose a larger one, "
        "{} does",
        resolution, larger_resolution(x, y, resolution)));
  return {cells.west * resolution,
          cells.north * resolution,
          resolution,
          resolution,
          static_cast<std::size_t>(cells.columns()),
          static_cast<std::size_t>(cells.rows())};
}

CellTriangles::CellTriangles(const Tin& tin, const Grid& grid) : tin_(tin), grid_(grid) {
  const std::size_t strips = (grid.rows + kStripRows - 1) / kStripRows;
  begin_.assign(strips + 1, 0);
  const auto for_each_strip = [&](std::size_t t, const auto& f) {
    const auto [first, last] = rows_of(tin, grid, t);
    for (std::size_t strip = first / kStripRows; strip * kStripRows < last; ++strip) f(strip);
  };
  for (std::size_t t = 0; t < tin.triangles.size(); ++t)
    for_each_strip(t, [&](std::size_t strip) { ++begin_[strip + 1]; });
  for (std::size_t i = 0; i < strips; ++i) begin_[i + 1] += begin_[i];
  triangles_.resize(begin_[strips]);
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t t = 0; t < tin.triangles.size(); ++t)
    for_each_strip(t,
                   [&](std::size_t strip) { triangles_[next[strip]++] = static_cast<Index>(t); });
}

void CellTriangles::fill(std::size_t row, std::span<Index> triangles) const {
  const std::size_t last_row = row + triangles.size() / grid_.columns;
  parallel_for(
      row / kStripRows, (last_row + kStripRows - 1) / kStripRows, 1,
      [&](std::size_t first, std::size_t last) {
        for (std::size_t strip = first; strip < last; ++strip) {
          const std::size_t from = std::max(row, strip * kStripRows);
          const std::size_t to = std::min(last_row, (strip + 1) * kStripRows);
          fill_strip(strip, from, to,
                     triangles.subspan((from - row) * grid_.columns, (to - from) * grid_.columns));
        }
      });
}

void CellTriangles::fill_strip(std::size_t strip, std::size_t first_row, std::size_t last_row,
                               std::span<Index> triangles) const {
  std::fill(triangles.begin(), triangles.end(), kNone);
  for (std::size_t i = begin_[strip]; i < begin_[strip + 1]; ++i) {
    const Index t = triangles_[i];
    const auto [first, last] = rows_of(tin_, grid_, t);
    const auto [a, b, c] = counter_clockwise(tin_.points.xy, tin_.triangles[t]);
    const std::array<Point, 3> corners = {tin_.points.xy[a], tin_.points.xy[b], tin_.points.xy[c]};
    for (std::size_t row = std::max(first, first_row); row < std::min(last, last_row); ++row)
      fill_row(t, corners, row,
               triangles.subspan((row - first_row) * grid_.columns, grid_.columns));
  }
}

/// The centres of a row that a triangle contains follow one another: what is computed of their
/// range is looked at exactly at its ends.
void CellTriangles::fill_row(Index triangle, const std::array<Point, 3>& corners, std::size_t row,
                             std::span<Index> cells) const {
  const double y = grid_.y(row);
  Range x;
  for (int i = 0; i < 3; ++i) {
    const Point &p = corners[i], &q = corners[(i + 1) % 3];
    if (p.y == y) x.add(p.x);
    if ((p.y < y && y < q.y) || (q.y < y && y < p.y))
      x.add(std::lerp(p.x, q.x, (y - p.y) / (q.y - p.y)));
  }
  if (!(x.low <= x.high)) return;
  auto [first, last] = cells_in((x.low - grid_.west) / grid_.width,
                                (x.high - grid_.west) / grid_.width, grid_.columns);
  const auto is_inside = [&](std::size_t column) {
    const Point centre{grid_.x(column), y};
    return orient(corners[0], corners[1], centre) >= 0 &&
           orient(corners[1], corners[2], centre) >= 0 &&
           orient(corners[2], corners[0], centre) >= 0;
  };
  while (first < last && !is_inside(first)) ++first;
  while (first < last && !is_inside(last - 1)) --last;
  for (std::size_t column = first; column < last; ++column)
    if (cells[column] == kNone) cells[column] = triangle;
}

void heights_of_cells(const Tin& tin, const Grid& grid, std::size_t row,
                      std::span<const Index> triangles, std::span<double> heights) {
  parallel_for(0, triangles.size(), kGrain, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      heights[i] = triangles[i] == kNone
                       ? std::numeric_limits<double>::quiet_NaN()
                       : height_in(tin.points, tin.triangles[triangles[i]],
                                   {grid.x(i % grid.columns), grid.y(row + i / grid.columns)});
  });
}

Hillshade::Hillshade(const Tin& tin, double azimuth, double altitude)
    : shade_(tin.triangles.size()) {
  const double degree = std::acos(-1.0) / 180;
  const double light[3] = {std::sin(azimuth * degree) * std::cos(altitude * degree),
                           std::cos(azimuth * degree) * std::cos(altitude * degree),
                           std::sin(altitude * degree)};
  parallel_for(0, tin.triangles.size(), kGrain, [&](std::size_t first, std::size_t last) {
    for (std::size_t t = first; t < last; ++t) {
      const auto [a, b, c] = counter_clockwise(tin.points.xy, tin.triangles[t]);
      const std::vector<Point>& xy = tin.points.xy;
      const std::vector<double>& z = tin.points.z;
      const Normal normal = normal_of(xy[a], xy[b], xy[c], z[a], z[b], z[c]);
      const double east = normal.height * normal.east, north = normal.height * normal.north,
                   up = normal.width * normal.up;
      const double cosine =
          (east * light[0] + north * light[1] + up * light[2]) / std::hypot(east, north, up);
      // A facet that is out of a double's range is as a level one.
      const double share = std::isfinite(cosine) ? std::max(cosine, 0.) : light[2];
      shade_[t] = static_cast<unsigned char>(std::lround(1 + 254 * share));
    }
  });
}

void Hillshade::shades_of_cells(std::span<const Index> triangles,
                                std::span<unsigned char> shades) const {
  parallel_for(0, triangles.size(), kGrain, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      shades[i] = triangles[i] == kNone ? 0 : shade_[triangles[i]];
  });
}

}  // namespace hodt
