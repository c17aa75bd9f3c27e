#include "hodt/order/search/count_past_hubs.h"

#include <algorithm>

#include "hodt/geometry/circle.h"
#include "hodt/geometry/predicates.h"

namespace hodt {

Index CountPastHubs::useful_order(VertexId u, VertexId v, VertexId left, VertexId right,
                                  Index limit) {
  // Questions to points. A tree over all points answers in about as many as there are boxes that
  // the circle crosses.
  work_left_ = 1000 + 100 * std::size_t{limit};
  if (graph_.is_hub(u) && graph_.is_hub(v)) return kNone;
  const Index on_right = count_in_first_circle(u, v, left, limit);
  if (on_right > limit) return on_right;
  const Index on_left = count_in_first_circle(v, u, right, limit);
  return std::max(on_left, on_right);
}

/// The points on the right of uv inside the circle through u, v and the first point on the left;
/// `first` is any of that side to begin with. A point on the left that is inside takes its place,
/// and then no point on the right that was inside is lost: so a count above the limit ends it.
Index CountPastHubs::count_in_first_circle(VertexId u, VertexId v, VertexId first, Index limit) {
  const Point &a = graph_.point(u), &b = graph_.point(v);
  const VertexId start = graph_.is_hub(u) ? v : u;
  for (;;) {
    inside_.clear();
    seen_.begin_round();
    for (const VertexId corner : {u, v, first}) seen_.mark(corner);
    const Circle circle(a, b, graph_.point(first));
    VertexId earlier;
    const auto visit = [&](VertexId w) {
      if (earlier.valid() || inside_.size() > limit || work_left_ == 0) return;
      if (!seen_.mark(w)) return;
      --work_left_;
      if (!circle.contains(graph_.point(w))) return;
      if (orient(a, b, graph_.point(w)) > 0)
        earlier = w;
      else
        inside_.push_back(w);
    };
    graph_.for_each_onward(start, start, visit);
    for (std::size_t i = 0; i < inside_.size(); ++i)
      graph_.for_each_onward(inside_[i], start, visit);
    if (inside_.size() > limit) return limit + 1;
    if (work_left_ == 0) return kNone;
    if (!earlier.valid()) return static_cast<Index>(inside_.size());
    first = earlier;
  }
}

}  // namespace hodt
