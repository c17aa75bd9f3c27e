// Triangles that may be given in either direction, turned counter-clockwise.
// Tested by tests/tin/interpolate_test.cpp.
#pragma once

#include <array>
#include <span>
#include <utility>

#include "hodt/base/ids.h"
#include "hodt/geometry/predicates.h"
#include "hodt/tin/tin.h"

namespace hodt {

inline std::array<Index, 3> counter_clockwise(std::span<const Point> xy,
                                              std::array<Index, 3> corners) {
  auto& [a, b, c] = corners;
  if (orient(xy[a], xy[b], xy[c]) < 0) std::swap(b, c);
  return corners;
}

inline void make_counter_clockwise(Tin& tin) {
  for (auto& corners : tin.triangles) corners = counter_clockwise(tin.points.xy, corners);
}

}  // namespace hodt
