#include "hodt/hydrology/nearest_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hodt/base/parallel.h"
#include "hodt/hydrology/run_tree.h"

namespace hodt {

namespace {

/// A quarter of it: no difference of coordinates is out of range then.
double distance(const Point& p, const Point& q) {
  return std::hypot(p.x / 4 - q.x / 4, p.y / 4 - q.y / 4);
}

class Nearest {
 public:
  Nearest(const RunTree& tree, const Point& place) : tree_(tree), place_(place) {}

  VertexId find() {
    descend(tree_.root());
    return nearest_;
  }

 private:
  using Node = RunTree::Node;

  /// No point of the box is nearer, but for what rounding makes of it.
  double distance_of_box(const Node& node) const {
    const Box& box = tree_.box(node);
    return distance(place_, {std::clamp(place_.x, box.low.x, box.high.x),
                             std::clamp(place_.y, box.low.y, box.high.y)});
  }

  void descend(const Node& node) {
    constexpr double rounding = 1e-14;
    if (distance_of_box(node) * (1 - rounding) > distance_) return;
    if (node.level == 0) return look_at(node);
    const Node lower = RunTree::lower_child(node);
    const std::optional<Node> upper = tree_.upper_child(node);
    if (upper && distance_of_box(*upper) < distance_of_box(lower)) {
      descend(*upper);
      descend(lower);
      return;
    }
    descend(lower);
    if (upper) descend(*upper);
  }

  void look_at(const Node& node) {
    const std::span<const Point> points = tree_.points_of(node);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double at = distance(points[i], place_);
      const VertexId point(static_cast<Index>(tree_.first_point(node) + i));
      if (at > distance_ || (at == distance_ && nearest_ < point)) continue;
      distance_ = at;
      nearest_ = point;
    }
  }

  const RunTree& tree_;
  const Point& place_;
  double distance_ = std::numeric_limits<double>::infinity();
  VertexId nearest_;
};

}  // namespace

std::vector<VertexId> nearest_points(std::span<const Point> points, std::span<const Point> places) {
  std::vector<VertexId> nearest(places.size());
  if (places.empty()) return nearest;
  const RunTree tree(points);
  parallel_for(0, places.size(), 64, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) nearest[i] = Nearest(tree, places[i]).find();
  });
  return nearest;
}

}  // namespace hodt
