// The edges of a list of triangles.
// Tested by tests/order/mesh_order_test.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "hodt/base/ids.h"

namespace hodt {

/// The sides of all triangles, the smaller end first, sorted: an edge of two triangles comes twice.
/// Corners go by number(corner).
template <class Number>
std::vector<std::array<Index, 2>> sorted_edges(std::span<const std::array<Index, 3>> triangles,
                                               const Number& number) {
  std::vector<std::array<Index, 2>> edges;
  edges.reserve(3 * triangles.size());
  for (const auto& [a, b, c] : triangles)
    for (const auto& [u, v] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      const Index from = number(u), to = number(v);
      edges.push_back({std::min(from, to), std::max(from, to)});
    }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Whether one of them is the edge uv.
inline bool has_edge(std::span<const std::array<Index, 2>> sorted_edges, Index u, Index v) {
  return std::binary_search(sorted_edges.begin(), sorted_edges.end(),
                            std::array{std::min(u, v), std::max(u, v)});
}

}  // namespace hodt
