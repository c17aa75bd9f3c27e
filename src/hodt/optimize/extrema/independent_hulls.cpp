#include "hodt/optimize/extrema/independent_hulls.h"

#include <algorithm>
#include <vector>

namespace hodt {

void insert_independent_hulls(const ExtremaTargets& targets, const Deadline& deadline,
                              ExtremaTriangulation& triangulation) {
  struct Candidate {
    Index order, target;
    VertexId to;
  };
  std::vector<Candidate> candidates;
  for (Index i = 0; i < targets.size(); ++i)
    for (const UsefulEdge& edge : targets[i].edges) candidates.push_back({edge.order, i, edge.to});
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.order < b.order; });
  for (const Candidate& c : candidates) {
    if (deadline.passed()) return;
    const Target& target = targets[c.target];
    if (triangulation.is_extremum(target.vertex, target.kind))
      triangulation.lock_if_better(target.vertex, c.to);
  }
}

}  // namespace hodt
