#include "hodt/optimize/extrema/remove_extrema.h"

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "hodt/geometry/heights.h"
#include "hodt/optimize/extrema/edge_owners.h"
#include "hodt/optimize/extrema/extrema_targets.h"
#include "hodt/optimize/extrema/ranks.h"
#include "hodt/optimize/extrema/removing_edges.h"
#include "hodt/optimize/flip/flips.h"
#include "hodt/order/circle_counter.h"
#include "hodt/order/constrained/constrained_triangulation.h"

namespace hodt {

namespace {

/// One bit a kind of extremum that a vertex is.
using State = std::uint8_t;

// Terrains need two to twelve rounds; the limits are for orders near n.
constexpr int kRounds = 20;
constexpr std::size_t kCrossings = 50'000'000;
// Of choose_edges.
constexpr std::size_t kWork = 30'000;
constexpr std::size_t kExactWork = 1'000'000'000;

class Remover {
 public:
  explicit Remover(const ExtremaProblem& problem)
      : problem_(problem),
        graph_(problem.graph),
        heights_{problem.graph.xy, problem.z},
        triangulation_(problem.graph),
        counter_(problem.graph),
        state_(problem.graph.xy.size()),
        kept_(problem.graph.xy.size(), false),
        targets_(problem.graph, heights_, kept_, problem.order, problem.deadline) {}

  ExtremaSolution run();

 private:
  void tell(std::string_view phase) const {
    if (problem_.progress) problem_.progress(phase, -1);
  }
  void find_extrema(const TriangleMesh& mesh);
  bool add_extrema();
  std::size_t extrema() const;
  std::size_t bound() const;

  ExtremaSolution flipped(std::size_t before);
  void greedy();
  bool accept_if_better(ConstrainedTriangulation::Moment since);
  void choose();
  void hold(const Buffer<Index>& partners);
  void settle(ConstrainedTriangulation::Moment since);
  void release_where_order_is_too_high();
  void release_nearest(TriangleId t);
  bool keeps_all() const;

  bool is_extremum(VertexId v, Extremum kind) const;
  State state_of(VertexId v) const;

