// How many points a circle holds.
#pragma once

#include <array>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "hodt/base/parallel.h"
#include "hodt/base/round_marks.h"
#include "hodt/order/constrained/reachable.h"
#include "hodt/order/delaunay_graph.h"

namespace hodt {

/// A limit that no count exceeds.
inline constexpr Index kUnlimited = kNone - 1;

/// Whether the circle through three vertices (counter-clockwise) holds the origin of h and nothing
/// else. Costs the neighbours of that, for the reason that CircleCounter gives. If there are walls,
/// REQUIRES that the origin is reached from the triangle of the three, through the triangle of h.
bool holds_origin_only(const DelaunayGraph& graph, const std::array<VertexId, 3>& corners,
                       HalfEdgeId h);

/// Counts by searching outward: in the Delaunay graph, the points inside a circle together with
/// any one point on it are connected, and so are they alone. (Lifted to the paraboloid they are the
/// vertices of a convex surface below a plane, and from each of them a path along edges leads ever
/// further below it, to the lowest; the perturbation changes nothing about this.) So a count costs
/// the neighbours of what it finds. If there are walls, only what is reached counts: see
/// order/constrained/reachable.h. Holds scratch memory for one thread.
class CircleCounter {
 public:
  explicit CircleCounter(const DelaunayGraph& graph) : graph_(graph), seen_(graph.xy.size()) {
    if (graph.has_walls()) reachable_.emplace(graph);
  }

  /// The number of points inside the circle through a, b and c (counter-clockwise), or limit + 1 if
  /// there are more than `limit`: the order of the triangle abc.
  /// A vertex that turns out to be inside makes a search from there of it, which is shorter. If
  /// there are walls, REQUIRES that the triangle crosses none.
  Index count(VertexId a, VertexId b, VertexId c, Index limit, VertexId perhaps_inside = {});

  /// The points that the last count found, at most limit + 1 of them.
  std::span<const VertexId> inside() const {
    return reachable_ ? reachable_->inside() : std::span<const VertexId>(inside_);
  }

 private:
  const DelaunayGraph& graph_;
  RoundMarks seen_;
  std::vector<VertexId> inside_;
  std::optional<Reachable> reachable_;  // if there are walls
};

/// holds_origin_only for many circles, also asked about by several threads at once. Where a vertex
/// has very many neighbours, asking all of them each time would take the square of their number:
/// then those of a corner are asked, past such vertices.
class SoleInside {
 public:
  explicit SoleInside(const DelaunayGraph& graph) : graph_(graph) {}

  bool holds_origin_only(const std::array<VertexId, 3>& corners, HalfEdgeId h);

 private:
  CircleCounter& past_hubs();

  const DelaunayGraph& graph_;
  // When the first such vertex is met.
  std::once_flag is_listed_;
  std::optional<DelaunayGraph> listed_;
  std::optional<PerThread<CircleCounter>> counters_;
};

}  // namespace hodt
