#include "hodt/optimize/solve/selection_program.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace hodt {

namespace {

/// Edges that all exclude each other, so that every pair of rivals is in one such clique.
std::vector<std::vector<Index>> cliques(const SelectionProblem& problem, const Deadline& deadline) {
  const auto are_rivals = [&](Index a, Index b) {
    return std::binary_search(problem.rivals[a].begin(), problem.rivals[a].end(), b);
  };
  std::vector<std::vector<Index>> cliques, covered(problem.rivals.size());
  for (Index e = 0; e < covered.size(); ++e)
    for (const Index f : problem.rivals[e]) {
      deadline.check();
      if (f < e || std::find(covered[e].begin(), covered[e].end(), f) != covered[e].end()) continue;
      std::vector<Index> clique{e, f};
      for (const Index g : problem.rivals[e])
        if (g != f && std::all_of(clique.begin() + 1, clique.end(),
                                  [&](Index other) { return are_rivals(g, other); }))
          clique.push_back(g);
      for (const Index a : clique)
        for (const Index b : clique)
          if (a < b) covered[a].push_back(b);
      cliques.push_back(std::move(clique));
    }
  return cliques;
}

}  // namespace

BinaryRows rows_of(const SelectionProblem& problem, const Deadline& deadline) {
  const auto edges = Index(problem.rivals.size()), targets = Index(problem.edges_of.size());
  std::vector<std::pair<Index, Index>> entries;  // column and row
  BinaryRows rows;
  for (Index t = 0; t < targets; ++t) {
    for (const Index e : problem.edges_of[t]) entries.emplace_back(e, t);
    entries.emplace_back(edges + t, t);
    rows.low.push_back(1);
    rows.high.push_back(BinaryRows::kInfinite);
  }
  for (const std::vector<Index>& clique : cliques(problem, deadline)) {
    for (const Index e : clique) entries.emplace_back(e, Index(rows.low.size()));
    rows.low.push_back(-BinaryRows::kInfinite);
    rows.high.push_back(1);
  }
  const CsrLists by_column(edges + targets, entries);
  for (Index column = 0; column < by_column.size(); ++column) {
    for (const Index row : by_column[column]) rows.row.push_back(int(row));
    rows.first.push_back(rows.row.size());
  }
  rows.factor.assign(rows.row.size(), 1);
  return rows;
}

}  // namespace hodt
