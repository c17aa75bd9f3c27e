#include "hodt/order/constrained/reachable.h"

#include <algorithm>

#include "hodt/geometry/predicates.h"
#include "hodt/mesh/find_outgoing.h"
#include "hodt/order/constrained/around.h"

namespace hodt {

Index Reachable::count(VertexId a, VertexId b, VertexId c, Index limit) {
  const Circle circle(graph_.point(a), graph_.point(b), graph_.point(c));
  circle_ = &circle;
  inside_.clear();
  reached_.clear();
  gone_around_.clear();
  seen_.begin_round();
  counted_.begin_round();
  // The three are on the circle: to ask would send each to exact arithmetic, for a known answer.
  for (const VertexId v : {a, b, c}) seen_.mark(v);
  // From a corner without very many neighbours, if there is one.
  if (!begin_at(a, b, c, kFewTriangles) && !begin_at(b, c, a, kFewTriangles) &&
      !begin_at(c, a, b, kFewTriangles))
    begin_at(a, b, c, kNone);
  if (overlapping_.empty()) return limit + 1;
  for (std::size_t i = 0; i < reached_.size() && inside_.size() <= limit; ++i)
    go_around(reached_[i]);
  if (inside_.size() > limit) inside_.resize(limit + 1);
  return static_cast<Index>(inside_.size());
}

/// Visits the corners of the triangles at a that overlap the triangle abc. False, and nothing
/// visited, if a has more than `most`.
bool Reachable::begin_at(VertexId a, VertexId b, VertexId c, Index most) {
  const TriangleMesh& mesh = graph_.mesh;
  const Point &at = graph_.point(a), &right = graph_.point(b), &left = graph_.point(c);
  overlapping_.clear();
  const auto overlaps = [&](HalfEdgeId h) {
    const Point &p = graph_.point(mesh.target(h)), &q = graph_.point(mesh.apex(h));
    // One of the two angles begins within the other.
    if (orient(at, right, p) >= 0) return orient(at, p, left) > 0;
    return orient(at, p, right) >= 0 && orient(at, right, q) > 0;
  };
  const bool are_all = find_outgoing(mesh, graph_.outgoing[a], most, [&](HalfEdgeId h) {
                         if (overlaps(h)) overlapping_.push_back(h);
                         return false;
                       }).is_known;
  if (are_all)
    for (const HalfEdgeId h : overlapping_) {
      visit(TriangleMesh::next(h));
      visit(TriangleMesh::prev(h));
    }
  return are_all;
}

/// The origin of a half-edge whose triangle is reached.
void Reachable::visit(HalfEdgeId from) {
  const VertexId v = graph_.mesh.origin(from);
  if (seen_.mark(v)) {
    if (!circle_->contains(graph_.point(v))) return;
    if (counted_.mark(graph_.place_of(v))) inside_.push_back(v);
    reached_.push_back(from);
  } else if (graph_.is_parted(v) && counted_.is_marked(graph_.place_of(v))) {
    reached_.push_back(from);  // perhaps from another side
  }
}

/// Visits the neighbours on this side of the walls at the origin.
void Reachable::go_around(HalfEdgeId from) {
  const bool is_parted = graph_.is_parted(graph_.mesh.origin(from));
  if (is_parted && std::find(gone_around_.begin(), gone_around_.end(), from) != gone_around_.end())
    return;
  for_each_reached_around(
      graph_, from,
      [&](HalfEdgeId h) {
        if (is_parted) gone_around_.push_back(h);
      },
      [&](HalfEdgeId h) { visit(h); });
}

}  // namespace hodt
