#include "hodt/optimize/remove_extrema.h"

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "hodt/base/parallel.h"
#include "hodt/optimize/choose_edges.h"
#include "hodt/optimize/heights.h"
#include "hodt/optimize/ranks.h"
#include "hodt/order/circle_counter.h"
#include "hodt/order/constrained_triangulation.h"
#include "hodt/order/crossings.h"
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
constexpr std::size_t kPrograms = 200;  // for a part of the targets
constexpr std::size_t kExactPrograms = 1'000'000;

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
        known_(problem.graph.xy.size(), 0),
        kept_(problem.graph.xy.size(), false),
        target_of_(problem.graph.xy.size(), kNone) {}

  ExtremaSolution run();

 private:
  void tell(std::string_view phase, double fraction) const {
    if (problem_.progress) problem_.progress(phase, fraction);
  }
  bool add_target(VertexId v, Extremum kind);
  void find_targets();
  void find_edges();
  bool needs_search(const Target& target) const {
    return target.searched < problem_.order && !target.given_up;
  }
  void search_up_to(UsefulEdgeSearch& search, Target& target, Index order) const;
  std::size_t without_edges() const;
  std::size_t extrema() const;
  bool is_proven() const { return extrema() == bound(); }
  std::size_t bound() const { return without_edges() + without_choice_; }
  void greedy();
  void improve();

  void choose();
  struct Candidates;
  Candidates candidates() const;
  Buffer<Index> owners(const Candidates& candidates, const Choice& choice) const;
  bool search_contested(const Candidates& candidates, const Choice& choice);
  bool add_new_extrema();
  void hold(const Buffer<Index>& partners);
  bool release_where_order_is_too_high();
  bool release_side(VertexId a, VertexId b);
  void settle(ConstrainedTriangulation::Moment since);
  bool keeps_all() const;

  bool is_extremum(VertexId v, Extremum kind) const;
  State state_of(VertexId v) const;
  bool is_kept(VertexId v) const { return kept_[v]; }
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
  Buffer<State> known_;      // of every vertex, what it is a target as
  Buffer<bool> kept_;        // a minimum of the Delaunay triangulation that is to stay one
  Buffer<Index> target_of_;  // the first target that a vertex is, or kNone
  std::vector<Target> targets_;
  std::size_t delaunay_targets_ = 0;  // these come first
  std::size_t without_choice_ = 0;    // targets with edges that go without, in any choice
  std::vector<VertexId> frozen_;      // owners whose edges the chain at hand must not displace
  std::vector<TriangleId> changed_;
  std::vector<VertexId> corners_;
};

