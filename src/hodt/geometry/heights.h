// The order of heights, which has no ties, and the two kinds of local extrema.
#pragma once

#include <cstdint>
#include <span>

#include "hodt/base/ids.h"
#include "hodt/geometry/point.h"

namespace hodt {

/// What a vertex is an extremum of.
enum class Extremum : std::uint8_t { minimum, maximum };
inline constexpr Extremum kExtrema[] = {Extremum::minimum, Extremum::maximum};

/// One bit a kind, for sets of kinds.
constexpr std::uint8_t bit(Extremum kind) {
  return std::uint8_t(1u << unsigned(kind));
}

/// The order of heights: by z, ties by x and then y.
struct Heights {
  std::span<const Point> xy;
  std::span<const double> z;

  bool lower(VertexId u, VertexId v) const {
    if (z[u] != z[v]) return z[u] < z[v];
    return lexicographically_less(xy[u], xy[v]);
  }
  /// Whether v, as a neighbour of u, keeps u from being an extremum of that kind.
  bool removes(VertexId v, VertexId u, Extremum kind) const {
    return kind == Extremum::minimum ? lower(v, u) : lower(u, v);
  }
};

}  // namespace hodt