  const ExtremaProblem& problem_;
  const DelaunayGraph& graph_;
  const Heights heights_;
  ConstrainedTriangulation triangulation_;
  CircleCounter counter_;
  Buffer<State> state_;  // of every vertex in the triangulation as accepted
  Buffer<bool> kept_;    // a minimum of the Delaunay triangulation that is to stay one
  ExtremaTargets targets_;
  std::size_t without_choice_ = 0;  // targets with edges that go without, in any choice
  std::vector<TriangleId> changed_;
  std::vector<VertexId> corners_;
};

ExtremaSolution Remover::run() {
  find_extrema(graph_.mesh);
  for (Index i = 0; i < problem_.keep.size(); ++i)
    kept_[i] = problem_.keep[i] && (state_[i] & bit(Extremum::minimum));
  add_extrema();
  const std::size_t before = targets_.size();
  tell("useful edges");
  targets_.find_edges();
  if (problem_.method == Method::flip) return flipped(before);
  tell("independent hulls");
  greedy();
  if (problem_.method != Method::greedy && extrema() > bound()) choose();
  const std::size_t after = extrema(), proven = bound();
  return {.change = MeshChange(std::move(triangulation_).take_mesh()),
          .delaunay = before,
          .result = after,
          .bound = proven};
}

/// By another heuristic, from the Delaunay triangulation.
ExtremaSolution Remover::flipped(std::size_t before) {
  tell("flips");
  TriangleMesh mesh = graph_.mesh;
  remove_extrema_by_flips(graph_, heights_, problem_.objective, kept_, problem_.order,
                          problem_.deadline, mesh);
  find_extrema(mesh);
  return {.change = MeshChange(std::move(mesh)),
          .delaunay = before,
          .result = extrema(),
          .bound = bound()};
}

std::size_t Remover::extrema() const {
  std::size_t count = 0;
  for (const State s : state_) count += (s & 1) + (s >> 1);
  return count;
}

bool Remover::is_extremum(VertexId v, Extremum kind) const {
  HalfEdgeId h = triangulation_.outgoing(v);
  const HalfEdgeId start = h;
  const TriangleMesh& mesh = triangulation_.mesh();
  for (;;) {
    if (heights_.removes(mesh.target(h), v, kind)) return false;
    const HalfEdgeId following = mesh.rotate_ccw(h);
    if (following == start) return true;
    if (!following.valid()) return !heights_.removes(mesh.apex(h), v, kind);
    h = following;
  }
}

State Remover::state_of(VertexId v) const {
  State state = 0;
  if (counts_minima(problem_.objective) && is_extremum(v, Extremum::minimum))
    state |= bit(Extremum::minimum);
  if (counts_maxima(problem_.objective) && is_extremum(v, Extremum::maximum))
    state |= bit(Extremum::maximum);
  return state;
}

void Remover::find_extrema(const TriangleMesh& mesh) {
  const Buffer<Ranks> ranks = ranks_of(mesh, heights_);
  for (Index i = 0; i < state_.size(); ++i) {
    state_[i] = 0;
    if (counts_minima(problem_.objective) && ranks[i].is_extremum(Extremum::minimum))
      state_[i] |= bit(Extremum::minimum);
    if (counts_maxima(problem_.objective) && ranks[i].is_extremum(Extremum::maximum))
      state_[i] |= bit(Extremum::maximum);
  }
}

/// Makes all extrema of the triangulation targets. Whether any was none before.
bool Remover::add_extrema() {
  const std::size_t before = targets_.size();
  for (Index i = 0; i < state_.size(); ++i)
    for (const Extremum kind : kExtrema)
      if (state_[i] & bit(kind)) targets_.add(VertexId(i), kind);
  return targets_.size() > before;
}

/// An extremum that no useful edge removes stays, whatever is chosen; and of the others, so many as
/// no choice can do without.
std::size_t Remover::bound() const {
  std::size_t hopeless = 0;
  for (Index i = 0; i < targets_.size(); ++i) hopeless += targets_.is_hopeless(targets_[i]);
  return hopeless + without_choice_;
}

/// Theorem 8: independent hulls, by fixed priority: the order of the edge, then its vertices.
void Remover::greedy() {
  struct Candidate {
    Index order, target;
    VertexId to;
  };
  std::vector<Candidate> candidates;
  for (Index i = 0; i < targets_.size(); ++i)
    for (const UsefulEdge& edge : targets_[i].edges) candidates.push_back({edge.order, i, edge.to});
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.order < b.order; });
  for (const Candidate& c : candidates) {
    const Target& target = targets_[c.target];
    if (!(state_[target.vertex] & bit(target.kind))) continue;
    const auto before = triangulation_.now();
    const bool fits = triangulation_.lock(target.vertex, c.to) &&
                      triangulation_.last_hull_was_original() && accept_if_better(before);
    if (!fits) triangulation_.roll_back(before);
  }
}

/// Keeps the changes since then if they leave fewer extrema: net, because a vertex can lose its
/// only lower neighbour to an edge that helps another.
bool Remover::accept_if_better(ConstrainedTriangulation::Moment since) {
  triangulation_.changed_since(since, changed_);
  corners_.clear();
  for (const TriangleId t : changed_)
    for (const VertexId v : triangulation_.mesh().corners(t)) corners_.push_back(v);
  std::sort(corners_.begin(), corners_.end());
  corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());

  const auto size = [](State s) { return (s & 1) + (s >> 1); };
  int gained = 0;
  for (const VertexId v : corners_) {
    const State state = state_of(v);
    if (kept_[v] && (state_[v] & ~state & bit(Extremum::minimum))) return false;
    gained += size(state_[v]) - size(state);
  }
  if (gained <= 0) return false;
  for (const VertexId v : corners_) state_[v] = state_of(v);
  triangulation_.commit();
  return true;
}

