#include "hodt/optimize/in_order/improve_in_order.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "hodt/geometry/predicates.h"
#include "hodt/optimize/flip/flips_across_edges.h"
#include "hodt/optimize/in_order/exchange.h"
#include "hodt/optimize/in_order/mesh_difference.h"
#include "hodt/optimize/in_order/standing.h"
#include "hodt/order/circle_counter.h"

namespace hodt {

namespace {

constexpr int kMostRounds = 8;

/// Whether its values depend on which edges there are, not on the triangles at them.
bool is_of_degrees(const Objective& objective) {
  return counts_extrema(objective) || objective == Objective::min_max_degree;
}

/// Lets objectives that are of degrees say what may be flipped.
class KeepsValues final : public MoveGuard {
 public:
  explicit KeepsValues(std::span<const std::unique_ptr<Standing>> standings)
      : standings_(standings) {}
  bool allows(std::span<const Flip> move) override {
    const Exchange exchange = exchange_of(move);
    return std::all_of(standings_.begin(), standings_.end(),
                       [&](const auto& standing) { return standing->effect(exchange) <= 0; });
  }
  void take(std::span<const Flip> move) override {
    const Exchange exchange = exchange_of(move);
    for (const auto& standing : standings_) standing->take(exchange);
    any_ = true;
  }
  bool took_any() const { return any_; }

 private:
  /// Only with the edges; some may come and go.
  static Exchange exchange_of(std::span<const Flip> move) {
    Exchange exchange;
    for (const auto& [a, b, c, d] : move) {
      exchange.before.inside.push_back({a, b, c, d});
      exchange.after.inside.push_back({d, c, a, b});
    }
    return exchange;
  }

  const std::span<const std::unique_ptr<Standing>> standings_;
  std::atomic<bool> any_ = false;
};

class Improver {
 public:
  Improver(const OrderedProblem& problem, TriangleMesh& mesh)
      : problem_(problem),
        graph_(problem.graph),
        mesh_(mesh),
        counter_(problem.graph),
        queued_(mesh.halfedge_count(), false) {
    for (const Objective& objective : problem.objectives)
      standings_.push_back(standing_of(objective, graph_.xy, problem.z, problem.kept, mesh));
  }

  void exchange_only(const TriangleMesh& other) { exchange_all(other); }

  void run(const TriangleMesh& other) {
    flip_all();
    for (int round = 0; round < kMostRounds; ++round)
      if (!exchange_all(other) || !flip_all()) return;
  }

 private:
  bool flip_all();
  bool exchange_all(const TriangleMesh& other);
  bool is_wanted();
  void take();
  void push(HalfEdgeId h);
  bool look_at_flip(HalfEdgeId h);
  bool is_in_order(const Exchange::Corners& t) {
    return counter_.count(t[0], t[1], t[2], problem_.order) <= problem_.order;
  }
  void push_around(HalfEdgeId diagonal);

