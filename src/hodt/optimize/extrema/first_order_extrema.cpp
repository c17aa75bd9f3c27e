#include "hodt/optimize/extrema/first_order_extrema.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "hodt/base/buffer.h"
#include "hodt/base/parallel.h"
#include "hodt/geometry/heights.h"
#include "hodt/optimize/extrema/height_ranks.h"
#include "hodt/order/first_order/first_order.h"

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
      : graph_(graph),
        heights_{graph.xy, z},
        in_s_(graph.xy.size(), 0),
        in_delaunay_(graph.xy.size(), 0),
        removed_(graph.xy.size(), false) {}

  ExtremaSolution run();

 private:
  void find_extrema();
  bool all_flippable(VertexId v, Extremum kind) const;
  void add_quadrilaterals(VertexId v, Extremum kind, std::vector<HalfEdgeId>& found) const;
  void find_quadrilaterals();
  void take_free_diagonals();
  void solve_conflicts();
  VertexId removed_by(VertexId a, VertexId b) const;

  const DelaunayGraph& graph_;
  const Heights heights_;
  Buffer<std::uint8_t> in_s_, in_delaunay_;  // what a vertex is an extremum of: bits
  std::vector<HalfEdgeId> flippable_;        // of the quadrilaterals at extrema of S
  std::vector<Quadrilateral> arcs_;
  std::vector<HalfEdgeId> to_flip_;
  Buffer<bool> removed_;  // an extremum of S that some chosen diagonal removes
};

ExtremaSolution Solver::run() {
  find_extrema();
  find_quadrilaterals();
  take_free_diagonals();
  solve_conflicts();

  ExtremaSolution solution;
  for (Index v = 0; v < in_s_.size(); ++v) {
    solution.delaunay += (in_delaunay_[v] & 1) + (in_delaunay_[v] >> 1);
    solution.result += in_s_[v] != 0 && !removed_[v];
  }
  solution.bound = solution.result;  // Theorem 4: optimal
  std::sort(to_flip_.begin(), to_flip_.end());
  solution.change = MeshChange(std::move(to_flip_));
  return solution;
}

void Solver::find_extrema() {
  const Buffer<HeightRanks> ranks = height_ranks_of(graph_.mesh, heights_);
  parallel_for(0, in_s_.size(), 1 << 13, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const VertexId v{Index(i)};
      for (const Extremum kind : kExtrema) {
        const bool in_delaunay = ranks[v].is_extremum(kind);
        if (in_delaunay) in_delaunay_[v] |= bit(kind);
        // Two edges in one triangle are not both flippable, which settles nearly all vertices
        // without a look at a circle.
        if (in_delaunay || (!ranks[v].two_in_a_triangle(kind) && all_flippable(v, kind)))
          in_s_[v] |= bit(kind);
      }
    }
  });
}

/// Whether every edge that keeps v from being an extremum is flippable.
bool Solver::all_flippable(VertexId v, Extremum kind) const {
  const TriangleMesh& mesh = graph_.mesh;
  HalfEdgeId h = graph_.outgoing[v];
  do {
    if (heights_.removes(mesh.target(h), v, kind) && !is_first_order_flippable(graph_, h))
      return false;
    const HalfEdgeId back = TriangleMesh::prev(h);  // the last edge of a boundary vertex is fixed
    if (mesh.is_boundary(back) && heights_.removes(mesh.origin(back), v, kind)) return false;
    h = mesh.rotate_ccw(h);
  } while (h.valid() && h != graph_.outgoing[v]);
  return true;
}

/// The quadrilaterals where a diagonal removes the extremum v of S: it starts at v, along a
/// flippable edge or across the edge that v sees in one of its triangles.
void Solver::add_quadrilaterals(VertexId v, Extremum kind, std::vector<HalfEdgeId>& found) const {
  const TriangleMesh& mesh = graph_.mesh;
  const auto add = [&](HalfEdgeId h) {
    if (is_first_order_flippable(graph_, h)) found.push_back(std::min(h, mesh.twin(h)));
  };
  for_each_outgoing(mesh, graph_.outgoing[v], [&](HalfEdgeId h) {
    if (heights_.removes(mesh.target(h), v, kind)) add(h);
    const HalfEdgeId opposite = TriangleMesh::next(h);
    if (mesh.is_boundary(opposite)) return;
    if (heights_.removes(mesh.apex(mesh.twin(opposite)), v, kind)) add(opposite);
  });
}

void Solver::find_quadrilaterals() {
  flippable_ = parallel_collect<HalfEdgeId>(
      0, in_s_.size(), 1 << 13,
      [&](std::size_t first, std::size_t last, std::vector<HalfEdgeId>& found) {
        for (std::size_t i = first; i < last; ++i)
          for (const Extremum kind : kExtrema)
            if (in_s_[i] & bit(kind)) add_quadrilaterals(VertexId(Index(i)), kind, found);
      });
  std::sort(flippable_.begin(), flippable_.end());
  flippable_.erase(std::unique(flippable_.begin(), flippable_.end()), flippable_.end());
}

/// The extremum of S that the diagonal ab removes: a minimum that it gives a lower neighbour or a
/// maximum that it gives a higher one. It cannot be both ends: each has the quadrilateral's other
/// two corners as fixed neighbours, a minimum below them and a maximum above.
VertexId Solver::removed_by(VertexId a, VertexId b) const {
  const VertexId low = heights_.lower(a, b) ? a : b, high = low == a ? b : a;
  if (in_s_[high] & bit(Extremum::minimum)) return high;
  if (in_s_[low] & bit(Extremum::maximum)) return low;
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
