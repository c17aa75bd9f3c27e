#include "hodt/order/circle_counter.h"

namespace hodt {

namespace {

/// Of a vertex that has more neighbours than hubs need (see DelaunayGraph), so many are asked.
constexpr std::size_t kMany = 256;

/// Whether the circle holds the origin of `start` only, if that is known from so many neighbours.
template <bool kWalls>
std::optional<bool> holds_only_by(std::size_t most, const DelaunayGraph& graph,
                                  const std::array<VertexId, 3>& corners, HalfEdgeId start) {
  const TriangleMesh& mesh = graph.mesh;
  const auto [a, b, c] = corners;
  const Circle circle(graph.point(a), graph.point(b), graph.point(c));
  const auto is_inside = [&, a = a, b = b, c = c](VertexId w) {
    // To ask about a corner would send it to exact arithmetic, for a known answer.
    return w != a && w != b && w != c && circle.contains(graph.point(w));
  };
  if (!is_inside(mesh.origin(start))) return false;
  const auto ends_at = [&](HalfEdgeId g) {
    return mesh.is_boundary(g) || (kWalls && graph.walls[g]);
  };
  std::size_t asked = 0;
  HalfEdgeId h = start;
  do {
    if (++asked > most) return std::nullopt;
    if (is_inside(mesh.target(h))) return false;
    if (ends_at(TriangleMesh::prev(h))) break;
    h = mesh.rotate_ccw(h);
  } while (h != start);
  if (!ends_at(TriangleMesh::prev(h))) return true;
  // The boundary or a wall was in the way: the other way around from the start.
  if (is_inside(mesh.apex(h))) return false;
  for (h = start; !ends_at(h);) {
    h = mesh.rotate_cw(h);
    if (++asked > most) return std::nullopt;
    if (is_inside(mesh.target(h))) return false;
  }
  return true;
}

}  // namespace

bool holds_origin_only(const DelaunayGraph& graph, const std::array<VertexId, 3>& corners,
                       HalfEdgeId h) {
  const std::size_t all = graph.xy.size();
  return graph.has_walls() ? *holds_only_by<true>(all, graph, corners, h)
                           : *holds_only_by<false>(all, graph, corners, h);
}

Index CircleCounter::count(VertexId a, VertexId b, VertexId c, Index limit,
                           VertexId perhaps_inside) {
  if (reachable_) return reachable_->count(a, b, c, limit);
  inside_.clear();
  seen_.begin_round();
  // The three are on the circle: to ask would send each to exact arithmetic, for a known answer.
  for (const VertexId v : {a, b, c}) seen_.mark(v);
  const Circle circle(graph_.point(a), graph_.point(b), graph_.point(c));
  const auto visit = [&](VertexId w) {
    if (inside_.size() <= limit && seen_.mark(w) && circle.contains(graph_.point(w)))
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

bool SoleInside::holds_origin_only(const std::array<VertexId, 3>& corners, HalfEdgeId h) {
  if (graph_.has_walls()) return hodt::holds_origin_only(graph_, corners, h);
  if (const std::optional<bool> known = holds_only_by<false>(kMany, graph_, corners, h))
    return *known;
  const auto [a, b, c] = corners;
  CircleCounter& counter = past_hubs();
  return counter.count(a, b, c, 1) == 1 && counter.inside().front() == graph_.mesh.origin(h);
}

CircleCounter& SoleInside::past_hubs() {
  std::call_once(is_listed_, [&] {
    if (!graph_.has_hubs()) isolated([&] { listed_.emplace(graph_).list_neighbours(); });
    counters_.emplace([this] { return CircleCounter(listed_ ? *listed_ : graph_); });
  });
  return counters_->mine();
}

}  // namespace hodt
