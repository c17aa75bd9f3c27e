#include "hodt/optimize/in_order/improve_in_order.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "hodt/optimize/flip/flipper.h"
#include "hodt/optimize/flip/flips_across_edges.h"
#include "hodt/optimize/in_order/exchange.h"
#include "hodt/optimize/in_order/mesh_difference.h"
#include "hodt/optimize/in_order/standing.h"

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
  bool allows(std::span<const Quadrilateral> move) override {
    const Exchange exchange = exchange_of(move);
    return std::all_of(standings_.begin(), standings_.end(),
                       [&](const auto& standing) { return standing->effect(exchange) <= 0; });
  }
  void take(std::span<const Quadrilateral> move) override {
    const Exchange exchange = exchange_of(move);
    for (const auto& standing : standings_) standing->take(exchange);
    any_ = true;
  }
  bool took_any() const { return any_; }

 private:
  /// Only with the edges; some may come and go.
  static Exchange exchange_of(std::span<const Quadrilateral> move) {
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
      : problem_(problem), graph_(problem.graph), mesh_(mesh) {
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
  /// What the flipper asks and tells.
  struct Wanted {
    Improver& improver;
    bool operator()(const TriangleMesh&, HalfEdgeId h, const Quadrilateral& q) {
      improver.look_at_flip(h, q);
      return improver.is_wanted();
    }
    void flipped(const Quadrilateral&) { improver.take(); }
  };

  bool flip_all();
  bool exchange_all(const TriangleMesh& other);
  bool is_wanted();
  void take();
  void look_at_flip(HalfEdgeId h, const Quadrilateral& q);

  const OrderedProblem& problem_;
  const DelaunayGraph& graph_;
  TriangleMesh& mesh_;
  std::vector<std::unique_ptr<Standing>> standings_;
  Exchange exchange_;  // that is looked at
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
  Wanted wanted{*this};
  return Flipper(graph_, problem_.order, wanted, mesh_).run(problem_.deadline);
}

/// Makes a flip the exchange looked at.
///
///         c                 c
///       /   \             / | \      The sides keep what is beyond them, and get the triangle
///      a --> b    ==>    a  |  b     adc or bcd.
///       \   /             \ | /
///         d                 d
void Improver::look_at_flip(HalfEdgeId h, const Quadrilateral& q) {
  const HalfEdgeId twin = mesh_.twin(h);
  const auto& [a, b, c, d] = q;
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
