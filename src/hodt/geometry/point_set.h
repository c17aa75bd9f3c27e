// What a reader hands over: points in the order of the input's data rows.
// Tested by tests/io/point_file_test.cpp.
#pragma once

#include <cstddef>
#include <span>
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

/// The same where somebody else holds the memory: points of a PointSet, or of a program's arrays.
struct PointView {
  std::span<const Point> xy;
  std::span<const double> z;

  PointView() = default;
  PointView(std::span<const Point> places, std::span<const double> heights)
      : xy(places), z(heights) {}
  PointView(const PointSet& points) : xy(points.xy), z(points.z) {}  // NOLINT: it is a view of them

  std::size_t size() const { return xy.size(); }
  bool has_heights() const { return !z.empty(); }
};

}  // namespace hodt
