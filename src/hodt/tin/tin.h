// A triangulated irregular network: what is read from and written to mesh files.
// Tested by tests/io/tin_file_test.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "hodt/base/ids.h"
#include "hodt/geometry/point_set.h"

namespace hodt {

struct Tin {
  PointSet points;
  /// Corners of each triangle as indices into points; counter-clockwise in what hodt makes.
  std::vector<std::array<Index, 3>> triangles;
  /// Coordinate reference system as "EPSG:25832", or empty if unknown.
  std::string crs;
  /// The order of each triangle, where it is known; else empty.
  std::vector<Index> order = {};

  /// Whether a triangle is none of the (constrained) Delaunay triangulation. Requires `order`.
  bool is_changed(std::size_t t) const { return order[t] > 0; }
};

}  // namespace hodt
