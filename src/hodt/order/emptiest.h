// Which vertex of a chain makes the triangle with the fewest in its circle: the step of the paper's
// greedy triangulation.
// Tested by tests/order/hull_test.cpp.
#pragma once

#include <cstddef>
#include <span>

#include "hodt/base/ids.h"
#include "hodt/geometry/predicates.h"

namespace hodt {

/// Of the vertices between the first and the last of a part of a chain, the one whose circle
/// through these two holds none of the others. REQUIRES one at least, and that all are on the left
/// of the edge from the first to the last.
inline std::size_t emptiest(std::span<const Point> xy, std::span<const VertexId> chain,
                            std::size_t first, std::size_t last) {
  const Point &a = xy[chain[first]], &b = xy[chain[last]];
  std::size_t best = first + 1;
  for (std::size_t i = first + 2; i < last; ++i)
    if (in_circle(a, b, xy[chain[best]], xy[chain[i]])) best = i;
  return best;
}

}  // namespace hodt
