// A problem of selection shrinks to what is hard about it.
// Tested by tests/optimize/edge_selection_test.cpp.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hodt/base/buffer.h"
#include "hodt/base/deadline.h"
#include "hodt/optimize/solve/edge_selection.h"

namespace hodt {

/// An edge without rivals is taken, and an edge goes when another one serves as many and excludes
/// no more. What is left is the kernel.
class SelectionKernel {
 public:
  /// Throws TimeIsUp if the deadline passes.
  explicit SelectionKernel(const SelectionProblem& problem, const Deadline& deadline = {});

  /// Takes edges until no target is left: each in turn gets the one that excludes the fewest.
  void finish_greedily();
  /// The edges that are certain to be in some best selection, and those of finish_greedily().
  const std::vector<Index>& taken() const { return taken_; }

  bool has_target(Index t) const { return has_target_[t]; }
  /// What is left of a list.
  std::vector<Index> edges_of(Index target) const { return left(problem_.edges_of[target]); }
  std::vector<Index> rivals(Index edge) const { return left(problem_.rivals[edge]); }
  std::vector<Index> targets_of(Index edge) const {
    std::vector<Index> targets;
    for (const Index t : problem_.targets_of[edge])
      if (has_target_[t]) targets.push_back(t);
    return targets;
  }

 private:
  // How many rivals are looked at to compare edges, before a kernel stays larger than it had to.
  static constexpr std::size_t kMostComparing = 100'000'000;

  void shrink();
  std::vector<Index> left(std::span<const Index> edges) const {
    std::vector<Index> found;
    for (const Index e : edges)
      if (has_edge_[e]) found.push_back(e);
    return found;
  }
  void look_again(Index target) {
    if (!has_target_[target] || is_queued_[target]) return;
    is_queued_[target] = true;
    queue_.push_back(target);
  }
  bool take_free_edge(const std::vector<Index>& edges);
  void drop_worse_edges(const std::vector<Index>& edges);
  bool is_as_good(Index e, Index f);
  void take(Index edge);
  void drop(Index edge);

  const SelectionProblem& problem_;
  const Deadline deadline_;
  Buffer<bool> has_edge_, has_target_, is_queued_;
  Buffer<Index> rivals_left_;   // of each edge
  Buffer<Index> targets_left_;  // of each edge
  std::vector<Index> queue_, taken_;
  std::size_t comparing_left_ = kMostComparing;
};

}  // namespace hodt
