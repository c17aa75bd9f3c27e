#include "hodt/mesh/glued.h"

#include <algorithm>
#include <tuple>
#include <vector>

namespace hodt {

TriangleMesh glued(std::size_t vertices, std::span<const std::array<Index, 3>> triangles) {
  Buffer<Index> origins(3 * triangles.size()), twins(3 * triangles.size(), kNone);
  struct Side {
    Index low, high, halfedge;
    bool operator<(const Side& other) const {
      return std::tie(low, high, halfedge) < std::tie(other.low, other.high, other.halfedge);
    }
  };
  std::vector<Side> sides;
  sides.reserve(origins.size());
  for (Index t = 0; t < triangles.size(); ++t)
    for (Index i = 0; i < 3; ++i) {
      const Index from = triangles[t][i], to = triangles[t][(i + 1) % 3];
      origins[3 * t + i] = from;
      sides.push_back({std::min(from, to), std::max(from, to), 3 * t + i});
    }
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const Side &a = sides[i - 1], &b = sides[i];
    if (std::tie(a.low, a.high) != std::tie(b.low, b.high)) continue;
    twins[a.halfedge] = b.halfedge;
    twins[b.halfedge] = a.halfedge;
  }
  return {vertices, std::move(origins), std::move(twins)};
}

}  // namespace hodt
