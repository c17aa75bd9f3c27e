#include "hodt/order/circle_counter.h"

namespace hodt {

void CircleCounter::begin_round() {
  inside_.clear();
  if (++round_ != 0) return;
  seen_.fill(0);
  round_ = 1;
}

void CircleCounter::look_around(const Circle& circle, VertexId v, Index limit) {
  graph_.for_each_neighbour(v, [&](VertexId w) {
    if (inside_.size() <= limit && first_visit(w) && circle.contains(graph_.point(w)))
      inside_.push_back(w);
  });
}

Index CircleCounter::count(VertexId a, VertexId b, VertexId c, Index limit,
                           std::span<const VertexId> inside) {
  begin_round();
  // The three are on the circle: to ask would send each to exact arithmetic, for a known answer.
  for (const VertexId v : {a, b, c}) first_visit(v);
  for (const VertexId v : inside)
    if (inside_.size() <= limit && first_visit(v)) inside_.push_back(v);
  const Circle circle(graph_.point(a), graph_.point(b), graph_.point(c));
  if (inside_.empty()) look_around(circle, a, limit);
  for (std::size_t i = 0; i < inside_.size() && inside_.size() <= limit; ++i)
    look_around(circle, inside_[i], limit);
  return static_cast<Index>(inside_.size());
}

}  // namespace hodt
