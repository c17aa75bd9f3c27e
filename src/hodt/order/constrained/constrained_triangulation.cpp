#include "hodt/order/constrained/constrained_triangulation.h"

#include <algorithm>

#include "hodt/geometry/predicates.h"
#include "hodt/order/emptiest.h"
#include "hodt/order/segment_walk.h"

namespace hodt {

ConstrainedTriangulation::ConstrainedTriangulation(const DelaunayGraph& delaunay)
    : delaunay_(delaunay),
      xy_(delaunay.xy),
      mesh_(delaunay.mesh),
      outgoing_(delaunay.outgoing.all().size()),
      partner_(delaunay.xy.size(), kNone) {
  std::copy(delaunay.outgoing.all().begin(), delaunay.outgoing.all().end(), outgoing_.begin());
}

// ---- Every change is a write of one word, and the log knows what was there. ----

Index& ConstrainedTriangulation::cell(Field field, Index index) {
  switch (field) {
    case Field::origin:
      return mesh_.origins()[index];
    case Field::twin:
      return mesh_.twins()[index];
    case Field::outgoing:
      return outgoing_[index];
    default:
      return partner_[index];
  }
}

void ConstrainedTriangulation::write(Field field, Index index, Index value) {
  Index& place = cell(field, index);
  if (place == value) return;
  log_.push_back({field, index, place});
  place = value;
}

void ConstrainedTriangulation::roll_back(Moment moment) {
  while (log_.size() > moment) {
    const Write& last = log_.back();
    cell(last.field, last.index) = last.old_value;
    log_.pop_back();
  }
}

void ConstrainedTriangulation::changed_since(Moment moment,
                                             std::vector<TriangleId>& triangles) const {
  triangles.clear();
  for (std::size_t i = moment; i < log_.size(); ++i)
    if (log_[i].field == Field::origin)
      triangles.push_back(TriangleMesh::triangle(HalfEdgeId(log_[i].index)));
  std::sort(triangles.begin(), triangles.end());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
}

bool ConstrainedTriangulation::is_original(TriangleId t) const {
  return mesh_.corners(t) == delaunay_.mesh.corners(t);
}

void ConstrainedTriangulation::glue(HalfEdgeId a, Index b) {
  write(Field::twin, a, b);
  if (b != kNone) write(Field::twin, b, a);
}

void ConstrainedTriangulation::set_triangle(TriangleId t, VertexId a, VertexId b, VertexId c) {
  const Index h = TriangleMesh::halfedge(t);
  write(Field::origin, h, a);
  write(Field::origin, h + 1, b);
  write(Field::origin, h + 2, c);
}

/// Points the corners of a new triangle at it, boundary half-edges first.
void ConstrainedTriangulation::keep_outgoing_valid(TriangleId t) {
  for (Index i = 0; i < 3; ++i) {
    const HalfEdgeId h(TriangleMesh::halfedge(t) + i);
    const VertexId v = mesh_.origin(h);
    const HalfEdgeId known(outgoing_[v]);
    const bool still_leaves = mesh_.origin(known) == v;
    if (mesh_.is_boundary(h) || !still_leaves) write(Field::outgoing, v, h);
  }
}

// ---- Walking along a segment. ----

/// The half-edge from one vertex to another, or kNone. If only the boundary half-edge of the other
/// direction exists, that one.
HalfEdgeId ConstrainedTriangulation::find_edge(VertexId from, VertexId to) const {
  HalfEdgeId found;
  for_each_outgoing(mesh_, outgoing(from), [&](HalfEdgeId h) {
    if (mesh_.target(h) == to) found = h;
    if (mesh_.apex(h) == to && mesh_.is_boundary(TriangleMesh::prev(h)))
      found = TriangleMesh::prev(h);
  });
  return found;
}

// ---- Locking: the triangles that the segment crosses make way. ----

bool ConstrainedTriangulation::lock(VertexId owner, VertexId to) {
  if (!bring_in(owner, to)) return false;
  write(Field::partner, owner, to);
  return true;
}

bool ConstrainedTriangulation::lock_for_good(VertexId a, VertexId b) {
  if (!bring_in(a, b)) return false;
  for_good_.insert(std::minmax<Index>(a, b));
  commit();
  return true;
}

/// Makes the segment an edge; false, and nothing changed, if it would cross a locked one.
bool ConstrainedTriangulation::bring_in(VertexId from, VertexId to) {
  cavity_.clear();
  hull_was_original_ = true;
  return find_edge(from, to).valid() || cross_out(from, to);
}

/// Removes the crossed triangles and triangulates both sides of the segment.
bool ConstrainedTriangulation::cross_out(VertexId from, VertexId to) {
  left_.clear();
  right_.clear();
  HalfEdgeId h = first_crossed(mesh_, xy_, outgoing(from), from, to);
  // The left chain runs from the segment's start to its end, the right chain back.
  left_.vertices.push_back(from);
  left_.old_sides.push_back(TriangleMesh::next(h));
  right_.vertices.push_back(from);
  right_.old_sides.push_back(TriangleMesh::prev(h));
  cavity_.push_back(TriangleMesh::triangle(h));
  left_.vertices.push_back(mesh_.target(h));
  right_.vertices.push_back(mesh_.origin(h));
  while (h.valid()) {
    if (is_locked(mesh_.origin(h), mesh_.target(h))) return false;
    const HalfEdgeId across = mesh_.twin(h);
    cavity_.push_back(TriangleMesh::triangle(across));
    const VertexId w = mesh_.apex(across);
    h = next_crossed(mesh_, xy_, h, from, to);
    // `across` runs from left to right; next(across) from right to w, prev(across) from w to left.
    const HalfEdgeId right_side = TriangleMesh::next(across);
    const HalfEdgeId left_side = TriangleMesh::prev(across);
    if (h != left_side) {
      left_.vertices.push_back(w);
      left_.old_sides.push_back(left_side);
    }
    if (h != right_side) {
      right_.vertices.push_back(w);
      right_.old_sides.push_back(right_side);
    }
  }
  std::reverse(right_.vertices.begin(), right_.vertices.end());
  std::reverse(right_.old_sides.begin(), right_.old_sides.end());

  // What lies beyond each side: a half-edge outside, or another side of the cavity where an edge
  // that is not crossed ends inside.
  struct Side {
    HalfEdgeId old_side;
    Index beyond;
    HalfEdgeId* new_side;
  };
  std::vector<Side> sides;
  for (Chain* chain : {&left_, &right_}) {
    chain->new_sides.assign(chain->old_sides.size(), HalfEdgeId());
    for (std::size_t i = 0; i < chain->old_sides.size(); ++i)
      sides.push_back({chain->old_sides[i], mesh_.twin(chain->old_sides[i]), &chain->new_sides[i]});
  }
  for (const TriangleId t : cavity_) hull_was_original_ &= is_original(t);
  cavity_used_ = 0;
  const HalfEdgeId on_left =
      triangulate_beside(left_, 0, static_cast<Index>(left_.vertices.size() - 1));
  const HalfEdgeId on_right =
      triangulate_beside(right_, 0, static_cast<Index>(right_.vertices.size() - 1));
  glue(on_left, on_right);
  for (const Side& side : sides) {
    const auto facing = std::find_if(sides.begin(), sides.end(), [&](const Side& other) {
      return other.old_side == side.beyond;
    });
    glue(*side.new_side, facing == sides.end() ? side.beyond : Index(*facing->new_side));
  }
  for (const TriangleId t : cavity_) keep_outgoing_valid(t);
  return true;
}

/// The paper's greedy triangulation: the chain's vertex that sees the edge from `first` to `last`
/// under the emptiest circle makes a triangle with it, and so on beside the two other edges. The
/// chain lies to the left. Returns the new half-edge from `first` to `last`.
///
/// On the left chain `first` is the segment's start; the chain's vertices are in order along it.
HalfEdgeId ConstrainedTriangulation::triangulate_beside(Chain& chain, Index first, Index last) {
  const VertexId a = chain.vertices[first], b = chain.vertices[last];
  const auto best = static_cast<Index>(emptiest(xy_, chain.vertices, first, last));
  const TriangleId t = cavity_[cavity_used_++];
  set_triangle(t, a, b, chain.vertices[best]);
  const HalfEdgeId base = TriangleMesh::halfedge(t);
  const HalfEdgeId from_best = TriangleMesh::prev(base), to_best = TriangleMesh::next(base);
  if (best == first + 1)
    chain.new_sides[first] = from_best;
  else
    glue(from_best, triangulate_beside(chain, first, best));
  if (best + 1 == last)
    chain.new_sides[best] = to_best;
  else
    glue(to_best, triangulate_beside(chain, best, last));
  return base;
}

// ---- Releasing: flips until every edge but the locked ones is Delaunay again. ----

void ConstrainedTriangulation::release(VertexId owner) {
  const VertexId to(partner_[owner]);
  write(Field::partner, owner, kNone);
  restore_delaunay(find_edge(owner, to));
}

void ConstrainedTriangulation::restore_delaunay(HalfEdgeId start) {
  to_check_.assign(1, start);
  while (!to_check_.empty()) {
    const HalfEdgeId h = to_check_.back();
    to_check_.pop_back();
    if (mesh_.is_boundary(h)) continue;
    const VertexId a = mesh_.origin(h), b = mesh_.target(h);
    const VertexId c = mesh_.apex(h), d = mesh_.apex(mesh_.twin(h));
    if (is_locked(a, b) || !in_circle(xy_[a], xy_[b], xy_[c], xy_[d])) continue;
    flip(h);
    const HalfEdgeId diagonal = TriangleMesh::next(h);  // as TriangleMesh::flip leaves it
    const HalfEdgeId other = mesh_.twin(diagonal);
    for (const HalfEdgeId side : {TriangleMesh::next(diagonal), TriangleMesh::prev(diagonal),
                                  TriangleMesh::next(other), TriangleMesh::prev(other)})
      to_check_.push_back(side);
  }
}

/// TriangleMesh::flip, word by word into the log.
void ConstrainedTriangulation::flip(HalfEdgeId h) {
  const HalfEdgeId g = mesh_.twin(h);
  const HalfEdgeId hn = TriangleMesh::next(h), gn = TriangleMesh::next(g);
  const HalfEdgeId outside_bc = mesh_.twin(hn), outside_ad = mesh_.twin(gn);
  const VertexId c = mesh_.apex(h), d = mesh_.apex(g);
  write(Field::origin, hn, d);
  write(Field::origin, gn, c);
  glue(h, outside_ad);
  glue(g, outside_bc);
  glue(hn, gn);
  keep_outgoing_valid(TriangleMesh::triangle(h));
  keep_outgoing_valid(TriangleMesh::triangle(g));
}

}  // namespace hodt
