#include "hodt/order/triangulation_order.h"

#include "hodt/base/parallel.h"
#include "hodt/order/circle_counter.h"

namespace hodt {

std::vector<std::size_t> order_histogram(const DelaunayGraph& graph, const TriangleMesh& mesh) {
  std::vector<TriangleId> changed;
  for (Index i = 0; i < mesh.triangle_count(); ++i)
    if (mesh.corners(TriangleId(i)) != graph.mesh.corners(TriangleId(i)))
      changed.push_back(TriangleId(i));

  std::vector<Index> orders(changed.size());
  PerThread<CircleCounter> counters([&] { return CircleCounter(graph); });
  parallel_for(0, changed.size(), 256, [&](std::size_t first, std::size_t last) {
    CircleCounter& counter = counters.mine();
    for (std::size_t i = first; i < last; ++i) {
      const auto [a, b, c] = mesh.corners(changed[i]);
      orders[i] = counter.count(a, b, c, kUnlimited);
    }
  });

  std::vector<std::size_t> histogram(1, mesh.triangle_count() - changed.size());
  for (const Index order : orders) {
    if (histogram.size() <= order) histogram.resize(order + 1, 0);
    ++histogram[order];
  }
  return histogram;
}

}  // namespace hodt