  const OrderedProblem& problem_;
  const DelaunayGraph& graph_;
  TriangleMesh& mesh_;
  CircleCounter counter_;
  std::vector<std::unique_ptr<Standing>> standings_;
  Exchange exchange_;  // that is looked at
  std::vector<bool> queued_;
  std::vector<HalfEdgeId> queue_;
};

/// Whether the objectives agree to the exchange, the first that does not mind leaving the word to
/// the next.
bool Improver::is_wanted() {
  for (std::size_t i = 0; i + 1 < standings_.size(); ++i)
    if (const int effect = standings_[i]->effect(exchange_); effect != 0) return effect < 0;
  return standings_.back()->is_better(exchange_);
}

void Improver::take() {
  for (const auto& standing : standings_) standing->take(exchange_);
}

void Improver::push(HalfEdgeId h) {
  if (mesh_.is_boundary(h) || queued_[h] || queued_[mesh_.twin(h)]) return;
  queued_[h] = true;
  queue_.push_back(h);
}

/// Whether any flip was made. Several at once, where that is known how to.
bool Improver::flip_all() {
  const auto before = problem_.objectives.first(problem_.objectives.size() - 1);
  const Objective& last = problem_.objectives.back();
  if (is_of_edges(last) && std::all_of(before.begin(), before.end(), is_of_degrees)) {
    KeepsValues guard({standings_.data(), before.size()});
    improve_across_edges(graph_, EdgeValues(last, graph_.xy, problem_.z), problem_.order, 3,
                         problem_.deadline, mesh_, &guard);
    return guard.took_any();
  }
  bool any = false;
  for (Index h = 0; h < mesh_.halfedge_count(); ++h) push(HalfEdgeId(h));
  while (!queue_.empty() && !problem_.deadline.passed()) {
    const HalfEdgeId h = queue_.back();
    queue_.pop_back();
    queued_[h] = false;
    // Since it was queued, it may have come to name another edge.
    if (mesh_.is_boundary(h) || !look_at_flip(h) || !is_wanted()) continue;
    if (!is_in_order(exchange_.after.triangles[0]) || !is_in_order(exchange_.after.triangles[1]))
      continue;
    take();
    push_around(mesh_.flip(h));
    any = true;
  }
  return any;
}

/// Flips near a new diagonal can have become better, or worse.
void Improver::push_around(HalfEdgeId diagonal) {
  for (const HalfEdgeId inner : {diagonal, mesh_.twin(diagonal)})
    for (const HalfEdgeId side : {TriangleMesh::next(inner), TriangleMesh::prev(inner)}) {
      push(side);
      if (mesh_.is_boundary(side)) continue;
      push(TriangleMesh::next(mesh_.twin(side)));
      push(TriangleMesh::prev(mesh_.twin(side)));
    }
}

/// Whether the edge can be flipped, but for the order; if so, that is the exchange looked at.
///
///         c                 c
///       /   \             / | \      The sides keep what is beyond them, and get the triangle
///      a --> b    ==>    a  |  b     adc or bcd.
///       \   /             \ | /
///         d                 d
bool Improver::look_at_flip(HalfEdgeId h) {
  const HalfEdgeId twin = mesh_.twin(h);
  const VertexId a = mesh_.origin(h), b = mesh_.target(h);
  const VertexId c = mesh_.apex(h), d = mesh_.apex(twin);
  const auto turn = [&](VertexId u, VertexId v, VertexId w) {
    return orient(graph_.point(u), graph_.point(v), graph_.point(w));
  };
  if (turn(a, d, c) <= 0 || turn(b, c, d) <= 0 || graph_.is_wall(a, b)) return false;
  exchange_.before.triangles = {{a, b, c}, {b, a, d}};
  exchange_.before.inside = {{a, b, c, d}};
  exchange_.before.around.clear();
  exchange_.after.triangles = {{a, d, c}, {b, c, d}};
  exchange_.after.inside = {{d, c, a, b}};
  exchange_.after.around.clear();
  const std::pair<HalfEdgeId, VertexId> sides[] = {{TriangleMesh::next(h), d},
                                                   {TriangleMesh::prev(h), d},
                                                   {TriangleMesh::next(twin), c},
                                                   {TriangleMesh::prev(twin), c}};
  for (const auto& [side, apex] : sides) {
    if (mesh_.is_boundary(side)) continue;
    const VertexId u = mesh_.origin(side), v = mesh_.target(side);
    const VertexId beyond = mesh_.apex(mesh_.twin(side));
    exchange_.before.around.push_back({u, v, mesh_.apex(side), beyond});
    exchange_.after.around.push_back({u, v, apex, beyond});
  }
  return true;
}

/// Whether any region was exchanged. Again as long as one was, as that can let others follow.
bool Improver::exchange_all(const TriangleMesh& other) {
  MeshDifference difference(mesh_, other);
  std::vector<std::size_t> left(difference.size());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = i;
  const std::size_t all = left.size();
  for (bool any = true; any;) {
    std::vector<std::size_t> refused;
    for (const std::size_t region : left) {
      if (problem_.deadline.passed()) return left.size() < all;
      difference.look_at(region, exchange_);
      if (!is_wanted()) {
        refused.push_back(region);
        continue;
      }
      difference.exchange(region, exchange_);
      take();
    }
    any = refused.size() < left.size();
    left = std::move(refused);
  }
  return left.size() < all;
}

}  // namespace

void improve_in_order(const OrderedProblem& problem, const TriangleMesh& other,
                      TriangleMesh& mesh) {
  Improver(problem, mesh).run(other);
}

void exchange_in_order(const OrderedProblem& problem, const TriangleMesh& other,
                       TriangleMesh& mesh) {
  Improver(problem, mesh).exchange_only(other);
}

}  // namespace hodt
