#include "hodt/optimize/remove_extrema.h"

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <vector>

#include "hodt/base/parallel.h"
#include "hodt/optimize/heights.h"
#include "hodt/optimize/ranks.h"
#include "hodt/order/circle_counter.h"
#include "hodt/order/constrained_triangulation.h"
#include "hodt/order/useful_edges.h"

namespace hodt {

namespace {

/// An extremum of the Delaunay triangulation, and the useful edges that would remove it.
struct Target {
  VertexId vertex;
  Extremum kind = Extremum::minimum;
  std::vector<UsefulEdge> edges;  // by order
  Index searched = 0;             // all edges up to this order are known
  bool given_up = false;          // the search for more was too long
};

/// One bit a kind of extremum that a vertex is.
using State = std::uint8_t;

constexpr Index kFirstSearch = 4;         // the order up to which every target's edges are searched
constexpr std::size_t kEffort = 1 << 24;  // questions of a search; orders below 200 take far fewer
constexpr int kAttempts = 4000;           // edges tried to remove one more extremum
constexpr int kExactAttempts = 400'000;   // with the method exact
constexpr int kDepth = 3;                 // how long a chain of displaced edges may grow
constexpr int kExactDepth = 6;

class Remover {
 public:
  explicit Remover(const ExtremaProblem& problem)
      : problem_(problem),
        graph_(problem.graph),
        heights_{problem.graph.xy, problem.z},
        triangulation_(problem.graph),
        counter_(problem.graph),
        search_(problem.graph),
        state_(problem.graph.xy.size()),
        target_of_(problem.graph.xy.size(), kNone) {}

  ExtremaSolution run();

 private:
  void tell(std::string_view phase, double fraction) const {
    if (problem_.progress) problem_.progress(phase, fraction);
  }
  void find_targets();
  void find_edges();
  bool needs_search(const Target& target) const {
    return target.searched < problem_.order && !target.given_up;
  }
  void search_up_to(UsefulEdgeSearch& search, Target& target, Index order) const;
  std::size_t without_edges(std::size_t delaunay_targets) const;
  void greedy();
  void improve();

  bool is_extremum(VertexId v, Extremum kind) const;
  State state_of(VertexId v) const;
  bool is_kept(VertexId v) const { return !problem_.keep.empty() && problem_.keep[v]; }
  bool still_there(const Target& target) const { return state_[target.vertex] & bit(target.kind); }
  bool orders_hold(ConstrainedTriangulation::Moment since);
  bool accept_if_better(ConstrainedTriangulation::Moment since);
  bool resolve(Index target, int depth, int& attempts);
  bool make_room(VertexId vertex, VertexId to, int depth, std::vector<VertexId>& displaced);

