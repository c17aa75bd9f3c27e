// What differs between two triangulations of the same points. Internal to this layer.
// Tested by tests/picture/picture_test.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "hodt/base/ids.h"
#include "hodt/tin/tin.h"

namespace hodt {

/// Ends of an edge, the smaller index first.
using Edge = std::array<Index, 2>;

struct Difference {
  std::vector<Edge> kept;         ///< in both, sorted
  std::vector<Edge> removed;      ///< only in the first
  std::vector<Edge> added;        ///< only in the second
  std::size_t minima_before = 0;  ///< of the first triangulation
  /// Vertices with no lower neighbour in the first triangulation, but one in the second.
  std::vector<Index> vanished_minima;
  /// Vertices with no lower neighbour in the second triangulation.
  std::vector<Index> remaining_minima;
};

/// Requires the same points with heights in both.
Difference difference(const Tin& before, const Tin& after);

}  // namespace hodt
