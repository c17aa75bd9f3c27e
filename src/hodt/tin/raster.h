// The cells of a raster, and the triangles of a TIN at their centres.
// Tested by tests/tin/raster_test.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "hodt/geometry/point.h"
#include "hodt/tin/tin.h"

namespace hodt {

/// Cells along the axes: columns go east from `west`, rows go south from `north`.
struct Grid {
  double west = 0, north = 0;
  double width = 0, height = 0;  ///< of a cell, positive
  std::size_t columns = 0, rows = 0;

  double x(std::size_t column) const { return west + (double(column) + 0.5) * width; }
  double y(std::size_t row) const { return north - (double(row) + 0.5) * height; }
};

/// How many cells a raster may have, and how many columns and rows: far more than anybody looks at,
/// and no more than a disk and a day hold.
constexpr std::size_t kMostCells = 10'000'000'000, kMostColumns = std::size_t{1} << 22;

/// Throws ParameterError if there are more.
void check_size(const Grid& grid);

/// Square cells that cover all points, their borders at multiples of the resolution, so that grids
/// of neighbouring areas fit together. Throws ParameterError if the resolution is not a positive
/// number, too fine for the coordinates' digits, or makes more cells than a raster may have; it
/// says which one does not.
Grid grid_over(std::span<const Point> points, double resolution);
inline Grid grid_over(const Tin& tin, double resolution) {
  return grid_over(tin.points.xy, resolution);
}

/// Which triangles the centres of cells are in, of an embedded mesh (see embedding.h) whose
/// triangles may be given in either direction. Decided exactly. Where several have the centre on
/// their border it is the first of the list.
class CellTriangles {
 public:
  /// Keeps references to both.
  CellTriangles(const Tin& tin, const Grid& grid);

  /// Fills in the triangles of whole rows, from `row` on; kNone where there is none. By all cores.
  void fill(std::size_t row, std::span<Index> triangles) const;

 private:
  void fill_strip(std::size_t strip, std::size_t first_row, std::size_t last_row,
                  std::span<Index> triangles) const;
  void fill_row(Index triangle, const std::array<Point, 3>& corners, std::size_t row,
                std::span<Index> cells) const;

  const Tin& tin_;
  const Grid& grid_;
  // The triangles that reach into each strip of rows, in their order.
  std::vector<std::size_t> begin_;
  std::vector<Index> triangles_;
};

/// Heights of the surface at the centres of cells, from the triangles there; NaN where there is
/// none. `row` is the row of the first.
void heights_of_cells(const Tin& tin, const Grid& grid, std::size_t row,
                      std::span<const Index> triangles, std::span<double> heights);

/// Light from one direction on the facets of the surface, as rasters of shades are coded: 1 (turned
/// away) to 255 (facing it), 0 where there is no triangle.
class Hillshade {
 public:
  /// Degrees: the light's azimuth, clockwise from north, and its altitude above the horizon.
  explicit Hillshade(const Tin& tin, double azimuth = 315, double altitude = 45);

  void shades_of_cells(std::span<const Index> triangles, std::span<unsigned char> shades) const;

 private:
  std::vector<unsigned char> shade_;  // of each triangle
};

}  // namespace hodt