ExtremaSolution Remover::run() {
  find_targets();
  tell("useful edges", -1);
  find_edges();
  tell("independent hulls", -1);
  greedy();
  if (problem_.method != Method::greedy) {
    if (!is_proven()) choose();
    if (!is_proven()) improve();
  }
  const std::size_t after = extrema(), proven = bound();
  return {.mesh = std::move(triangulation_).take_mesh(),
          .delaunay = delaunay_targets_,
          .result = after,
          .bound = proven};
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

void Remover::find_targets() {
  const Buffer<Ranks> ranks = ranks_of(graph_.mesh, heights_);
  for (Index i = 0; i < state_.size(); ++i) {
    state_[i] = 0;
    if (counts_minima(problem_.objective) && ranks[i].is_extremum(Extremum::minimum))
      state_[i] |= bit(Extremum::minimum);
    if (counts_maxima(problem_.objective) && ranks[i].is_extremum(Extremum::maximum))
      state_[i] |= bit(Extremum::maximum);
  }
  for (Index i = 0; i < problem_.keep.size(); ++i)
    kept_[i] = problem_.keep[i] && ranks[i].is_extremum(Extremum::minimum);
  add_new_extrema();
  delaunay_targets_ = targets_.size();
}

/// False if it is one already.
bool Remover::add_target(VertexId v, Extremum kind) {
  if (known_[v] & bit(kind)) return false;
  known_[v] |= bit(kind);
  if (target_of_[v] == kNone) target_of_[v] = Index(targets_.size());
  targets_.push_back({.vertex = v, .kind = kind, .edges = {}, .searched = 0});
  return true;
}

/// Makes all extrema of the triangulation targets; whether any was none before.
bool Remover::add_new_extrema() {
  const std::size_t before = targets_.size();
  for (Index i = 0; i < state_.size(); ++i)
    for (const Extremum kind : kExtrema)
      if (state_[i] & bit(kind)) add_target(VertexId(i), kind);
  return targets_.size() > before;
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
std::size_t Remover::without_edges() const {
  const auto stays = [&](const Target& target) {
    return target.edges.empty() && target.searched >= problem_.order;
  };
  return static_cast<std::size_t>(
      std::count_if(targets_.begin(), targets_.begin() + std::ptrdiff_t(delaunay_targets_), stays));
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
      if (state_[v] & bit(kind)) add_target(v, kind);  // seldom
  }
  triangulation_.commit();
  return true;
}

/// The edges of all targets, each once.
struct Remover::Candidates {
  std::vector<PlainEdge> edges;
  std::vector<Index> targets;  // those that have edges
  ChoiceProblem problem;
};

Remover::Candidates Remover::candidates() const {
  struct Candidate {
    Index low, high, order, target;
  };
  Candidates all;
  std::vector<Candidate> found;
  for (Index i = 0; i < targets_.size(); ++i) {
    const Target& target = targets_[i];
    const std::size_t before = found.size();
    for (const UsefulEdge& e : target.edges)
      if (!is_kept(e.to) || target.kind == Extremum::minimum || e.order == 0)
        found.push_back({std::min<Index>(target.vertex, e.to), std::max<Index>(target.vertex, e.to),
                         e.order, Index(all.targets.size())});
    if (found.size() > before) all.targets.push_back(i);
  }
  std::sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) {
    return std::tie(a.low, a.high, a.target) < std::tie(b.low, b.high, b.target);
  });
  std::vector<std::pair<Index, Index>> edges_of, targets_of;
  for (const Candidate& c : found) {
    if (all.edges.empty() || all.edges.back().u != c.low || all.edges.back().v != c.high) {
      all.edges.push_back({VertexId(c.low), VertexId(c.high)});
      all.problem.orders.push_back(c.order);
    }
    edges_of.emplace_back(c.target, Index(all.edges.size() - 1));
    targets_of.emplace_back(Index(all.edges.size() - 1), c.target);
  }
  all.problem.edges_of = Lists(all.targets.size(), std::move(edges_of));
  all.problem.targets_of = Lists(all.edges.size(), std::move(targets_of));
  all.problem.rivals = crossings(graph_, all.edges);
  return all;
}

/// The choice of edges that leaves the fewest extrema, as far as it is only crossing that keeps two
/// edges from being chosen. Then the triangulation is made; where a vertex lost the edge that kept
/// it from being an extremum it becomes a target too, and where targets cannot all be served their
/// edges of larger orders are asked for, until there is nothing to add.
void Remover::choose() {
  const std::size_t before = extrema();
  Buffer<Index> partners(state_.size());
  for (Index v = 0; v < partners.size(); ++v) partners[v] = triangulation_.partner(VertexId(v));
  for (bool has_news = true; has_news && !problem_.deadline.passed();) {
    tell("choice of edges", -1);
    const Candidates all = candidates();
    const Choice choice =
        choose_edges(all.problem, problem_.deadline,
                     problem_.method == Method::exact ? kExactPrograms : kPrograms);
    hold(owners(all, choice));
    const bool has_edges = search_contested(all, choice);
    const bool has_targets = add_new_extrema();
    if (has_targets) find_edges();
    has_news = has_edges || has_targets;
    if (has_news) continue;
    for (const Choice::Part& part : choice.contested)
      if (std::none_of(part.targets.begin(), part.targets.end(),
                       [&](Index t) { return targets_[all.targets[t]].searched < problem_.order; }))
        without_choice_ += part.unserved;
  }
  if (!release_where_order_is_too_high() || extrema() > before || !keeps_all()) hold(partners);
}

