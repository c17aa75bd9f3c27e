// What a reader hands over: points in the order of the input's data rows.
// Tested by tests/io/point_file_test.cpp.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "hodt/geometry/point.h"

namespace hodt {

struct PointSet {
  std::vector<Point> xy;
  /// Heights, one a point; empty if the input has none.
  std::vector<double> z;
  /// The coordinate reference system, as "EPSG:25832" or WKT; empty if unknown.
  std::string crs = {};

  std::size_t size() const { return xy.size(); }
  bool has_heights() const { return !z.empty(); }
};

}  // namespace hodt
