#include "hodt/order/neighbourhood.h"

#include <algorithm>
#include <cmath>

#include "hodt/order/pencil.h"

namespace hodt {

Neighbourhood::Neighbourhood(const DelaunayGraph& graph)
    : graph_(graph), pencil_(std::make_unique<Pencil>(*this)), seen_(graph.xy.size(), 0) {}

Neighbourhood::~Neighbourhood() = default;

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
  take_up([&](const auto& f) { graph_.for_each_neighbour(u, f); });
  degree_ = size_;
  const auto go_on_from = [&](VertexId v) {
    take_up([&](const auto& f) { graph_.for_each_onward(v, u, f); });
  };
  if (graph_.has_hubs()) go_on_from(u);  // around them, to more than the neighbours

  // An edge of order j > 0 is found among the neighbours of the other end of one of order j - 1 or
  // less. A bound that rises as more is known only lets more vertices in. Nearly all neighbours of
  // neighbours have small orders: they are not worth a question if k is not small too.
  for (Index i = 0; i < degree_; ++i) go_on_from(vertices_[i]);
  // Where many points are close to one circle, rounding leaves them all in doubt, and no bound is
  // found. That shows in the size, and exact arithmetic helps.
  const std::size_t crowd = 40 + 16 * std::size_t{k}, sample = 8 + 3 * std::size_t{k};
  constexpr std::size_t kExactCost = 100;
  const Index unasked = k >= 4 && size_ <= crowd ? size_ : degree_;
  least_order_.assign(unasked, 0);
  for (Index i = degree_; i < size_; ++i) {
    if (i >= unasked) {
      Index least = points_.surely_inside(i, k + 1);
      std::size_t cost = size_;
      if (least < k && size_ > crowd) {
        least = std::max(least, pencil_->least_order(i, sample));
        cost += kExactCost * sample;
      }
      least_order_.push_back(least);
      if (effort < cost) return false;
      effort -= cost;
    }
    if (least_order_[i] < k) go_on_from(vertices_[i]);
  }
  return true;
}

Index Neighbourhood::find(VertexId v) const {
  for (Index i = 0; i < size_; ++i)
    if (vertices_[i] == v) return i;
  return kNone;
}

/// Adds those that search(f) calls f with and that are new.
template <class Search>
void Neighbourhood::take_up(const Search& search) {
  // Local copies stay in registers. No branch on whether w is new, which is a matter of chance.
  const std::uint32_t round = round_;
  std::uint32_t* const seen = seen_.data();
  VertexId* vertices = vertices_.data();
  std::size_t size = size_, capacity = vertices_.size();
  search([&](VertexId w) {
    if (size == capacity) [[unlikely]] {
      vertices_.resize(2 * capacity + 64);
      vertices = vertices_.data();
      capacity = vertices_.size();
    }
    vertices[size] = w;
    size += seen[w] != round;
    seen[w] = round;
  });
  points_.extend(static_cast<Index>(size));
  const Point origin = graph_.point(centre_);
  for (auto i = size_; i < size; ++i) {
    const Point& p = graph_.point(vertices[i]);
    const Point offset{p.x - origin.x, p.y - origin.y};
    if (graph_.is_hub(vertices[i])) [[unlikely]]
      points_.set_uncounted(i, offset);
    else
      points_.set(i, offset);
  }
  size_ = static_cast<Index>(size);
}

}  // namespace hodt
