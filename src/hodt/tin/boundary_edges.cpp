#include "hodt/tin/boundary_edges.h"

#include <algorithm>
#include <utility>

namespace hodt {

std::vector<std::array<Index, 2>> boundary_edges(std::span<const std::array<Index, 3>> triangles) {
  using Edge = std::array<Index, 2>;
  std::vector<std::pair<Edge, bool>> sides;  // by the smaller end; whether it runs from there
  sides.reserve(3 * triangles.size());
  for (const auto& corners : triangles)
    for (int i = 0; i < 3; ++i) {
      const Index from = corners[i], to = corners[(i + 1) % 3];
      sides.push_back({{std::min(from, to), std::max(from, to)}, from < to});
    }
  std::sort(sides.begin(), sides.end());
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < sides.size();) {
    const auto& [ends, is_upward] = sides[i];
    std::size_t next = i + 1;
    while (next < sides.size() && sides[next].first == ends) ++next;
    if (next == i + 1) edges.push_back(is_upward ? ends : Edge{ends[1], ends[0]});
    i = next;
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

}  // namespace hodt
