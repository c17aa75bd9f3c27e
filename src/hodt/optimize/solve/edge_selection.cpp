#include "hodt/optimize/solve/edge_selection.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "hodt/base/buffer.h"
#include "hodt/base/parallel.h"
#include "hodt/optimize/solve/linear_relaxation.h"
#include "hodt/optimize/solve/selection_kernel.h"
#include "hodt/optimize/solve/selection_parts.h"
#include "hodt/optimize/solve/selection_program.h"

namespace hodt {

namespace {

/// Branches, and shrinks what is left after every branching.
class Search {
 public:
  Search(const Deadline& deadline, std::size_t most_work)
      : deadline_(deadline), work_left_(most_work) {}

  struct Result {
    std::vector<Index> edges;
    std::size_t unserved = 0;  // by these edges
    std::size_t bound = 0;     // by any
  };
  /// The best selection for a problem that neither shrinks nor falls apart.
  Result solve_part(const SelectionProblem& problem);

 private:
  void improve(Result& best, const SelectionProblem& problem);
  Result solve(const SelectionProblem& problem);
  Result solve_with(const SelectionProblem& problem, Index edge);
  Result solve_without(const SelectionProblem& problem, Index edge);
  Result solve_rest(const SelectionProblem& problem, const std::vector<Index>& targets,
                    const Buffer<bool>& is_gone);

  const Deadline& deadline_;
  std::size_t work_left_;
};

Search::Result greedily(const SelectionProblem& problem, const Deadline& deadline) {
  SelectionKernel kernel(problem, deadline);
  kernel.finish_greedily();
  std::vector<Index> served;
  for (const Index e : kernel.taken())
    served.insert(served.end(), problem.targets_of[e].begin(), problem.targets_of[e].end());
  std::sort(served.begin(), served.end());
  served.erase(std::unique(served.begin(), served.end()), served.end());
  return {kernel.taken(), problem.edges_of.size() - served.size(), 0};
}

Search::Result Search::solve(const SelectionProblem& problem) {
  const SelectionKernel kernel(problem, deadline_);
  Result all{kernel.taken(), 0, 0};
  for (const SelectionPart& part : parts_of(problem, kernel, deadline_)) {
    const Result result = solve_part(part.problem);
    for (const Index e : result.edges) all.edges.push_back(part.edges[e]);
    all.unserved += result.unserved;
    all.bound += result.bound;
  }
  return all;
}

Search::Result Search::solve_part(const SelectionProblem& problem) {
  Result best{{}, problem.edges_of.size(), 0};
  try {
    best = greedily(problem, deadline_);
    improve(best, problem);
  } catch (const TimeIsUp&) {  // what there is by then is a selection, and its bound is one
  }
  return best;
}

void Search::improve(Result& best, const SelectionProblem& problem) {
  const std::size_t edges = problem.rivals.size(), variables = edges + problem.edges_of.size();
  std::size_t work = variables;
  for (Index e = 0; e < edges; ++e) work += problem.rivals[e].size() / 2;
  if (work > work_left_ / 4 || deadline_.passed()) return;
  work_left_ -= work;
  std::vector<double> costs(variables, 0);
  std::fill(costs.begin() + std::ptrdiff_t(edges), costs.end(), 1.0);
  LinearRelaxation relaxation(rows_of(problem, deadline_), variables, deadline_);
  relaxation.set_costs(costs);
  relaxation.solve({});
  best.bound = std::size_t(std::max(std::ceil(relaxation.bound()), 0.0));
  if (best.unserved == best.bound) return;

  // The edge that is mostly in; where it is, and where it is not.
  const std::vector<double> values = relaxation.values();
  const auto in = std::max_element(values.begin(), values.begin() + std::ptrdiff_t(edges));
  const auto edge = Index(in - values.begin());
  const Result with = solve_with(problem, edge);
  if (with.unserved < best.unserved) best = {with.edges, with.unserved, best.bound};
  if (best.unserved == best.bound) return;
  const Result without = solve_without(problem, edge);
  if (without.unserved < best.unserved) best = {without.edges, without.unserved, best.bound};
  best.bound = std::max(best.bound, std::min(with.bound, without.bound));
}

Search::Result Search::solve_with(const SelectionProblem& problem, Index edge) {
  Buffer<bool> is_gone(problem.rivals.size(), false);
  is_gone[edge] = true;
  for (const Index rival : problem.rivals[edge]) is_gone[rival] = true;
  std::vector<Index> targets;
  for (Index t = 0; t < problem.edges_of.size(); ++t)
    if (!std::binary_search(problem.targets_of[edge].begin(), problem.targets_of[edge].end(), t))
      targets.push_back(t);
  Result result = solve_rest(problem, targets, is_gone);
  result.edges.push_back(edge);
  return result;
}

Search::Result Search::solve_without(const SelectionProblem& problem, Index edge) {
  Buffer<bool> is_gone(problem.rivals.size(), false);
  is_gone[edge] = true;
  std::vector<Index> targets(problem.edges_of.size());
  std::iota(targets.begin(), targets.end(), Index{0});
  return solve_rest(problem, targets, is_gone);
}

Search::Result Search::solve_rest(const SelectionProblem& problem,
                                  const std::vector<Index>& targets, const Buffer<bool>& is_gone) {
  const auto left = [&](std::span<const Index> edges) {
    std::vector<Index> found;
    for (const Index e : edges)
      if (!is_gone[e]) found.push_back(e);
    return found;
  };
  const auto edges_of = [&](Index t) { return left(problem.edges_of[t]); };
  std::vector<Index> served;
  for (const Index t : targets)
    if (!edges_of(t).empty()) served.push_back(t);
  const std::size_t lost = targets.size() - served.size();
  // Edges that serve none of them take no part.
  Buffer<bool> serves(problem.rivals.size(), false);
  for (const Index t : served)
    for (const Index e : edges_of(t)) serves[e] = true;
  const SelectionPart part = part_of(problem, std::move(served), edges_of, [&](Index e) {
    std::vector<Index> found;
    for (const Index r : left(problem.rivals[e]))
      if (serves[r]) found.push_back(r);
    return found;
  });
  Result result = solve(part.problem);
  for (Index& e : result.edges) e = part.edges[e];
  result.unserved += lost;
  result.bound += lost;
  return result;
}

}  // namespace

Selection select_edges(const SelectionProblem& problem, const Deadline& deadline,
                       std::size_t most_work) {
  const SelectionKernel kernel(problem, deadline);
  std::vector<SelectionPart> parts = parts_of(problem, kernel, deadline);
  std::vector<Search::Result> results(parts.size());
  parallel_for(0, parts.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      results[i] = Search(deadline, most_work).solve_part(parts[i].problem);
  });

  Selection selection{kernel.taken(), {}};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (const Index e : results[i].edges) selection.edges.push_back(parts[i].edges[e]);
    if (results[i].unserved > 0)
      selection.contested.push_back({std::move(parts[i].targets), results[i].bound});
  }
  std::sort(selection.edges.begin(), selection.edges.end());
  return selection;
}

}  // namespace hodt
