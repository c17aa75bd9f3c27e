#include "hodt/order/circle_counter.h"

namespace hodt {

bool holds_only(const DelaunayGraph& graph, const std::array<VertexId, 3>& corners, VertexId v) {
  const TriangleMesh& mesh = graph.mesh;
  const auto [a, b, c] = corners;
  const Circle circle(graph.point(a), graph.point(b), graph.point(c));
  const auto is_inside = [&](VertexId w) {
    // To ask about a corner would send it to exact arithmetic, for a known answer.
    return w != a && w != b && w != c && circle.contains(graph.point(w));
  };
  if (!is_inside(v)) return false;
  // for_each_neighbour, but of very many neighbours mostly one of the first is inside.
  const HalfEdgeId start = graph.outgoing[v];
  HalfEdgeId h = start;
  do {
    if (is_inside(mesh.target(h))) return false;
    const HalfEdgeId following = mesh.rotate_ccw(h);
    if (!following.valid()) return !is_inside(mesh.apex(h));
    h = following;
  } while (h != start);
  return true;
}

void CircleCounter::begin_round() {
  inside_.clear();
  if (++round_ != 0) return;
  seen_.fill(0);
  round_ = 1;
}

Index CircleCounter::count(VertexId a, VertexId b, VertexId c, Index limit,
                           VertexId perhaps_inside) {
  begin_round();
  // The three are on the circle: to ask would send each to exact arithmetic, for a known answer.
  for (const VertexId v : {a, b, c}) first_visit(v);
  const Circle circle(graph_.point(a), graph_.point(b), graph_.point(c));
  const auto visit = [&](VertexId w) {
    if (inside_.size() <= limit && first_visit(w) && circle.contains(graph_.point(w)))
      inside_.push_back(w);
  };
  // Past hubs, if there is a corner that is none to begin with.
  VertexId start = !graph_.is_hub(a) ? a : !graph_.is_hub(b) ? b : c;
  const auto go_on_from = [&](VertexId v) { graph_.for_each_onward(v, start, visit); };
  if (perhaps_inside.valid() && !graph_.is_hub(perhaps_inside)) visit(perhaps_inside);
  if (inside_.empty())
    go_on_from(start);
  else
    start = inside_.front();
  for (std::size_t i = 0; i < inside_.size() && inside_.size() <= limit; ++i)
    go_on_from(inside_[i]);
  return static_cast<Index>(inside_.size());
}

}  // namespace hodt