/// The best choice of edges that do not cross, made into a triangulation; where a vertex lost the
/// edge that kept it from being an extremum it becomes a target too, and where targets cannot all
/// be served, their edges of larger orders are asked for, until there is nothing to add.
void Remover::choose() {
  const std::size_t before = extrema();
  Buffer<Index> greedy(state_.size());
  for (Index v = 0; v < greedy.size(); ++v) greedy[v] = triangulation_.partner(VertexId(v));
  Buffer<Index> least_owners;
  std::size_t least = state_.size() + 1;
  const bool exact = problem_.method == Method::exact;
  bool has_news = true;
  std::size_t searched = 0, crossings = 0;  // so far, and with the round to come
  for (int round = 0; has_news && (exact || (round < kRounds && crossings < kCrossings)); ++round) {
    tell("choice of edges");
    const RemovingEdges best =
        choose_removing_edges(graph_, targets_, problem_.deadline, exact ? kExactWork : kWork);
    without_choice_ = std::max(without_choice_, best.bound);
    // Targets that cannot all be served are offered four times as many edges.
    const double growth = 1 + 3 * double(best.contested.size()) / double(targets_.size());
    searched += best.crossings;
    crossings = searched + std::size_t(growth * growth * double(best.crossings));
    Buffer<Index> owners = edge_owners(state_.size(), best.chosen);
    hold(owners);
    if (extrema() < least) {
      least = extrema();
      least_owners = std::move(owners);
    }
    has_news = targets_.offer_more_edges(best.contested);
    has_news |= add_extrema();
    has_news &= !problem_.deadline.passed();
    targets_.find_edges();
  }
  if (extrema() > least) hold(least_owners);
  release_where_order_is_too_high();
  if (extrema() > before || !keeps_all()) hold(greedy);
}

/// Makes the locked edges be just these.
void Remover::hold(const Buffer<Index>& partners) {
  const auto before = triangulation_.now();
  for (Index v = 0; v < partners.size(); ++v)
    if (const VertexId u(v);
        triangulation_.owns_locked_edge(u) && triangulation_.partner(u) != partners[v])
      triangulation_.release(u);
  for (Index v = 0; v < partners.size(); ++v)
    if (const VertexId u(v); partners[v] != kNone && !triangulation_.owns_locked_edge(u))
      triangulation_.lock(u, VertexId(partners[v]));
  settle(before);
}

/// Accepts what was changed since.
void Remover::settle(ConstrainedTriangulation::Moment since) {
  triangulation_.changed_since(since, changed_);
  for (const TriangleId t : changed_)
    for (const VertexId v : triangulation_.mesh().corners(t)) state_[v] = state_of(v);
  triangulation_.commit();
}

/// Edges that do not cross can force a higher order together. That is rare: then the one that is
/// nearest to the triangle goes.
void Remover::release_where_order_is_too_high() {
  const auto before = triangulation_.now();
  for (bool released = true; released;) {
    released = false;
    for (Index i = 0; i < triangulation_.mesh().triangle_count(); ++i) {
      const TriangleId t(i);
      if (triangulation_.is_original(t)) continue;
      const auto [a, b, c] = triangulation_.mesh().corners(t);
      if (counter_.count(a, b, c, problem_.order) <= problem_.order) continue;
      release_nearest(t);
      released = true;
    }
  }
  settle(before);
}

/// Of the locked edges, the one fewest triangles away from t. There is one, or else all
/// triangles would be Delaunay.
void Remover::release_nearest(TriangleId t) {
  const TriangleMesh& mesh = triangulation_.mesh();
  std::vector<TriangleId> seen{t};
  for (std::size_t i = 0; i < seen.size(); ++i)
    for (Index side = 0; side < 3; ++side) {
      const HalfEdgeId h(TriangleMesh::halfedge(seen[i]) + side);
      const VertexId a = mesh.origin(h), b = mesh.target(h);
      if (triangulation_.is_locked(a, b))
        return triangulation_.release(triangulation_.partner(a) == b ? a : b);
      if (mesh.is_boundary(h)) continue;
      const TriangleId next = TriangleMesh::triangle(mesh.twin(h));
      if (std::find(seen.begin(), seen.end(), next) == seen.end()) seen.push_back(next);
    }
}

bool Remover::keeps_all() const {
  for (Index v = 0; v < kept_.size(); ++v)
    if (kept_[v] && !(state_[v] & bit(Extremum::minimum))) return false;
  return true;
}

}  // namespace

ExtremaSolution remove_extrema(const ExtremaProblem& problem) {
  return Remover(problem).run();
}

}  // namespace hodt