/// For every vertex the other end of the chosen edge that it owns, or kNone. Each edge is owned by
/// one end, and each vertex owns one edge at most: ends that have no other edge first. (Where edges
/// outnumber their ends, which no terrain is known for, the last ones have no owner and are not
/// locked.) Delaunay edges that nothing crosses need no lock.
Buffer<Index> Remover::owners(const Candidates& candidates, const Choice& choice) const {
  std::vector<std::pair<Index, Index>> ends;
  for (const Index e : choice.edges) {
    if (candidates.problem.orders[e] == 0) continue;
    ends.emplace_back(candidates.edges[e].u, e);
    ends.emplace_back(candidates.edges[e].v, e);
  }
  const Lists edges_at(state_.size(), ends);
  Buffer<Index> partners(state_.size(), kNone), degrees(state_.size());
  for (Index v = 0; v < degrees.size(); ++v) degrees[v] = Index(edges_at[v].size());
  Buffer<bool> is_owned(candidates.edges.size(), false);
  std::vector<Index> leaves;
  const auto own_one = [&](Index v) {
    if (partners[v] != kNone) return;
    for (const Index e : edges_at[v]) {
      if (is_owned[e]) continue;
      const auto [a, b] = candidates.edges[e];
      const VertexId other = a == v ? b : a;
      is_owned[e] = true;
      partners[v] = other;
      --degrees[v];
      if (--degrees[other] == 1) leaves.push_back(other);
      return;
    }
  };
  for (Index v = 0; v < degrees.size(); ++v)
    if (degrees[v] == 1) leaves.push_back(v);
  const auto peel = [&] {
    for (; !leaves.empty();) {
      const Index v = leaves.back();
      leaves.pop_back();
      own_one(v);
    }
  };
  peel();
  for (const auto& [v, e] : ends) {  // what is left goes around
    if (is_owned[e]) continue;
    own_one(v);
    peel();
  }
  return partners;
}

/// Whether more edges were found.
bool Remover::search_contested(const Candidates& candidates, const Choice& choice) {
  std::vector<Index> targets;
  for (const Choice::Part& part : choice.contested)
    for (const Index t : part.targets)
      if (needs_search(targets_[candidates.targets[t]])) targets.push_back(candidates.targets[t]);
  PerThread<UsefulEdgeSearch> searches([&] { return UsefulEdgeSearch(graph_); });
  parallel_for(0, targets.size(), 8, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      if (!problem_.deadline.passed())
        search_up_to(searches.mine(), targets_[targets[i]], problem_.order);
  });
  return !targets.empty();
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

/// Edges that do not cross can force a higher order together. That is rare; false if it takes more
/// than to release sides of the triangles in question.
bool Remover::release_where_order_is_too_high() {
  const auto before = triangulation_.now();
  bool fits = false;
  for (bool released = true; released && !fits;) {
    released = false;
    fits = true;
    for (Index i = 0; i < triangulation_.mesh().triangle_count(); ++i) {
      const TriangleId t(i);
      if (triangulation_.is_original(t)) continue;
      const auto [a, b, c] = triangulation_.mesh().corners(t);
      if (counter_.count(a, b, c, problem_.order) <= problem_.order) continue;
      fits = false;
      released |= release_side(a, b) || release_side(b, c) || release_side(c, a);
    }
  }
  settle(before);
  return fits;
}

bool Remover::release_side(VertexId a, VertexId b) {
  const VertexId owner = triangulation_.partner(a) == b ? a : b;
  if (!triangulation_.is_locked(a, b)) return false;
  triangulation_.release(owner);
  return true;
}

bool Remover::keeps_all() const {
  for (Index v = 0; v < delaunay_targets_; ++v) {
    const Target& target = targets_[v];
    if (target.kind == Extremum::minimum && is_kept(target.vertex) && !still_there(target))
      return false;
  }
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
      if (other == kNone) continue;  // it owned the edge for another
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
