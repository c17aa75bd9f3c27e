// Where water goes on a raster: what it fills, and which streams it makes.
// Tested by tests/hydrology/raster_flow_test.cpp.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "hodt/base/buffer.h"
#include "hodt/base/ids.h"

namespace hodt {

/// Heights of cells, row after row from north to south; NaN where there is none.
struct HeightRaster {
  std::size_t columns = 0, rows = 0;
  double width = 1, height = 1;  ///< of a cell
  std::vector<double> z;
};

/// Cells are numbered as in HeightRaster; of those without a height nothing is known.
struct RasterFlow {
  std::vector<double> filled;  ///< heights once all pits are full: see raster_flow()
  Buffer<Index> downstream;    ///< the cell where its water goes; kNone where it leaves
  Buffer<Index> upstream;      ///< the number of cells whose water passes here, this one included
};

/// Water leaves through the cells at the raster's border and beside cells without a height; eight
/// cells are neighbours of one. A cell is filled to the least level at which its water leaves
/// (Wang and Liu, "An efficient method for identifying and filling surface depressions", 2006).
/// From there it goes to the neighbour of the steepest descent (D8: O'Callaghan and Mark, "The
/// extraction of drainage networks from digital elevation data", 1984), or on level ground to the
/// one it was filled from. Throws ParameterError for more cells than can be numbered.
RasterFlow raster_flow(const HeightRaster& raster);

/// What it takes to fill all pits: volume, and the largest depth.
struct FillTotals {
  double volume = 0, depth = 0;
};
FillTotals fill_totals(const HeightRaster& raster, const RasterFlow& flow);

/// How well streams agree, the cells with more than `least` cells upstream: F1, the harmonic mean
/// of two shares, of the cells found that are within one cell (in rows and in columns) of a true
/// one, and of the true ones that are within one of a found one. Empty if neither has any.
std::optional<double> stream_agreement(const HeightRaster& raster, const RasterFlow& found,
                                       const RasterFlow& truth, Index least = 50);

/// Root mean square of the difference of slopes, in degrees: from a cell's neighbours to the west
/// and east, north and south, where all of them have heights. Empty if there are no such cells.
std::optional<double> slope_error(const HeightRaster& found, const HeightRaster& truth);

}  // namespace hodt
