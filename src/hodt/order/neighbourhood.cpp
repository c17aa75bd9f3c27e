#include "hodt/order/neighbourhood.h"

#include <algorithm>
#include <cmath>

namespace hodt {

bool Neighbourhood::gather(VertexId u, Index k, std::size_t effort) {
  centre_ = u;
  size_ = 0;
  if (++round_ == 0) {
    seen_.fill(0);
    round_ = 1;
  }
  seen_[u] = round_;
  double extent = 0;
  graph_.for_each_neighbour(u, [&](VertexId v) {
    const Point offset{graph_.point(v).x - graph_.point(u).x,
                       graph_.point(v).y - graph_.point(u).y};
    extent = std::max({extent, std::fabs(offset.x), std::fabs(offset.y)});
  });
  points_.clear(extent);
  add_neighbours_of(u);
  degree_ = size();

  // An edge of order j > 0 is found among the neighbours of the other end of one of order j - 1 or
  // less. A bound that rises as more is known only lets more vertices in. Nearly all neighbours of
  // neighbours have small orders: they are not worth a question if k is not small too.
  for (Index i = 0; i < degree_; ++i) add_neighbours_of(vertices_[i]);
  const Index unasked = k >= 4 ? size_ : degree_;
  least_order_.assign(unasked, 0);
  for (Index i = degree_; i < size_; ++i) {
    if (i >= unasked) {
      least_order_.push_back(points_.surely_inside(i, k + 1));
      if (effort < size_) return false;
      effort -= size_;
    }
    if (least_order_[i] < k) add_neighbours_of(vertices_[i]);
  }
  return true;
}

void Neighbourhood::add_neighbours_of(VertexId v) {
  const Index before = size_;
  // Without a branch on whether w is new, which is a matter of chance.
  graph_.for_each_neighbour(v, [&](VertexId w) {
    if (size_ == vertices_.size()) vertices_.resize(2 * vertices_.size() + 64);
    vertices_[size_] = w;
    size_ += seen_[w] != round_;
    seen_[w] = round_;
  });
  points_.extend(size_);
  const Point& origin = graph_.point(centre_);
  for (Index i = before; i < size_; ++i) {
    const Point& p = point(i);
    points_.set(i, {p.x - origin.x, p.y - origin.y});
  }
}

}  // namespace hodt
