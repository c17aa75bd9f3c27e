// Useful orders of edges where hubs are near: by the points around, without a look at a hub's
// neighbours.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "hodt/base/round_marks.h"
#include "hodt/order/delaunay_graph.h"

namespace hodt {

/// Counts by searching outward, as CircleCounter does, past hubs. The points inside a circle are
/// connected there with any point on it that is no hub. Holds scratch memory for one thread.
class CountPastHubs {
 public:
  explicit CountPastHubs(const DelaunayGraph& graph) : graph_(graph), seen_(graph.xy.size()) {}

  /// The useful order of uv by Lemma 4, or more than `limit` if it is larger. kNone if that is not
  /// to be found out with little work. REQUIRES a point of either side to start with, and none on
  /// the segment.
  Index useful_order(VertexId u, VertexId v, VertexId left, VertexId right, Index limit);

 private:
  Index count_in_first_circle(VertexId u, VertexId v, VertexId first, Index limit);

  const DelaunayGraph& graph_;
  std::size_t work_left_ = 0;
  RoundMarks seen_;
  std::vector<VertexId> inside_;
};

}  // namespace hodt
