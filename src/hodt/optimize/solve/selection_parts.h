// Problems of selection that do not depend on each other.
// Tested by tests/optimize/edge_selection_test.cpp.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "hodt/optimize/solve/edge_selection.h"
#include "hodt/optimize/solve/selection_kernel.h"

namespace hodt {

/// Some of the targets and edges, with numbers of their own.
struct SelectionPart {
  SelectionProblem problem;
  std::vector<Index> targets, edges;  // their numbers in the whole
};

/// The part of these targets: the edges that serve them, by the lists that the callables give.
template <class EdgesOf, class Rivals>
SelectionPart part_of(const SelectionProblem& whole, std::vector<Index> targets,
                      const EdgesOf& edges_of, const Rivals& rivals) {
  SelectionPart part{{}, std::move(targets), {}};
  for (const Index t : part.targets)
    for (const Index e : edges_of(t)) part.edges.push_back(e);
  std::sort(part.edges.begin(), part.edges.end());
  part.edges.erase(std::unique(part.edges.begin(), part.edges.end()), part.edges.end());
  const auto number = [&](Index e) {
    return Index(std::lower_bound(part.edges.begin(), part.edges.end(), e) - part.edges.begin());
  };
  std::vector<std::pair<Index, Index>> edges, served, excluded;
  for (Index t = 0; t < part.targets.size(); ++t)
    for (const Index e : edges_of(part.targets[t])) {
      edges.emplace_back(t, number(e));
      served.emplace_back(number(e), t);
    }
  for (Index e = 0; e < part.edges.size(); ++e) {
    part.problem.orders.push_back(whole.orders[part.edges[e]]);
    for (const Index r : rivals(part.edges[e])) excluded.emplace_back(e, number(r));
  }
  part.problem.edges_of = CsrLists(part.targets.size(), edges);
  part.problem.targets_of = CsrLists(part.edges.size(), served);
  part.problem.rivals = CsrLists(part.edges.size(), excluded);
  return part;
}

/// What the kernel leaves falls apart into targets that share edges, or have edges that are rivals.
/// Throws TimeIsUp if the deadline passes.
std::vector<SelectionPart> parts_of(const SelectionProblem& problem, const SelectionKernel& kernel,
                                    const Deadline& deadline);

}  // namespace hodt
