// The dense surface behind the terrain `valley`: hills cut by rivers, free of pits by construction.
//
// Internal to this layer; the tests look at the grid itself.
// Tested by tests/terrain/terrain_test.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hodt/base/ids.h"

namespace hodt {

/// Heights at the corners of a lattice of equilateral triangles, linear on each triangle. Every
/// second row is shifted by half a step:
///
///     o---o---o---o      row 2
///      \ / \ / \ / \           .
///       o---o---o---o    row 1
///      / \ / \ / \ /
///     o---o---o---o      row 0
///
/// All six neighbours are equally far, so that rivers prefer no direction.
struct TriangularGrid {
  std::size_t columns = 0;
  std::size_t rows = 0;
  double spacing = 0;  ///< metres between neighbours
  std::vector<double> height;

  std::size_t size() const { return height.size(); }
  double row_spacing() const { return spacing * kRowsPerSpacing; }
  bool on_border(std::size_t vertex) const;
  /// The height at (x, y) metres from vertex 0.
  /// Requires spacing / 2 <= x < (columns - 1) * spacing and 0 <= y < (rows - 1) * row_spacing().
  double height_at(double x, double y) const;

  static constexpr double kRowsPerSpacing = 0.86602540378443864676;  // sqrt(3) / 2
};

/// The neighbours of a vertex along the edges of the lattice: six, fewer on the border.
struct Neighbours {
  std::array<Index, 6> vertex;
  std::size_t count = 0;

  const Index* begin() const { return vertex.data(); }
  const Index* end() const { return vertex.data() + count; }
};
Neighbours neighbours_of(const TriangularGrid& grid, std::size_t vertex);

/// A landscape of columns x rows vertices, `spacing` metres apart, cut by a river network that
/// leaves across the border. Every vertex off the border has a strictly lower neighbour, lower by
/// at least minimum_drop(spacing): rounding to millimetres makes no pit.
/// Requires at least 3 columns and rows.
TriangularGrid eroded_grid(std::size_t columns, std::size_t rows, double spacing,
                           std::uint64_t seed);

/// The least fall of a river from a vertex to the next, in metres.
double minimum_drop(double spacing);

}  // namespace hodt
