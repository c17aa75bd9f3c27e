// A triangulation with chosen edges, and Delaunay apart from them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "hodt/order/delaunay_graph.h"

namespace hodt {

/// The constrained Delaunay triangulation of the points with a set of locked edges, under change:
/// edges are locked and released one by one, and a series of changes can be taken back. It starts
/// as the Delaunay triangulation. Locking one useful edge gives exactly the paper's greedy
/// triangulation of its hull.
///
/// Each locked edge belongs to one of its ends, its owner, and a vertex owns at most one; or it is
/// locked for good, as walls are from the start.
class ConstrainedTriangulation {
 public:
  explicit ConstrainedTriangulation(const DelaunayGraph& delaunay);

  const TriangleMesh& mesh() const { return mesh_; }
  TriangleMesh take_mesh() && { return std::move(mesh_); }

  /// Locks the edge from owner to `to`, which becomes an edge of the triangulation. If it would
  /// cross a locked edge, nothing changes and the result is false. Requires that the owner has no
  /// locked edge and that no vertex lies on the segment.
  bool lock(VertexId owner, VertexId to);

  /// Locks an edge that nobody owns, for good: it is not released, and undoing what was done before
  /// is no longer possible. Otherwise as lock(); any number of them may end at a vertex.
  bool lock_for_good(VertexId a, VertexId b);

  /// Whether the hull of the edge that was locked last consisted of Delaunay triangles in their
  /// place. Then no new triangle has an order above the edge's useful order (Lemma 4).
  bool last_hull_was_original() const { return hull_was_original_; }

  /// Releases the owner's locked edge; what is around becomes Delaunay again.
  void release(VertexId owner);

  bool owns_locked_edge(VertexId v) const { return partner_[v] != kNone; }
  /// The other end of the edge that v owns, or kNone.
  VertexId partner(VertexId v) const { return VertexId(partner_[v]); }
  bool is_locked(VertexId a, VertexId b) const {
    return partner_[a] == b || partner_[b] == a || delaunay_.is_wall(a, b) ||
           (!for_good_.empty() && for_good_.contains(std::minmax<Index>(a, b)));
  }

  /// Whether triangle t is in the place and shape that it has in the Delaunay triangulation.
  bool is_original(TriangleId t) const;

  template <class F>
  void for_each_neighbour(VertexId v, const F& f) const {
    hodt::for_each_neighbour(mesh_, HalfEdgeId(outgoing_[v]), f);
  }
  HalfEdgeId outgoing(VertexId v) const { return HalfEdgeId(outgoing_[v]); }

  /// A moment to go back to.
  using Moment = std::size_t;
  Moment now() const { return log_.size(); }
  /// Undoes every change since the moment.
  void roll_back(Moment moment);
  /// Forgets how to undo: what is done stays.
  void commit() { log_.clear(); }
  /// The triangles changed since the moment, each once, ascending.
  void changed_since(Moment moment, std::vector<TriangleId>& triangles) const;

 private:
  enum class Field : std::uint8_t { origin, twin, outgoing, partner };
  struct Write {
    Field field;
    Index index;
    Index old_value;
  };
  struct Chain;

  Index& cell(Field field, Index index);
  void write(Field field, Index index, Index value);
  void glue(HalfEdgeId a, Index b);
  void set_triangle(TriangleId t, VertexId a, VertexId b, VertexId c);
  void keep_outgoing_valid(TriangleId t);
  HalfEdgeId find_edge(VertexId from, VertexId to) const;
  bool bring_in(VertexId from, VertexId to);
  bool cross_out(VertexId from, VertexId to);
  HalfEdgeId triangulate_beside(Chain& chain, Index first, Index last);
  void flip(HalfEdgeId h);
  void restore_delaunay(HalfEdgeId h);

  const DelaunayGraph& delaunay_;
  std::span<const Point> xy_;
  TriangleMesh mesh_;
  Buffer<Index> outgoing_;  // as outgoing_halfedges gives it
  Buffer<Index> partner_;   // the other end of the edge that a vertex owns, or kNone
  std::set<std::pair<Index, Index>> for_good_;  // locked edges without an owner
  std::vector<Write> log_;

  // Scratch of lock().
  struct Chain {
    std::vector<VertexId> vertices;     // along one side of the segment, both ends included
    std::vector<HalfEdgeId> old_sides;  // edge i joins vertices i and i + 1, inside the cavity
    std::vector<HalfEdgeId> new_sides;  // the same edge in the new triangles
    void clear() {
      vertices.clear();
      old_sides.clear();
    }
  };
  Chain left_, right_;
  std::vector<TriangleId> cavity_;
  std::size_t cavity_used_ = 0;
  bool hull_was_original_ = true;
  std::vector<HalfEdgeId> to_check_;
};

}  // namespace hodt
