#include "hodt/optimize/extrema/height_ranks.h"

#include <atomic>

#include "hodt/base/parallel.h"

namespace hodt {

Buffer<HeightRanks> height_ranks_of(const TriangleMesh& mesh, const Heights& heights) {
  Buffer<HeightRanks> ranks(mesh.vertex_count(), HeightRanks{});
  // Threads may meet at a vertex, but all they ever write is 1.
  const auto set = [&](VertexId v, unsigned lower) {
    std::atomic_ref<std::uint8_t>(ranks[v].with_lower[lower]).store(1, std::memory_order_relaxed);
  };
  parallel_for(0, mesh.triangle_count(), 1 << 14, [&](std::size_t first, std::size_t last) {
    for (std::size_t t = first; t < last; ++t) {
      const auto [a, b, c] = mesh.corners(TriangleId(Index(t)));
      // Which corner is lower is a matter of chance: counted, not branched on.
      const bool ab = heights.lower(a, b), bc = heights.lower(b, c), ca = heights.lower(c, a);
      set(a, unsigned(ca) + !ab);
      set(b, unsigned(ab) + !bc);
      set(c, unsigned(bc) + !ca);
    }
  });
  return ranks;
}

}  // namespace hodt
