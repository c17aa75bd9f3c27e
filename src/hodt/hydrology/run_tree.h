// Boxes around runs of points. Points along a space-filling curve make small ones.
// Tested by tests/hydrology/points_in_polygons_test.cpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "hodt/base/parallel.h"
#include "hodt/geometry/point.h"

namespace hodt {

/// A tree over points: a node is a run of points, and its children are the halves of the run.
class RunTree {
 public:
  static constexpr std::size_t kRun = 8;  ///< points of a lowest node

  /// 2^level runs; the index counts the nodes of a level.
  struct Node {
    std::size_t level, index;
  };

  /// Requires a point. A view: the points must outlive it.
  explicit RunTree(std::span<const Point> points) : points_(points), levels_(1) {
    levels_[0].resize((points.size() + kRun - 1) / kRun);
    parallel_for(0, levels_[0].size(), 1 << 10, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) levels_[0][i] = box_of(points_of({0, i}));
    });
    while (levels_.back().size() > 1) {
      const std::vector<Box>& below = levels_.back();
      std::vector<Box> level((below.size() + 1) / 2);
      for (std::size_t i = 0; i < level.size(); ++i)
        level[i] = joined(below[2 * i], below[std::min(2 * i + 1, below.size() - 1)]);
      levels_.push_back(std::move(level));
    }
  }

  Node root() const { return {levels_.size() - 1, 0}; }
  const Box& box(const Node& node) const { return levels_[node.level][node.index]; }
  std::span<const Point> points_of(const Node& node) const {
    const std::size_t first = first_point(node);
    return points_.subspan(first, std::min(points_.size() - first, kRun << node.level));
  }
  std::size_t first_point(const Node& node) const { return (kRun << node.level) * node.index; }

  static Node lower_child(const Node& node) { return {node.level - 1, 2 * node.index}; }
  /// None where there are no more points.
  std::optional<Node> upper_child(const Node& node) const {
    const Node child{node.level - 1, 2 * node.index + 1};
    return child.index < levels_[child.level].size() ? std::optional(child) : std::nullopt;
  }

 private:
  std::span<const Point> points_;
  std::vector<std::vector<Box>> levels_;  // of runs, of pairs of runs, ..., of all
};

}  // namespace hodt
