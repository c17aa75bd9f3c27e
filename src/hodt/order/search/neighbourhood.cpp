#include "hodt/order/search/neighbourhood.h"

#include <algorithm>

#include "hodt/order/search/pencil.h"

namespace hodt {

Neighbourhood::Neighbourhood(const DelaunayGraph& graph)
    : graph_(graph), pencil_(std::make_unique<Pencil>(*this)), seen_(graph.xy.size()) {}

Neighbourhood::~Neighbourhood() = default;

bool Neighbourhood::gather(VertexId u, Index k, std::size_t effort) {
  k = std::min(k, static_cast<Index>(graph_.xy.size()));  // no order is larger
  begin_at(u, k);
  reach([&](const auto& f) { graph_.for_each_neighbour(u, f); });
  degree_ = size_;
  const auto go_on_from = [&](VertexId v) {
    reach([&](const auto& f) { graph_.for_each_onward(v, u, f); });
  };
  if (graph_.has_hubs()) go_on_from(u);  // around them, to more than the neighbours
  for (Index i = 0; i < degree_; ++i) go_on_from(vertices_[i]);
  add_reached();

  // An edge of order j > 0 is found among the neighbours of the other end of one of order j - 1 or
  // less. A bound that rises as more is known only lets more vertices in.
  std::fill_n(least_order_.begin(), degree_, 0);
  for (Index next = degree_; next < size_;) {
    const Index end = size_;
    deadline_.check();
    if (!bound_orders(next, end, k, effort)) return false;
    for (; next < end; ++next)
      if (least_order_[next] < k) go_on_from(vertices_[next]);
    add_reached();
  }
  return true;
}

/// Of the vertices of places `first` to `last` - 1. False if the effort did not suffice.
bool Neighbourhood::bound_orders(Index first, Index last, Index k, std::size_t& effort) {
  levels_.bound(points_.image_x(), points_.image_y(), first, last, least_order_.data());
  if (graph_.has_hubs())
    for (Index i = first; i < last; ++i)
      if (graph_.is_hub(vertices_[i])) least_order_[i] = 0;
  // Where many points are close to one circle, or u is on the hull, directions hardly differ, and
  // levels tell little. That shows in the size.
  if (size_ <= 40 + 8 * std::size_t{k}) return true;
  // Exact arithmetic takes the time of so many questions, and asks about so many points.
  constexpr std::size_t kExactCost = 100;
  const std::size_t sample = 8 + 3 * std::size_t{k};
  for (Index i = first; i < last; ++i) {
    Index& least = least_order_[i];
    if (least > k) continue;
    deadline_.check();
    least = std::max(least, points_.surely_inside(i, k + 1));
    std::size_t cost = size_;
    if (least < k) {
      least = std::max(least, pencil_->least_order(i, sample));
      cost += kExactCost * sample;
    }
    if (effort < cost) return false;
    effort -= cost;
  }
  return true;
}

void Neighbourhood::begin_at(VertexId u, Index k) {
  centre_ = u;
  size_ = 0;
  seen_.begin_round();
  seen_.mark(u);
  points_.clear(graph_.nearest(u));
  levels_.clear(k);
}

/// Adds those that search(f) calls f with and that are new.
template <class Search>
void Neighbourhood::reach(const Search& search) {
  // Local copies stay in registers. No branch on whether w is new, which is a matter of chance.
  const RoundMarks::Round round = seen_.round();
  RoundMarks::Round* const seen = seen_.marks();
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
  size_ = static_cast<Index>(size);
}

void Neighbourhood::add_reached() {
  const Index first = points_.size();
  points_.extend(size_);
  const Point origin = graph_.point(centre_);
  for (Index i = first; i < size_; ++i) {
    const Point& p = graph_.point(vertices_[i]);
    points_.set(i, {p.x - origin.x, p.y - origin.y});
  }
  points_.finish(first);
  if (graph_.has_hubs())
    for (Index i = first; i < size_; ++i)
      if (graph_.is_hub(vertices_[i])) points_.hide(i);
  levels_.add(points_.image_x(), points_.image_y(), first, size_);
  if (least_order_.size() < points_.capacity()) least_order_.resize(points_.capacity());
}

}  // namespace hodt
