#include "hodt/optimize/first_order_extrema.h"

#include <array>
#include <numeric>
#include <vector>

#include "hodt/base/buffer.h"
#include "hodt/optimize/heights.h"
#include "hodt/order/first_order.h"

// S is the subdivision of the fixed edges: triangles and convex quadrilaterals. An extremum of S is
// a vertex that no fixed edge keeps from being one. Either diagonal of a quadrilateral can remove
// extrema of S; by Lemma 7 at most one each, and if both do, they stand against each other: an arc
// of the conflict graph between the two extrema. A diagonal that removes one while the other
// removes none is free to take. What remains is to give every arc to one of its ends so that as
// few ends as possible get none: in a component of the graph without a cycle, and with no extremum
// that a free diagonal removed, one must stay; everywhere else none need to.

namespace hodt {

namespace {

/// A quadrilateral of S and the extremum that each diagonal removes (kNone: none).
struct Quadrilateral {
  HalfEdgeId edge;    // the Delaunay diagonal
  VertexId keeping;   // removed by the Delaunay diagonal
  VertexId flipping;  // removed by the other
};

class Solver {
 public:
  Solver(const DelaunayGraph& graph, std::span<const double> z)
      : graph_(graph), heights_{graph.xy, z}, removed_(graph.xy.size(), false) {}

  ExtremaSolution run();

 private:
  void find_extrema_of_s();
  void find_quadrilaterals();
  void take_free_diagonals();
  void solve_conflicts();
  std::size_t count_extrema(const TriangleMesh& mesh) const;

  void mark_neighbours(const TriangleMesh& mesh, HalfEdgeId h, Buffer<std::uint8_t>& has) const;
  VertexId removed_by(VertexId a, VertexId b) const;

