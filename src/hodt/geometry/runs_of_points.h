// Vertices that are at one point: several, one after the other, where a domain touches itself.
// Tested by tests/exhaustive/constraints_small_test.cpp.
#pragma once

#include <span>

#include "hodt/base/ids.h"
#include "hodt/geometry/point.h"

namespace hodt {

/// Calls f(first, end) for every run of equal points, mostly of one.
template <class F>
void for_each_point(std::span<const Point> xy, const F& f) {
  for (Index first = 0, end = 0; first < xy.size(); first = end) {
    for (end = first + 1; end < xy.size() && xy[end] == xy[first];) ++end;
    f(first, end);
  }
}

}  // namespace hodt
