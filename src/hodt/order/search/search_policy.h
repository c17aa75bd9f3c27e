// Which search answers for which orders: every number that decides it. They are measured
// (bench/useful_edges_vs_cgal and _vs_n); none of them changes a result.
// Tested by tests/order/useful_edges_test.cpp.
#pragma once

#include <cstddef>
#include <iterator>

#include "hodt/base/ids.h"

namespace hodt {

/// Where to look for the other ends of edges.
enum class Towards { all, larger, smaller };  // lexicographically

/// A way to find the useful edges of a vertex.
enum class Way {
  flips,       ///< of Delaunay edges: all there is of order 1 (Corollary 3)
  windows,     ///< WindowWalk: gives up where too many points are around
  neighbours,  ///< the set of neighbours: takes long at hubs and where many points are near a
               ///< circle
  levels,      ///< LargeOrderSearch: needs a tree
};

namespace search_policy {

/// The way to begin with for orders up to `most`.
struct Row {
  Index most;
  Way to_all, to_half;
};

inline constexpr Row kRows[] = {
    {1, Way::flips, Way::flips},
    {8, Way::windows, Way::windows},
    {16, Way::neighbours, Way::neighbours},
    // From 17 on half of a walk is as good as the set where it will do, and better near circles.
    {100, Way::neighbours, Way::windows},
    {319, Way::neighbours, Way::neighbours},
    {kNone, Way::levels, Way::levels},
};

constexpr Way first_way(Index order, Towards towards) {
  const Row* row = std::begin(kRows);
  while (row->most < order) ++row;
  return towards == Towards::all ? row->to_all : row->to_half;
}

/// The orders up to which walks that know 64 and 256 points mostly do. For larger ones a walk knows
/// 1024.
inline constexpr Index kNarrowWalk = 8, kWideWalk = 32;

/// Whether a walk in all directions is made in halves, as each needs fewer points than both do.
constexpr bool in_halves(Index order) {
  return order > kNarrowWalk;
}
/// Whether a walk looks at candidates that nobody asked for: it makes more points known, which ends
/// the walk earlier.
constexpr bool looks_at_all(Index order) {
  return order > kNarrowWalk;
}

/// So many questions (one point against another) are few for a set of neighbours. Where many points
/// are near one circle they begin to count, and soon are too many.
constexpr std::size_t few_questions(Index order) {
  return 200 * std::size_t{order};
}

/// For orders from here on a tree over the points pays.
inline constexpr Index kLeastWithTree = 16;

}  // namespace search_policy

}  // namespace hodt
