// One side of an edge, where a triangle can be.
// Tested by tests/optimize/optimize_measure_test.cpp.
#pragma once

#include <algorithm>
#include <tuple>

#include "hodt/base/ids.h"

namespace hodt {

/// The side of an edge that one triangle is on: from either side the edge has the same name.
struct EdgeSide {
  Index low = 0, high = 0;  // the ends
  bool is_left = false;     // of low -> high
  Index triangle = 0;       // by its place in some list

  /// On the left of u -> v.
  EdgeSide(VertexId u, VertexId v, Index t)
      : low(std::min<Index>(u, v)), high(std::max<Index>(u, v)), is_left(u < v), triangle(t) {}
  EdgeSide() = default;

  auto edge() const { return std::tuple(low, high); }
};

}  // namespace hodt
