#include "hodt/order/open_triangles.h"

#include <algorithm>
#include <array>

#include "hodt/base/parallel.h"
#include "hodt/geometry/predicates.h"
#include "hodt/order/constrained/around.h"

namespace hodt {

namespace {

/// Whether q is on the line beyond p, seen from a.
bool goes_straight_on(const Point& a, const Point& p, const Point& q) {
  return lexicographically_less(a, p) == lexicographically_less(p, q) && orient(a, p, q) == 0;
}

/// Whether a wall that ends at v leads to a point with is_within(p).
template <class IsWithin>
bool has_wall(const DelaunayGraph& graph, VertexId v, const IsWithin& is_within) {
  if (!graph.ends_wall(v)) return false;
  const TriangleMesh& mesh = graph.mesh;
  bool found = false;
  for_each_outgoing(mesh, graph.outgoing[v], [&](HalfEdgeId h) {
    const HalfEdgeId last = TriangleMesh::prev(h);  // at the boundary no half-edge leaves v there
    found |= is_closed(graph, h) && is_within(graph.point(mesh.target(h)));
    found |= mesh.is_boundary(last) && is_within(graph.point(mesh.origin(last)));
  });
  return found;
}

/// Where a domain touches itself, the walls on all sides count.
template <class IsWithin>
bool has_wall_at_place(const DelaunayGraph& graph, VertexId v, const IsWithin& is_within) {
  const Point& at = graph.point(v);
  for (VertexId w = graph.place_of(v); w < graph.xy.size() && graph.point(w) == at;
       w = VertexId(w + 1))
    if (has_wall(graph, w, is_within)) return true;
  return false;
}

}  // namespace

std::vector<EdgeRecord> sides_of_open_triangles(const DelaunayGraph& graph, Index k,
                                                const Numbering& numbering,
                                                const Deadline& deadline) {
  std::vector<EdgeRecord> sides = all_edges(graph, EdgeClass::kod, k, deadline);
  const EdgeLists lists(sides, numbering);
  const auto point = [&](Index place) { return graph.point(numbering.ascending[place]); };
  /// The vertex after p on the way from a, or kNone.
  const auto next_in_line = [&](Index a, Index p) {
    for (const auto& [q, order] : lists.of(p))
      if (goes_straight_on(point(a), point(p), point(q))) return q;
    return kNone;
  };
  const std::vector<EdgeRecord> longer = parallel_collect<EdgeRecord>(
      0, lists.size(), 1 << 8, [&](std::size_t first, std::size_t last, auto& found) {
        for (Index a = Index(first); a < last; ++a) {
          deadline.check();
          for (const auto& end : lists.of(a)) {
            Index p = end.to;
            // What lies on a side is inside the circle.
            for (Index between = 1; between <= k; ++between) {
              p = next_in_line(a, p);
              if (p == kNone) break;
              if (a < p) found.push_back({numbering.ascending[a], numbering.ascending[p], between});
            }
          }
        }
      });
  sides.insert(sides.end(), longer.begin(), longer.end());
  return sides;
}

/// A wall does not cross a side, so it begins at a corner, or inside the triangle or its sides. Of
/// the latter places one at least is seen from a corner, and so among what is reached.
Index order_if_open(CircleCounter& counter, const DelaunayGraph& graph,
                    const std::array<VertexId, 3>& corners, Index limit) {
  std::array<Point, 3> at;
  std::transform(corners.begin(), corners.end(), at.begin(),
                 [&](VertexId v) { return graph.point(v); });
  const auto side_of = [&](std::size_t i, const Point& p) {
    return orient(at[i], at[(i + 1) % 3], p);
  };
  for (std::size_t i = 0; i < 3; ++i)
    if (has_wall(graph, corners[i],
                 [&](const Point& p) { return side_of(i, p) > 0 && side_of((i + 2) % 3, p) > 0; }))
      return limit + 1;
  const Index inside = counter.count(corners[0], corners[1], corners[2], limit);
  if (inside > limit) return inside;
  for (const VertexId v : counter.inside()) {
    const Point& q = graph.point(v);
    const std::array<int, 3> sides{side_of(0, q), side_of(1, q), side_of(2, q)};
    const auto on_side = std::find(sides.begin(), sides.end(), 0);
    if (*std::min_element(sides.begin(), sides.end()) < 0) continue;  // not in the triangle
    if (on_side == sides.end() && graph.ends_wall(v)) return limit + 1;
    if (on_side != sides.end() && has_wall_at_place(graph, v, [&](const Point& p) {
          return side_of(std::size_t(on_side - sides.begin()), p) > 0;
        }))
      return limit + 1;
  }
  return inside;
}

}  // namespace hodt
