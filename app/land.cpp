#include "app/land.h"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "hodt/base/error.h"

namespace hodt::app {

namespace {

constexpr double kNoHeight = std::numeric_limits<double>::quiet_NaN();

HeightRaster empty_raster(const Grid& grid) {
  return {grid.columns, grid.rows, grid.width, grid.height,
          std::vector<double>(grid.columns * grid.rows, kNoHeight)};
}

/// With a height at the same cells.
bool is_known_alike(const HeightRaster& a, const HeightRaster& b) {
  for (std::size_t cell = 0; cell < a.z.size(); ++cell)
    if (std::isnan(a.z[cell]) != std::isnan(b.z[cell])) return false;
  return true;
}

/// Takes the heights away where the other one has none.
void leave_out(HeightRaster& raster, const HeightRaster& other) {
  for (std::size_t cell = 0; cell < raster.z.size(); ++cell)
    if (std::isnan(other.z[cell])) raster.z[cell] = kNoHeight;
}

HeightRaster raster_of(const Tin& tin, const Grid& grid) {
  HeightRaster raster = empty_raster(grid);
  std::vector<Index> triangles(raster.z.size());
  CellTriangles(tin, grid).fill(0, triangles);
  heights_of_cells(tin, grid, 0, triangles, raster.z);
  return raster;
}

}  // namespace

Land::Land(const Grid& grid, const PointSet& points) : grid_(grid), all_(empty_raster(grid)) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto column = std::size_t(std::lround((points.xy[i].x - grid.west) / grid.width - 0.5));
    const auto row = std::size_t(std::lround((grid.north - points.xy[i].y) / grid.height - 0.5));
    if (column >= grid.columns || row >= grid.rows)
      throw InputError("its cells are too small for the digits of its coordinates");
    all_.z[row * grid.columns + column] = points.z[i];
  }
}

LandFit Land::fit_of(const Tin& tin) {
  HeightRaster surface = raster_of(tin, grid_);
  leave_out(surface, all_);
  if (below_.z.empty() || !is_known_alike(surface, below_)) look_at_land_below(surface);
  const RasterFlow flow = raster_flow(surface);
  return {fill_totals(surface, flow), slope_error(surface, below_),
          stream_agreement(surface, flow, flow_)};
}

void Land::look_at_land_below(const HeightRaster& surface) {
  below_ = all_;
  leave_out(below_, surface);
  flow_ = raster_flow(below_);
  fill_ = fill_totals(below_, flow_);
}

}  // namespace hodt::app