  const DelaunayGraph& graph_;
  const Heights heights_;
  std::vector<HalfEdgeId> flippable_;
  Buffer<std::uint8_t> has_;  // a lower (bit 0), a higher (bit 1) neighbour along a fixed edge
  std::vector<Quadrilateral> arcs_;
  std::vector<HalfEdgeId> to_flip_;
  Buffer<bool> removed_;  // an extremum of S that some chosen diagonal removes
};

constexpr std::uint8_t kLower = 1, kHigher = 2;

ExtremaSolution Solver::run() {
  flippable_ = first_order_edges(graph_);
  find_extrema_of_s();
  take_free_diagonals();
  solve_conflicts();
  ExtremaSolution result;
  result.delaunay = count_extrema(graph_.mesh);
  result.mesh = graph_.mesh;
  for (const HalfEdgeId h : to_flip_) result.mesh.flip(h);
  result.result = result.bound = count_extrema(result.mesh);  // Theorem 4: optimal
  return result;
}

void Solver::mark_neighbours(const TriangleMesh& mesh, HalfEdgeId h,
                             Buffer<std::uint8_t>& has) const {
  const VertexId a = mesh.origin(h), b = mesh.target(h);
  const bool a_lower = heights_.lower(a, b);
  has[a] |= a_lower ? kHigher : kLower;
  has[b] |= a_lower ? kLower : kHigher;
}

std::size_t Solver::count_extrema(const TriangleMesh& mesh) const {
  Buffer<std::uint8_t> has(mesh.vertex_count(), 0);
  for (Index i = 0; i < mesh.halfedge_count(); ++i) mark_neighbours(mesh, HalfEdgeId(i), has);
  std::size_t count = 0;
  for (const std::uint8_t h : has) count += !(h & kLower) + !(h & kHigher);
  return count;
}

void Solver::find_extrema_of_s() {
  const TriangleMesh& mesh = graph_.mesh;
  Buffer<bool> is_flippable(mesh.halfedge_count(), false);
  for (const HalfEdgeId h : flippable_) is_flippable[h] = is_flippable[mesh.twin(h)] = true;
  has_ = Buffer<std::uint8_t>(mesh.vertex_count(), 0);
  for (Index i = 0; i < mesh.halfedge_count(); ++i)
    if (!is_flippable[i]) mark_neighbours(mesh, HalfEdgeId(i), has_);
}

/// The extremum of S that the edge ab removes: a minimum that it gives a lower neighbour or a
/// maximum that it gives a higher one. It cannot be both ends: each has the quadrilateral's other
/// two corners as fixed neighbours, a minimum below them and a maximum above.
VertexId Solver::removed_by(VertexId a, VertexId b) const {
  const VertexId low = heights_.lower(a, b) ? a : b, high = low == a ? b : a;
  if (!(has_[high] & kLower)) return high;
  if (!(has_[low] & kHigher)) return low;
  return {};
}

void Solver::take_free_diagonals() {
  const TriangleMesh& mesh = graph_.mesh;
  for (const HalfEdgeId h : flippable_) {
    const Quadrilateral q = {
        .edge = h,
        .keeping = removed_by(mesh.origin(h), mesh.target(h)),
        .flipping = removed_by(mesh.apex(h), mesh.apex(mesh.twin(h))),
    };
    if (q.keeping.valid() && q.flipping.valid())
      arcs_.push_back(q);
    else if (q.keeping.valid())
      removed_[q.keeping] = true;
    else if (q.flipping.valid() && !removed_[q.flipping]) {
      removed_[q.flipping] = true;
      to_flip_.push_back(h);
    }
  }
}

/// Gives every arc to one of its ends, from the extrema outwards that are removed already: an arc
/// from a removed extremum serves its other end. A component without any such extremum starts at
/// an arc that closes a cycle, or gives up its first extremum.
void Solver::solve_conflicts() {
  // The arcs at each extremum, as lists in one array.
  const std::size_t n = graph_.xy.size();
  Buffer<Index> first(n + 1, 0);
  for (const Quadrilateral& q : arcs_) ++first[q.keeping + 1], ++first[q.flipping + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<Index> incident(2 * arcs_.size());
  Buffer<Index> place = first;
  for (Index i = 0; i < arcs_.size(); ++i) {
    incident[place[arcs_[i].keeping]++] = i;
    incident[place[arcs_[i].flipping]++] = i;
  }

  std::vector<bool> used(arcs_.size(), false);
  std::vector<VertexId> reached;
  const auto give = [&](Index arc, VertexId to) {
    used[arc] = true;
    removed_[to] = true;
    if (arcs_[arc].flipping == to) to_flip_.push_back(arcs_[arc].edge);
    reached.push_back(to);
  };
  const auto spread = [&] {
    while (!reached.empty()) {
      const VertexId v = reached.back();
      reached.pop_back();
      for (Index i = first[v]; i < first[v + 1]; ++i) {
        const Index arc = incident[i];
        const VertexId other = arcs_[arc].keeping == v ? arcs_[arc].flipping : arcs_[arc].keeping;
        if (!used[arc] && !removed_[other]) give(arc, other);
      }
    }
  };

  for (const Quadrilateral& q : arcs_)
    for (const VertexId v : {q.keeping, q.flipping})
      if (removed_[v]) reached.push_back(v);
  spread();

  // What is left are components with nothing removed. An arc that joins what is joined already
  // closes a cycle.
  std::vector<Index> parent(n);
  std::iota(parent.begin(), parent.end(), Index{0});
  const auto root = [&](Index v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  std::vector<Index> closing;
  for (Index i = 0; i < arcs_.size(); ++i) {
    if (removed_[arcs_[i].keeping]) continue;
    const Index a = root(arcs_[i].keeping), b = root(arcs_[i].flipping);
    if (a == b)
      closing.push_back(i);
    else
      parent[a] = b;
  }
  for (const Index arc : closing) {
    if (removed_[arcs_[arc].keeping] || removed_[arcs_[arc].flipping]) continue;
    give(arc, arcs_[arc].keeping);
    spread();
  }
  // Trees: the first extremum of each stays, and its arcs serve the others.
  for (const Quadrilateral& q : arcs_) {
    if (removed_[q.keeping] || removed_[q.flipping]) continue;
    reached.push_back(q.keeping);
    spread();
  }
}

}  // namespace

ExtremaSolution minimize_first_order_extrema(const DelaunayGraph& graph,
                                             std::span<const double> z) {
  return Solver(graph, z).run();
}

}  // namespace hodt
