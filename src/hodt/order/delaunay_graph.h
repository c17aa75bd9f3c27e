// The Delaunay triangulation as the graph that every question about orders is answered on.
// Tested by tests/order/edges_test.cpp.
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <span>
#include <utility>

#include "hodt/base/deadline.h"
#include "hodt/delaunay/delaunay.h"
#include "hodt/geometry/circle.h"
#include "hodt/mesh/triangle_mesh.h"

namespace hodt {

/// For every vertex a half-edge that leaves it, as outgoing_halfedges gives it: made when one is
/// first asked for, as some questions do without.
class OutgoingOnDemand {
 public:
  explicit OutgoingOnDemand(const TriangleMesh& mesh) : state_(std::make_shared<State>(mesh)) {}

  const Buffer<HalfEdgeId>& all() const {
    if (!state_->is_made.load(std::memory_order_acquire)) state_->make();
    return state_->all;
  }
  HalfEdgeId operator[](std::size_t v) const { return all()[v]; }

 private:
  struct State {
    explicit State(const TriangleMesh& m) : mesh(m) {}
    void make();

    const TriangleMesh& mesh;
    std::mutex making;
    std::atomic<bool> is_made = false;
    Buffer<HalfEdgeId> all;
  };
  std::shared_ptr<State> state_;
};

/// A view: the Delaunay triangulation must outlive it and stay as it is. If that has walls, it is a
/// constrained one, and every order is the constrained order: nothing is reached across a wall
/// (docs/definitions.md).
class DelaunayGraph {
 public:
  explicit DelaunayGraph(const Delaunay& delaunay)
      : xy(delaunay.vertices.xy),
        mesh(delaunay.mesh),
        walls(delaunay.walls),
        outgoing(delaunay.mesh) {
    if (has_walls()) find_wall_ends();
  }

  bool has_walls() const { return !walls.empty(); }
  bool is_wall(HalfEdgeId h) const { return has_walls() && walls[h]; }
  /// The same of an edge of any triangulation, by its ends.
  bool is_wall(VertexId a, VertexId b) const {
    return has_walls() && wall_ends_[a] > 0 && wall_ends_[b] > 0 && is_wall_at(a, b);
  }
  /// Whether a wall ends at v, or the boundary passes.
  bool ends_wall(VertexId v) const { return has_walls() && wall_ends_[v] > 0; }
  /// Whether walls part the triangles around v: if so, what is reached at v need not be all of
  /// them.
  bool is_parted(VertexId v) const { return has_walls() && wall_ends_[v] > 1; }
  /// Where a domain touches itself, several vertices are at one place, each for a side of its own:
  /// the first of them. Counts take them for one.
  VertexId place_of(VertexId v) const {
    while (v > 0 && xy[v - 1] == xy[v]) v = VertexId(v - 1);
    return v;
  }

  /// Stores every vertex's neighbours side by side, 28 bytes a point: worth it before questions
  /// about most of the vertices. Finds hubs. Changes no answer.
  /// The deadline ends what is done about hubs early: questions near them can take longer then.
  void list_neighbours(const Deadline& deadline = {});
  /// Does so if some vertex has very many neighbours. For questions about a few of the vertices.
  void list_neighbours_if_hubs(const Deadline& deadline = {});

  const Point& point(VertexId v) const { return xy[v]; }

  /// Calls f(w) for every neighbour w of v, counter-clockwise.
  template <class F>
  void for_each_neighbour(VertexId v, const F& f) const {
    if (lists_.first.empty()) return hodt::for_each_neighbour(mesh, outgoing[v], f);
    lists_.for_each(v, f);
  }

  /// Calls f(w, true) for every neighbour w of v, counter-clockwise, and then, perhaps,
  /// f(any vertex, false): mostly the same number of calls in all, which a processor can foresee,
  /// while degrees are a matter of chance.
  template <class F>
  void for_each_neighbour_and_more(VertexId v, const F& f) const {
    if (lists_.first.empty())
      return hodt::for_each_neighbour(mesh, outgoing[v], [&](VertexId w) { f(w, true); });
    const VertexId* const list = lists_.vertices.data() + lists_.first[v];
    const Index degree = lists_.size(v);
    for (Index i = 0; i < kUsualDegree; ++i) f(list[i], i < degree);
    for (Index i = kUsualDegree; i < degree; ++i) f(list[i], true);
  }

  bool has_edge(VertexId u, VertexId v) const {
    if (has_hubs() && lists_.size(v) < lists_.size(u)) std::swap(u, v);
    bool found = false;
    for_each_neighbour(u, [&](VertexId w) { found |= w == v; });
    return found;
  }

  /// How far away the nearest neighbour is, in the larger of its two coordinates.
  double nearest(VertexId v) const {
    double nearest = std::numeric_limits<double>::infinity();
    for_each_neighbour(v, [&](VertexId w) {
      nearest = std::min(nearest, std::max(std::fabs(point(w).x - point(v).x),
                                           std::fabs(point(w).y - point(v).y)));
    });
    return nearest;
  }

  /// A vertex of so many neighbours that searches had better not go through it. None is known
  /// before list_neighbours().
  bool is_hub(VertexId v) const { return !hub_.empty() && hub_[v]; }
  bool has_hubs() const { return !hub_.empty(); }
  /// That is so in the Delaunay triangulation itself; others are hubs where such are left out.
  bool has_many_neighbours(VertexId v) const { return has_hubs() && lists_.size(v) > kHubDegree; }

  /// Calls f(w) for the vertices to go on to from v in a search for all points inside a circle that
  /// began at `start`, a point on it: a search that goes on from all that it finds inside finds
  /// all. Without hubs these are the neighbours, and so they are if it began at a hub. Otherwise it
  /// goes around the hubs, and never on from one. (Without the hubs' points, too, the points inside
  /// a circle are connected in the Delaunay graph; and a hub inside is a neighbour of another point
  /// inside.)
  template <class F>
  void for_each_onward(VertexId v, VertexId start, const F& f) const {
    if (hub_.empty() || hub_[start]) return for_each_neighbour(v, f);
    onward_.for_each(v, f);
  }

  const std::span<const Point> xy;
  const TriangleMesh& mesh;
  const std::span<const bool> walls;  ///< of every half-edge; empty if there are none
  const OutgoingOnDemand outgoing;

 private:
  /// A list of vertices for every vertex, all in one array.
  struct NeighbourLists {
    Buffer<Index> first;  // where each list begins
    Buffer<VertexId> vertices;

    Index size(VertexId v) const { return first[v + 1] - first[v]; }
    template <class F>
    void for_each(VertexId v, const F& f) const {
      const Index end = first[v + 1];
      const VertexId* const list = vertices.data();
      for (Index i = first[v]; i < end; ++i) f(list[i]);
    }
  };
  void route_around_hubs(const Deadline& deadline);
  void find_wall_ends();
  bool is_wall_at(VertexId a, VertexId b) const;

  /// Random points never have so many neighbours; a search through a vertex that has costs its
  /// degree each time.
  static constexpr Index kHubDegree = 128;

  /// Of random points, 15 of 16 have no more neighbours.
  static constexpr Index kUsualDegree = 8;

  NeighbourLists
      lists_;  // of neighbours, and kUsualDegree more vertices; empty before list_neighbours()
  Buffer<bool> hub_;  // empty if there are none
  // Of every vertex how many walls end there, the boundary counted as one: 2 stands for more.
  Buffer<std::uint8_t> wall_ends_;
  NeighbourLists onward_;  // empty likewise; a hub's list is empty
};

}  // namespace hodt
