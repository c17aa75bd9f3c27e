// Places and areas on a map.
// Tested by tests/hydrology/points_in_polygons_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "hodt/base/ids.h"
#include "hodt/geometry/point.h"

namespace hodt {

/// An area with straight sides. The first ring is its outline, the others bound its holes; whether
/// a ring's last corner repeats the first makes no difference. A place is inside if a ray from it
/// meets the rings an odd number of times, and on any of them. So rings may touch or cross
/// themselves and each other.
struct Polygon {
  std::vector<std::vector<Point>> rings;
};

struct Places {
  std::vector<Point> points;
  std::vector<Polygon> polygons;

  /// What errors say: the file, what it calls its parts ("feature"), and their numbers for each
  /// point and polygon. All may be empty.
  std::string source = {};
  std::string part = {};
  std::vector<Index> part_of_point = {};
  std::vector<Index> part_of_polygon = {};
  /// The coordinate reference system, as in PointSet.
  std::string crs = {};
  /// As in Lines.
  std::vector<std::string> warnings = {};

  bool empty() const { return points.empty() && polygons.empty(); }
};

}  // namespace hodt