  const ExtremaProblem& problem_;
  const DelaunayGraph& graph_;
  const Heights heights_;
  ConstrainedTriangulation triangulation_;
  CircleCounter counter_;
  UsefulEdgeSearch search_;
  Buffer<State> state_;      // of every vertex in the triangulation as accepted
  Buffer<Index> target_of_;  // the target that a vertex is, or kNone
  std::vector<Target> targets_;
  std::vector<VertexId> frozen_;  // owners whose edges the chain at hand must not displace
  std::vector<TriangleId> changed_;
  std::vector<VertexId> corners_;
};

ExtremaSolution Remover::run() {
  find_targets();
  const std::size_t before = targets_.size();
  tell("useful edges", -1);
  find_edges();
  tell("independent hulls", -1);
  greedy();
  if (problem_.method != Method::greedy) improve();
  const std::size_t bound = without_edges(before);
  std::size_t after = 0;
  for (const State s : state_) after += (s & 1) + (s >> 1);
  return {.mesh = std::move(triangulation_).take_mesh(),
          .delaunay = before,
          .result = after,
          .bound = bound};
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

void Remover::find_targets() {
  const Buffer<Ranks> ranks = ranks_of(graph_.mesh, heights_);
  for (Index i = 0; i < state_.size(); ++i) {
    state_[i] = 0;
    if (counts_minima(problem_.objective) && ranks[i].is_extremum(Extremum::minimum))
      state_[i] |= bit(Extremum::minimum);
    if (counts_maxima(problem_.objective) && ranks[i].is_extremum(Extremum::maximum))
      state_[i] |= bit(Extremum::maximum);
  }
  for (Index i = 0; i < state_.size(); ++i)
    for (const Extremum kind : kExtrema)
      if (state_[i] & bit(kind)) {
        target_of_[i] = Index(targets_.size());
        targets_.push_back({.vertex = VertexId(i), .kind = kind, .edges = {}, .searched = 0});
      }
}

/// Finds for every target the edges of the smallest orders: most need no more than these, and small
/// orders are cheap to search. Larger orders only for those that found none, level by level, so
/// that a deadline finds the cheap ones done. The lowest vertex of all has none, and is not
/// searched, nor are minima to be kept.
void Remover::find_edges() {
  VertexId lowest(0), highest(0);
  for (Index i = 1; i < state_.size(); ++i) {
    if (heights_.lower(VertexId(i), lowest)) lowest = VertexId(i);
    if (heights_.lower(highest, VertexId(i))) highest = VertexId(i);
  }
  const auto hopeless = [&](const Target& t) {
    return t.vertex == (t.kind == Extremum::minimum ? lowest : highest) ||
           (t.kind == Extremum::minimum && is_kept(t.vertex));
  };
  for (Target& target : targets_)
    if (hopeless(target)) target.searched = problem_.order;

  PerThread<UsefulEdgeSearch> searches([&] { return UsefulEdgeSearch(graph_); });
  for (std::uint64_t order = kFirstSearch;; order = 4 * order) {
    const Index level = Index(std::min<std::uint64_t>(order, problem_.order));
    parallel_for(0, targets_.size(), 64, [&](std::size_t first, std::size_t last) {
      UsefulEdgeSearch& search = searches.mine();
      for (std::size_t i = first; i < last; ++i)
        if (targets_[i].edges.empty() && needs_search(targets_[i]) && !problem_.deadline.passed())
          search_up_to(search, targets_[i], level);
    });
    if (level == problem_.order) break;
  }
}

void Remover::search_up_to(UsefulEdgeSearch& search, Target& target, Index order) const {
  const auto wanted = [&](VertexId v) { return heights_.removes(v, target.vertex, target.kind); };
  search.limit_effort(kEffort);
  const auto& found = search.from(target.vertex, order, wanted);
  if (!search.complete()) {
    target.given_up = true;
    return;
  }
  target.searched = order;
  target.edges.clear();
  // Delaunay edges are of no help to an extremum of the Delaunay triangulation, only to one that
  // another edge brought about.
  graph_.for_each_neighbour(target.vertex, [&](VertexId v) {
    if (wanted(v)) target.edges.push_back({v, 0});
  });
  target.edges.insert(target.edges.end(), found.begin(), found.end());
}

/// The lower bound: an extremum of the Delaunay triangulation that no useful edge removes stays,
/// whatever is chosen. (Extrema that an optimizer's choice brought about do not count.)
std::size_t Remover::without_edges(std::size_t delaunay_targets) const {
  const auto stays = [&](const Target& target) {
    return target.edges.empty() && target.searched >= problem_.order;
  };
  return static_cast<std::size_t>(
      std::count_if(targets_.begin(), targets_.begin() + std::ptrdiff_t(delaunay_targets), stays));
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
    if (!still_there(target)) continue;
    const auto before = triangulation_.now();
    const bool fits = triangulation_.lock(target.vertex, c.to) &&
                      triangulation_.last_hull_was_original() && accept_if_better(before);
    if (!fits) triangulation_.roll_back(before);
  }
}

/// Whether every triangle changed since then has order k at most.
bool Remover::orders_hold(ConstrainedTriangulation::Moment since) {
  triangulation_.changed_since(since, changed_);
  return std::all_of(changed_.begin(), changed_.end(), [&](TriangleId t) {
    if (triangulation_.is_original(t)) return true;
    const auto [a, b, c] = triangulation_.mesh().corners(t);
    return counter_.count(a, b, c, problem_.order) <= problem_.order;
  });
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
    if (is_kept(v) && (state_[v] & ~state & bit(Extremum::minimum))) return false;
    gained += size(state_[v]) - size(state);
  }
  if (gained <= 0) return false;
  for (const VertexId v : corners_) {
    state_[v] = state_of(v);
    for (const Extremum kind : kExtrema)
      if ((state_[v] & bit(kind)) && target_of_[v] == kNone) {  // a new extremum, seldom
        target_of_[v] = Index(targets_.size());
        targets_.push_back({.vertex = v, .kind = kind, .edges = {}, .searched = 0});
      }
  }
  triangulation_.commit();
  return true;
}

/// Removes what the greedy pass left, also where hulls meet: the orders are counted again, and
/// edges chosen before make room if their owners find others.
void Remover::improve() {
  for (bool progress = true; progress;) {
    progress = false;
    for (Index i = 0; i < targets_.size(); ++i) {
      if (problem_.deadline.passed()) return;
      if (!still_there(targets_[i])) continue;
      tell("search", double(i) / double(targets_.size()));
      if (needs_search(targets_[i])) search_up_to(search_, targets_[i], problem_.order);
      const bool exact = problem_.method == Method::exact;
      int attempts = exact ? kExactAttempts : kAttempts;
      for (int depth = 0; depth <= (exact ? kExactDepth : kDepth) && still_there(targets_[i]);
           ++depth) {
        const auto before = triangulation_.now();
        if (resolve(i, depth, attempts) && orders_hold(before) && accept_if_better(before))
          progress = true;
        else
          triangulation_.roll_back(before);
      }
    }
  }
}

/// Locks some edge that removes the target, after releasing those in its way, and finds new edges
/// for their owners in turn, `depth` times at most. If that fails nothing has changed.
bool Remover::resolve(Index index, int depth, int& attempts) {
  if (needs_search(targets_[index])) search_up_to(search_, targets_[index], problem_.order);
  const VertexId vertex = targets_[index].vertex;
  std::vector<VertexId> displaced;
  for (std::size_t i = 0; i < targets_[index].edges.size(); ++i) {
    if (attempts-- <= 0 || problem_.deadline.passed()) return false;
    const VertexId to = targets_[index].edges[i].to;
    const auto before = triangulation_.now();
    bool works = make_room(vertex, to, depth, displaced);
    frozen_.push_back(vertex);
    for (const VertexId owner : displaced) {
      if (!works) break;
      const Index other = target_of_[owner];
      if (is_extremum(owner, targets_[other].kind)) works = resolve(other, depth - 1, attempts);
    }
    frozen_.pop_back();
    if (works) return true;
    triangulation_.roll_back(before);
  }
  return false;
}

/// Locks the edge with all changed triangles of order k at most, releasing the edges that it
/// crosses or that, together with it, force a higher order. They must be few and not frozen.
bool Remover::make_room(VertexId vertex, VertexId to, int depth, std::vector<VertexId>& displaced) {
  const auto may_go = [&](VertexId owner) {
    return std::find(frozen_.begin(), frozen_.end(), owner) == frozen_.end();
  };
  const auto before = triangulation_.now();
  triangulation_.owners_crossed(vertex, to, displaced);
  if (displaced.size() > std::size_t(depth)) return false;
  if (!std::all_of(displaced.begin(), displaced.end(), may_go)) return false;
  for (const VertexId owner : displaced) triangulation_.release(owner);
  if (!triangulation_.lock(vertex, to)) return false;
  while (!orders_hold(before)) {
    // The first locked side of a triangle whose order is too high, other than the new edge.
    VertexId culprit;
    for (const TriangleId t : changed_) {
      const auto [a, b, c] = triangulation_.mesh().corners(t);
      if (counter_.count(a, b, c, problem_.order) <= problem_.order) continue;
      for (const VertexId v : {a, b, c})
        if (v != vertex && !culprit.valid() && triangulation_.owns_locked_edge(v) && may_go(v))
          culprit = v;
    }
    if (!culprit.valid() || displaced.size() == std::size_t(depth)) return false;
    displaced.push_back(culprit);
    triangulation_.release(culprit);
  }
  return true;
}

}  // namespace

ExtremaSolution remove_extrema(const ExtremaProblem& problem) {
  return Remover(problem).run();
}

}  // namespace hodt
