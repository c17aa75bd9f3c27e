// Lines and outlines on a map.
// Tested by tests/io/line_file_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "hodt/base/ids.h"
#include "hodt/geometry/point.h"

namespace hodt {

/// A line from vertex to vertex, of which there is at least one. A closed one, such as a ring,
/// repeats its first vertex at its end.
struct Line {
  std::vector<Point> xy;
  std::vector<double> z;  ///< of each vertex; empty if heights are not known
  Index part = 0;         ///< the part of the source that it is of, from 1

  bool has_heights() const { return !z.empty(); }
  bool is_closed() const { return xy.front() == xy.back(); }
};

struct Lines {
  std::vector<Line> lines;

  /// What errors say: the file, and what it calls its parts ("feature"). Both may be empty.
  std::string source = {};
  std::string part = {};
  /// The coordinate reference system, as in PointSet.
  std::string crs = {};
  /// What may be wrong although the file could be read, each a sentence.
  std::vector<std::string> warnings = {};
};

/// An area. A place is inside if a ray from it meets the rings an odd number of times, so rings may
/// run in either direction, and those inside others bound holes and islands.
struct Outline {
  std::vector<Line> rings;  ///< all closed

  /// As in Lines.
  std::string source = {};
  std::string part = {};
  std::string crs = {};
  std::vector<std::string> warnings = {};
};

}  // namespace hodt
