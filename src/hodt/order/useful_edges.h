// Useful edges from a vertex: the edges that some triangulation of order k contains (Lemma 4).
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "hodt/base/deadline.h"
#include "hodt/base/parallel.h"
#include "hodt/order/constrained/wall_walk.h"
#include "hodt/order/first_order/first_order.h"
#include "hodt/order/search/count_past_hubs.h"
#include "hodt/order/search/large_order_search.h"
#include "hodt/order/search/neighbourhood.h"
#include "hodt/order/search/pencil.h"
#include "hodt/order/search/search_policy.h"
#include "hodt/order/search/window_walk.h"

namespace hodt {

/// An edge from a vertex that was asked about, with its useful order.
struct UsefulEdge {
  VertexId to;
  Index order = 0;
};

/// Finds the useful edges of a vertex beyond its Delaunay edges. Holds scratch memory for one
/// thread. docs/design/useful-edges.md tells how it works and why it is exact.
class UsefulEdgeSearch {
 public:
  explicit UsefulEdgeSearch(const DelaunayGraph& graph)
      : graph_(graph), narrow_(graph), around_(graph) {}
  /// Questions about large orders go to a search made for them.
  UsefulEdgeSearch(const DelaunayGraph& graph, const PointTree& tree)
      : graph_(graph),
        tree_(&tree),
        narrow_(graph),
        around_(graph),
        large_(std::in_place, graph, tree) {}

  /// Lets a search give up, and find nothing, after so many questions (one point against another).
  /// complete() then tells. For orders in the hundreds, without a tree.
  void limit_effort(std::size_t questions) { effort_ = questions; }
  bool complete() const { return complete_; }

  /// From then on searches throw TimeIsUp.
  void end_at(const Deadline& deadline) {
    deadline_ = deadline;
    narrow_.end_at(deadline);
    around_.end_at(deadline);
    if (wide_) wide_->end_at(deadline);
    if (widest_) widest_->end_at(deadline);
    if (large_) large_->end_at(deadline);
  }

  /// The scratch memory of a search, for other questions in between.
  Neighbourhood& neighbourhood() { return around_; }

  /// The useful order of uv if it is within the limit and uv is an edge at all (no vertex lies
  /// between its ends); 0 for Delaunay edges. Requires u != v.
  std::optional<Index> useful_order(VertexId u, VertexId v, Index limit);

  /// All edges from u of useful order 1 to `limit` whose other end `wanted` accepts; sorted by
  /// order, then by vertex. The result lives until the next call.
  template <class Wanted>
  const std::vector<UsefulEdge>& from(VertexId u, Index limit, const Wanted& wanted) {
    find(u, limit, wanted, Towards::all);
    std::sort(found_.begin(), found_.end(), [](const UsefulEdge& a, const UsefulEdge& b) {
      return a.order != b.order ? a.order < b.order : a.to < b.to;
    });
    return found_;
  }

  /// The same for the edges to lexicographically larger vertices, not sorted: less than all, and
  /// all in all every edge once.
  const std::vector<UsefulEdge>& to_larger(VertexId u, Index limit) {
    const Point& from = graph_.point(u);
    find(
        u, limit, [&](VertexId v) { return lexicographically_less(from, graph_.point(v)); },
        Towards::larger);
    return found_;
  }

 private:
  template <class Wanted>
  void find(VertexId u, Index limit, const Wanted& wanted, Towards towards) {
    deadline_.check();
    found_.clear();
    complete_ = true;
    if (limit == 0) return;
    if (graph_.has_walls() && limit > 1) return among_walls(u, limit, wanted, towards);
    switch (search_policy::first_way(limit, towards)) {
      case Way::flips:
        return across_one_edge(u, wanted);
      case Way::windows:
        if (!through_windows(u, limit, wanted, towards))
          among_neighbours(u, limit, wanted, effort_);
        return;
      case Way::neighbours:
        return neighbours_first(u, limit, wanted, towards);
      case Way::levels:
        if (large_) return by_large_search(u, limit, wanted);
        return among_neighbours(u, limit, wanted, effort_);
    }
  }

  template <class Wanted>
  void neighbours_first(VertexId u, Index limit, const Wanted& wanted, Towards towards) {
    if (!graph_.is_hub(u)) {
      const std::size_t few = search_policy::few_questions(limit);
      among_neighbours(u, limit, wanted, std::min(effort_, few));
      if (complete_ || effort_ <= few) return;
    }
    complete_ = true;
    if (through_windows(u, limit, wanted, towards)) return;
    if (large_) return by_large_search(u, limit, wanted);
    among_neighbours(u, limit, wanted, effort_);
  }

  /// False, and nothing found, if there is too much around u even for the walk that knows most.
  template <class Wanted>
  bool through_windows(VertexId u, Index limit, const Wanted& wanted, Towards towards) {
    const auto go = [&](Towards half) {
      if (limit <= search_policy::kNarrowWalk && through(narrow_, u, limit, wanted, half))
        return true;
      if (!wide_) wide_.emplace(graph_).end_at(deadline_);
      if (limit <= search_policy::kWideWalk && through(*wide_, u, limit, wanted, half)) return true;
      if (!widest_) widest_.emplace(graph_).end_at(deadline_);
      return through(*widest_, u, limit, wanted, half);
    };
    const bool in_halves = towards == Towards::all && search_policy::in_halves(limit);
    const bool is_done = in_halves ? go(Towards::larger) && go(Towards::smaller) : go(towards);
    if (!is_done) found_.clear();
    return is_done;
  }

