#include "hodt/order/circle_counter.h"

namespace hodt {

void CircleCounter::begin_round() {
  inside_.clear();
  if (++round_ != 0) return;
  seen_.fill(0);
  round_ = 1;
}

Index CircleCounter::count(const Circle& circle, std::span<const VertexId> start, Index limit) {
  begin_round();
  const auto look_at = [&](VertexId v) {
    if (inside_.size() <= limit && first_visit(v) && circle.contains(graph_.point(v)))
      inside_.push_back(v);
  };
  for (const VertexId v : start) look_at(v);
  // A start on the circle is expanded like an inside point, but not counted.
  for (const VertexId v : start) {
    if (inside_.size() > limit) break;
    graph_.for_each_neighbour(v, look_at);
  }
  for (std::size_t i = 0; i < inside_.size() && inside_.size() <= limit; ++i)
    graph_.for_each_neighbour(inside_[i], look_at);
  return static_cast<Index>(inside_.size());
}

Index CircleCounter::triangle_order(VertexId a, VertexId b, VertexId c, Index limit) {
  const VertexId start[] = {a};
  return count(Circle(graph_.point(a), graph_.point(b), graph_.point(c)), start, limit);
}

}  // namespace hodt
