#include "hodt/optimize/extrema/removing_edges.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace hodt {

namespace {

/// The edges of all targets, each once.
struct Candidates {
  std::vector<PlainEdge> edges;
  std::vector<Index> targets;  // those that have edges
  SelectionProblem problem;
};

Candidates candidates_of(const DelaunayGraph& graph, const ExtremaTargets& targets,
                         const Deadline& deadline) {
  struct Candidate {
    Index low, high, order, target;
  };
  Candidates all;
  std::vector<Candidate> found;
  for (Index i = 0; i < targets.size(); ++i) {
    const Target& target = targets[i];
    if (target.edges.empty()) continue;
    for (const UsefulEdge& e : targets.offered(target))
      found.push_back({std::min<Index>(target.vertex, e.to), std::max<Index>(target.vertex, e.to),
                       e.order, Index(all.targets.size())});
    all.targets.push_back(i);
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
    const auto edge = Index(all.edges.size() - 1);
    edges_of.emplace_back(c.target, edge);
    targets_of.emplace_back(edge, c.target);
  }
  all.problem.edges_of = CsrLists(all.targets.size(), edges_of);
  all.problem.targets_of = CsrLists(all.edges.size(), targets_of);
  all.problem.rivals = crossings(graph, all.edges, deadline);
  return all;
}

}  // namespace

RemovingEdges select_removing_edges(const DelaunayGraph& graph, const ExtremaTargets& targets,
                                    const Deadline& deadline, std::size_t most_work) {
  const Candidates all = candidates_of(graph, targets, deadline);
  const Selection selection = select_edges(all.problem, deadline, most_work);
  RemovingEdges result;
  for (Index e = 0; e < all.edges.size(); ++e) result.crossings += all.problem.rivals[e].size() / 2;
  for (const Index e : selection.edges)
    if (all.problem.orders[e] > 0) result.chosen.push_back(all.edges[e]);
  for (const Selection::Part& part : selection.contested) {
    bool is_complete = true;
    for (const Index t : part.targets) {
      result.contested.push_back(all.targets[t]);
      is_complete &= targets.is_complete(targets[all.targets[t]]);
    }
    if (is_complete) result.bound += part.unserved;
  }
  return result;
}

}  // namespace hodt
