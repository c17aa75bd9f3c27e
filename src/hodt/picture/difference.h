// What differs between two triangulations of the same points. Internal to this layer.
// Tested by tests/picture/picture_test.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "hodt/base/ids.h"
#include "hodt/tin/tin.h"

namespace hodt {

/// Ends of an edge, the smaller index first.
using Edge = std::array<Index, 2>;

/// Local minima, or maxima, of two triangulations: vertices with no lower, or higher, neighbour.
struct ExtremaChange {
  std::vector<Index> vanished;   ///< of the first only
  std::vector<Index> remaining;  ///< of both, but for those kept
  std::vector<Index> kept;       ///< of both, which were to stay
  std::vector<Index> made;       ///< of the second only

  std::size_t before() const { return vanished.size() + remaining.size() + kept.size(); }
  std::size_t after() const { return made.size() + remaining.size() + kept.size(); }
};

struct Difference {
  std::vector<Edge> kept;          ///< in both, sorted
  std::vector<Edge> removed;       ///< only in the first
  std::vector<Edge> added;         ///< only in the second
  std::vector<Index> added_order;  ///< of each of these the larger order of its triangles, if known
  ExtremaChange minima, maxima;    ///< empty without heights
};

/// Requires the same points in both; `kept` are minima that were to stay, in ascending order.
Difference difference(const Tin& before, const Tin& after, std::span<const Index> kept = {});

}  // namespace hodt