  /// False, and nothing more found, if there is too much around u.
  template <class Walk, class Wanted>
  bool through(Walk& walk, VertexId u, Index limit, const Wanted& wanted, Towards towards) {
    const std::size_t before = found_.size();
    walk.begin(u, limit, towards);
    while (walk.find_next()) {
      deadline_.check();
      const VertexId v = walk.candidate();
      const bool is_wanted = wanted(v);
      if (!is_wanted && !search_policy::looks_at_all(limit)) continue;
      Index order = walk.useful_order();
      if (!is_wanted) continue;
      if (order == kNone && !walk.gave_up())
        order = order_past_hubs(u, v, walk.on_left(), walk.on_right(), limit);
      if (order <= limit) found_.push_back({v, order});
    }
    if (walk.gave_up()) found_.resize(before);
    return !walk.gave_up();
  }

  /// Corollary 3: an edge of useful order 1 crosses one Delaunay edge, and is its flip.
  template <class Wanted>
  void across_one_edge(VertexId u, const Wanted& wanted) {
    for_each_outgoing(graph_.mesh, graph_.outgoing[u], [&](HalfEdgeId h) {
      const HalfEdgeId opposite = TriangleMesh::next(h);
      if (graph_.mesh.is_boundary(opposite)) return;
      const VertexId v = graph_.mesh.apex(graph_.mesh.twin(opposite));
      if (wanted(v) && is_first_order_flippable(graph_, opposite)) found_.push_back({v, 1});
    });
  }

  template <class Wanted>
  void among_walls(VertexId u, Index limit, const Wanted& wanted, Towards towards) {
    if (!wall_walk_) wall_walk_.emplace(graph_);
    wall_walk_->end_at(deadline_);
    wall_walk_->from(u, limit, towards, wanted, [&](VertexId v, Index order) {
      found_.push_back({v, order});
    });
  }

  template <class Wanted>
  void by_large_search(VertexId u, Index limit, const Wanted& wanted) {
    large_->from(u, limit, wanted, [&](VertexId v, Index order) { found_.push_back({v, order}); });
  }

  /// Asks the set of neighbours. Finds nothing if gathering it takes more than `effort`.
  template <class Wanted>
  void among_neighbours(VertexId u, Index limit, const Wanted& wanted, std::size_t effort) {
    complete_ = around_.gather(u, limit, effort);
    if (!complete_) return;
    // No branch on what is a matter of chance.
    candidates_.resize(around_.size());
    std::size_t count = 0;
    for (Index i = around_.degree(); i < around_.size(); ++i) {
      candidates_[count] = i;
      count +=
          static_cast<std::size_t>(around_.least_order(i) <= limit && wanted(around_.vertex(i)));
    }
    for (std::size_t c = 0; c < count; ++c) {
      deadline_.check();
      const Index order = around_.pencil().useful_order(candidates_[c], limit);
      if (order <= limit) found_.push_back({around_.vertex(candidates_[c]), order});
    }
  }

  Index order_past_hubs(VertexId u, VertexId v, VertexId left, VertexId right, Index limit) {
    if (!past_hubs_) past_hubs_.emplace(graph_);
    const Index order = past_hubs_->useful_order(u, v, left, right, limit);
    return order != kNone ? order : tree().useful_order(u, v, left, right, limit);
  }

  const PointTree& tree() {
    if (tree_ == nullptr) {
      own_tree_ = std::make_unique<PointTree>(graph_.xy);
      tree_ = own_tree_.get();
    }
    return *tree_;
  }

  const DelaunayGraph& graph_;
  const PointTree* tree_ = nullptr;
  std::unique_ptr<PointTree> own_tree_;  // if it was given none and needs one
  WindowWalk<1> narrow_;
  // When they are asked for.
  std::optional<WindowWalk<4>> wide_;
  std::optional<WindowWalk<16>> widest_;
  std::optional<WallWalk> wall_walk_;
  Neighbourhood around_;
  std::optional<LargeOrderSearch> large_;
  std::optional<CountPastHubs> past_hubs_;  // from the first question on
  std::size_t effort_ = std::numeric_limits<std::size_t>::max();
  bool complete_ = true;
  Deadline deadline_;
  std::vector<UsefulEdge> found_;
  std::vector<Index> candidates_;
};

/// A search for every thread, with a tree if one pays for orders up to `limit`. They throw TimeIsUp
/// if the deadline passes.
class UsefulEdgeSearches {
 public:
  UsefulEdgeSearches(const DelaunayGraph& graph, Index limit, const Deadline& deadline = {});
  UsefulEdgeSearch& mine() {
    UsefulEdgeSearch& search = searches_.mine();
    search.end_at(deadline_);
    return search;
  }

 private:
  const Deadline deadline_;
  std::optional<PointTree> tree_;
  PerThread<UsefulEdgeSearch> searches_;
};

}  // namespace hodt
