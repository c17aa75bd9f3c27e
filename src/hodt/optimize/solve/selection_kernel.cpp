#include "hodt/optimize/solve/selection_kernel.h"

#include <algorithm>

namespace hodt {

SelectionKernel::SelectionKernel(const SelectionProblem& problem, const Deadline& deadline)
    : problem_(problem),
      deadline_(deadline),
      has_edge_(problem.rivals.size(), true),
      has_target_(problem.edges_of.size(), true),
      is_queued_(problem.edges_of.size(), false),
      rivals_left_(problem.rivals.size()),
      targets_left_(problem.rivals.size()) {
  for (Index e = 0; e < rivals_left_.size(); ++e) {
    rivals_left_[e] = Index(problem.rivals[e].size());
    targets_left_[e] = Index(problem.targets_of[e].size());
  }
  for (Index t = 0; t < has_target_.size(); ++t) look_again(t);
  shrink();
}

void SelectionKernel::shrink() {
  for (std::size_t i = 0; i < queue_.size(); ++i) {
    const Index t = queue_[i];
    is_queued_[t] = false;
    if (!has_target_[t]) continue;
    deadline_.check();
    const std::vector<Index> edges = edges_of(t);
    if (edges.empty())
      has_target_[t] = false;
    else if (!take_free_edge(edges))
      drop_worse_edges(edges);
  }
  queue_.clear();
}

void SelectionKernel::finish_greedily() {
  for (Index t = 0; t < has_target_.size(); ++t) {
    if (!has_target_[t]) continue;
    const std::vector<Index> edges = edges_of(t);
    const Index best = *std::min_element(edges.begin(), edges.end(), [&](Index e, Index f) {
      return rivals_left_[e] < rivals_left_[f];
    });
    for (const Index rival : rivals(best)) drop(rival);
    look_again(t);
    shrink();
  }
}

bool SelectionKernel::take_free_edge(const std::vector<Index>& edges) {
  Index best = kNone;
  for (const Index e : edges)
    if (rivals_left_[e] == 0 && (best == kNone || problem_.orders[e] < problem_.orders[best]))
      best = e;
  if (best != kNone) take(best);
  return best != kNone;
}

void SelectionKernel::take(Index edge) {
  taken_.push_back(edge);
  for (const Index t : targets_of(edge)) {
    has_target_[t] = false;
    for (const Index e : edges_of(t)) {
      if (--targets_left_[e] == 0) {
        drop(e);
      } else {
        for (const Index other : targets_of(e)) look_again(other);
      }
    }
  }
}

void SelectionKernel::drop(Index edge) {
  has_edge_[edge] = false;
  for (const Index rival : rivals(edge)) {
    --rivals_left_[rival];
    for (const Index t : targets_of(rival)) look_again(t);
  }
  for (const Index t : targets_of(edge)) look_again(t);
}

void SelectionKernel::drop_worse_edges(const std::vector<Index>& edges) {
  for (const Index e : edges) {
    deadline_.check();
    for (const Index f : edges)
      if (e != f && has_edge_[e] && has_edge_[f] && is_as_good(e, f)) drop(f);
  }
}

/// Whether whoever has f could as well have e.
bool SelectionKernel::is_as_good(Index e, Index f) {
  if (rivals_left_[e] > rivals_left_[f] || targets_left_[e] < targets_left_[f]) return false;
  const std::size_t cost = problem_.rivals[e].size() + problem_.rivals[f].size();
  if (comparing_left_ < cost) return false;
  comparing_left_ -= cost;
  const auto includes = [](const std::vector<Index>& all, const std::vector<Index>& some) {
    return std::includes(all.begin(), all.end(), some.begin(), some.end());
  };
  return includes(targets_of(e), targets_of(f)) && includes(rivals(f), rivals(e));
}

}  // namespace hodt
