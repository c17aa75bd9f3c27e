#include "hodt/optimize/extrema/remove_extrema.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "hodt/optimize/extrema/edge_owners.h"
#include "hodt/optimize/extrema/extrema_targets.h"
#include "hodt/optimize/extrema/extrema_triangulation.h"
#include "hodt/optimize/extrema/independent_hulls.h"
#include "hodt/optimize/extrema/order_repair.h"
#include "hodt/optimize/extrema/removing_edges.h"
#include "hodt/optimize/flip/flips.h"

namespace hodt {

namespace {

// Terrains need two to twelve rounds; the limits are for orders near n.
constexpr int kRounds = 20;
constexpr std::size_t kCrossings = 50'000'000;
// Of select_edges.
constexpr std::size_t kWork = 30'000;
constexpr std::size_t kExactWork = 1'000'000'000;

class Remover {
 public:
  explicit Remover(const ExtremaProblem& problem)
      : problem_(problem),
        graph_(problem.graph),
        heights_{problem.graph.xy, problem.z},
        triangulation_(problem.graph, heights_, problem.objective, problem.keep),
        targets_(problem.graph, heights_, triangulation_.kept(), problem.order, problem.deadline) {}

  ExtremaSolution run();

 private:
  void tell(std::string_view phase) const {
    if (problem_.progress) problem_.progress(phase, -1);
  }
  bool add_extrema();
  std::size_t bound() const { return targets_.hopeless() + without_choice_; }
  ExtremaSolution solution(MeshChange&& change, std::size_t before, std::size_t after) const {
    return {.change = std::move(change), .delaunay = before, .result = after, .bound = bound()};
  }
  ExtremaSolution flipped(std::size_t before);
  void choose();
  bool hold_best_choice(const Deadline& last_steps);
  std::optional<RemovingEdges> select_in_time(std::size_t most_work) const;

  const ExtremaProblem& problem_;
  const DelaunayGraph& graph_;
  const Heights heights_;
  ExtremaTriangulation triangulation_;
  ExtremaTargets targets_;
  std::size_t without_choice_ = 0;  // targets with edges that go without, in any choice
};

ExtremaSolution Remover::run() {
  add_extrema();
  const std::size_t before = targets_.size();
  tell("useful edges");
  targets_.find_edges();
  if (problem_.method == Method::flip) return flipped(before);
  tell("independent hulls");
  insert_independent_hulls(targets_, problem_.deadline, triangulation_);
  if (problem_.method != Method::greedy && triangulation_.extrema() > bound()) {
    TriangleMesh so_far;  // to come back to, should time be up in between
    if (problem_.deadline.is_limited()) so_far = triangulation_.triangulation().mesh();
    const std::size_t after = triangulation_.extrema();
    try {
      choose();
    } catch (const TimeIsUp&) {
      return solution(MeshChange(std::move(so_far)), before, after);
    }
  }
  const std::size_t after = triangulation_.extrema();
  return solution(MeshChange(std::move(triangulation_).take_mesh()), before, after);
}

/// Makes all extrema of the triangulation targets. Whether any was none before.
bool Remover::add_extrema() {
  const std::size_t before = targets_.size();
  for (Index i = 0; i < graph_.xy.size(); ++i)
    for (const Extremum kind : kExtrema)
      if (triangulation_.is_extremum(VertexId(i), kind)) targets_.add(VertexId(i), kind);
  return targets_.size() > before;
}

/// By another heuristic, from the Delaunay triangulation.
ExtremaSolution Remover::flipped(std::size_t before) {
  tell("flips");
  TriangleMesh mesh = graph_.mesh;
  remove_extrema_by_flips(graph_, heights_, problem_.objective, triangulation_.kept(),
                          problem_.order, problem_.deadline, mesh);
  const std::size_t after = count_extrema(extrema_of(mesh, heights_, problem_.objective));
  return solution(MeshChange(std::move(mesh)), before, after);
}

/// The best choice in place of the independent hulls, unless these are better after all.
void Remover::choose() {
  // To make a triangulation of a choice may take a little longer.
  const Deadline last_steps = problem_.deadline.later(0.5);
  const std::size_t before = triangulation_.extrema();
  const Buffer<Index> hulls = triangulation_.partners();
  if (!hold_best_choice(last_steps)) return;
  release_where_order_is_too_high(graph_, problem_.order, last_steps, triangulation_);
  if (triangulation_.extrema() > before || !triangulation_.keeps_all())
    triangulation_.hold(hulls, last_steps);
}

/// The best choice of edges that do not cross, made into a triangulation; where a vertex lost the
/// edge that kept it from being an extremum it becomes a target too, and where targets cannot all
/// be served, their edges of larger orders are asked for, until there is nothing to add. False, and
/// nothing changed, if there was no time for any choice.
bool Remover::hold_best_choice(const Deadline& last_steps) {
  Buffer<Index> least_owners;
  std::size_t least = 2 * graph_.xy.size() + 1;
  const bool exact = problem_.method == Method::exact;
  bool has_news = true;
  std::size_t searched = 0, crossings = 0;  // so far, and with the round to come
  for (int round = 0; has_news && (exact || (round < kRounds && crossings < kCrossings)); ++round) {
    tell("choice of edges");
    const std::optional<RemovingEdges> selected = select_in_time(exact ? kExactWork : kWork);
    if (!selected) break;
    const RemovingEdges& best = *selected;
    without_choice_ = std::max(without_choice_, best.bound);
    // Targets that cannot all be served are offered four times as many edges.
    const double growth = 1 + 3 * double(best.contested.size()) / double(targets_.size());
    searched += best.crossings;
    crossings = searched + std::size_t(growth * growth * double(best.crossings));
    Buffer<Index> owners = edge_owners(graph_.xy.size(), best.chosen);
    triangulation_.hold(owners, last_steps);
    if (triangulation_.extrema() < least) {
      least = triangulation_.extrema();
      least_owners = std::move(owners);
    }
    has_news = targets_.offer_more_edges(best.contested);
    has_news |= add_extrema();
    has_news &= !problem_.deadline.passed();
    targets_.find_edges();
  }
  if (least_owners.empty()) return false;
  if (triangulation_.extrema() > least) triangulation_.hold(least_owners, last_steps);
  return true;
}

std::optional<RemovingEdges> Remover::select_in_time(std::size_t most_work) const {
  try {
    return select_removing_edges(graph_, targets_, problem_.deadline, most_work);
  } catch (const TimeIsUp&) {
    return std::nullopt;
  }
}

}  // namespace

ExtremaSolution remove_extrema(const ExtremaProblem& problem) {
  return Remover(problem).run();
}

}  // namespace hodt
