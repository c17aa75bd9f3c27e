// How near a surface is to a raster of the land, and whether water takes the same ways on it.
// Tested by tests/app/compare_test.cpp.
#pragma once

#include <optional>

#include "hodt/hydrology/raster_flow.h"
#include "hodt/tin/raster.h"
#include "hodt/tin/tin.h"

namespace hodt::app {

/// Of a surface at the centres of the raster's cells, where both have heights.
struct LandFit {
  FillTotals fill;                         ///< what its pits take, once on the raster
  std::optional<double> slope_error;       ///< see slope_error()
  std::optional<double> stream_agreement;  ///< see stream_agreement()
};

class Land {
 public:
  /// The points are the centres of the grid's cells that have a height, row after row.
  Land(const Grid& grid, const PointSet& points);

  /// Of an embedded mesh with heights.
  LandFit fit_of(const Tin& tin);
  /// Of the land itself, where the last surface has heights.
  const FillTotals& fill() const { return fill_; }

 private:
  void look_at_land_below(const HeightRaster& surface);

  Grid grid_;
  HeightRaster all_;
  HeightRaster below_;  // the land where the last surface has heights, and its water
  RasterFlow flow_;
  FillTotals fill_;
};

}  // namespace hodt::app
