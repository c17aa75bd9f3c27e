// What a file of features holds, piece by piece: the interface between formats and their users.
// Tested by tests/io/places_file_test.cpp.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "hodt/base/ids.h"
#include "hodt/geometry/lines.h"
#include "hodt/geometry/point.h"

namespace hodt {

/// Who takes what a file holds, in its order. A kind of geometry that nobody takes is refused. What
/// a taker cannot use it refuses by an InputError; it need not say where that is.
struct FeatureTaker {
  /// The feature that the point is of, from 1. A geometry outside of features is one by itself.
  std::function<void(const Point&, Index feature)> point = {};
  /// Two positions or more.
  std::function<void(Line)> line = {};
  /// Three corners or more; the first corner may be repeated at the end. `outer`: a polygon begins.
  std::function<void(Line ring, bool outer)> ring = {};
  /// A sentence about what may be wrong although it could be read. May be empty.
  std::function<void(std::string)> warning = {};

  /// What errors say that a file can hold: "points and polygons".
  std::string_view can_hold = {};
  /// Whether lines and rings get their heights, which all positions of one have, or none.
  bool heights = false;
  /// Whether a geometry of no coordinates is nothing, as GeoJSON allows, or an error.
  bool skips_empty = false;
};

}  // namespace hodt
