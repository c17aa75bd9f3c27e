#include "hodt/order/window_walk.h"

#include <algorithm>
#include <cmath>

namespace hodt {

template <int kWords>
void WindowWalk<kWords>::begin(VertexId u, Index limit, std::size_t effort) {
  u_ = u;
  limit_ = limit;
  effort_ = effort;
  stack_.clear();
  found_.clear();
  gather_neighbourhood();
}

template <int kWords>
void WindowWalk<kWords>::finish() {
  for (Index i = 0; i < slots_.size(); ++i) slot_of_[vertex_[i]] = kNoSlot;
  std::sort(found_.begin(), found_.end(), [](const UsefulEdge& a, const UsefulEdge& b) {
    return a.order != b.order ? a.order < b.order : a.to < b.to;
  });
}

/// Takes up the vertices nearest to u in the graph, breadth first. Which ones, and how many, has no
/// effect on the result: each is only one more point that can prove a branch hopeless.
template <int kWords>
void WindowWalk<kWords>::gather_neighbourhood() {
  const Index wanted = std::min(kSlots, 16 + 4 * std::min(limit_, kSlots));
  slots_.clear();
  double extent = 0;
  graph_.for_each_neighbour(u_, [&](VertexId v) {
    const Point offset = offset_of(v);
    extent = std::max({extent, std::fabs(offset.x), std::fabs(offset.y)});
  });
  // Any size of terrain looks alike to the slots; multiplying by a power of two is exact.
  scale_ = std::ldexp(1.0, -std::clamp(std::ilogb(extent), -1000, 1000));
  const auto take = [&](VertexId v) {
    if (slots_.size() == wanted || v == u_ || slot_of_[v] != kNoSlot) return;
    vertex_[slots_.size()] = v;
    slot_of_[v] = static_cast<std::uint16_t>(slots_.size());
    const Point offset = offset_of(v);
    slots_.add(scale_ * offset.x, scale_ * offset.y);
  };
  graph_.for_each_neighbour(u_, take);
  for (Index i = 0; i < slots_.size() && slots_.size() < wanted; ++i)
    graph_.for_each_neighbour(vertex_[i], take);
}

/// Starts the walk across the edge that u sees in one of its triangles.
template <int kWords>
void WindowWalk<kWords>::enter(HalfEdgeId opposite) {
  const VertexId right = graph_.mesh.origin(opposite), left = graph_.mesh.target(opposite);
  stack_.push_back({.edge = opposite,
                    .left_ray = left,
                    .right_ray = right,
                    .inside_left = bit(left),
                    .inside_right = bit(right),
                    .left_sides = proven_sides(left),
                    .right_sides = proven_sides(right),
                    .passed_left = 1,
                    .passed_right = 1,
                    .distinct_left = 1,
                    .distinct_right = 1});
}

template <int kWords>
SlotMask<kWords> WindowWalk<kWords>::proven_inside(VertexId right, VertexId left) const {
  const Point b = offset_of(right), c = offset_of(left);
  return slots_.inside_circle(scale_ * b.x, scale_ * b.y, scale_ * c.x, scale_ * c.y);
}

template <int kWords>
typename Slots<kWords>::Sides WindowWalk<kWords>::proven_sides(VertexId v) const {
  const Point offset = offset_of(v);
  return slots_.sides_of_ray(scale_ * offset.x, scale_ * offset.y);
}

/// Adds what is inside the circle of the crossed edge to what every later circle holds: on the
/// left what is to the left of the whole window, that is, of both its rays; likewise on the right.
template <int kWords>
void WindowWalk<kWords>::push_if_hopeful(Node& child, Mask inside) {
  child.inside_left |= inside & child.left_sides.left & child.right_sides.left;
  child.inside_right |= inside & child.left_sides.right & child.right_sides.right;
  if (!too_many(child.inside_left, child.distinct_left) &&
      !too_many(child.inside_right, child.distinct_right))
    stack_.push_back(child);
}

template <int kWords>
bool WindowWalk<kWords>::too_many(Mask mask, Index passed) const {
  return passed > limit_ || mask.count() > limit_;
}

/// Whether v is in the chain. Of a vertex with a slot the mask knows that it is not: what was
/// passed has its bit.
template <int kWords>
bool WindowWalk<kWords>::was_passed(VertexId v, Mask inside, const std::vector<VertexId>& chain,
                                    Index length) const {
  if (slot_of_[v] != kNoSlot && !inside.contains(slot_of_[v])) return false;
  return std::find(chain.begin(), chain.begin() + length, v) != chain.begin() + length;
}

/// Lemma 4: the larger count of the circles through u, v and the first point on either side. The
/// first point is a corner of a crossed triangle, so one of those passed; and by Corollary 1 those
/// passed on the other side are all inside, which is where the count starts.
template <int kWords>
Index WindowWalk<kWords>::useful_order(VertexId v, Index passed_left, Index passed_right) {
  const VertexId s1 = first_point(left_, passed_left, u_, v);
  const Index order_left = counter_.count(u_, v, s1, limit_, {right_.data(), passed_right});
  effort_ -= std::min<std::size_t>(effort_ - 1, order_left);
  if (order_left > limit_) return order_left;
  const VertexId s2 = first_point(right_, passed_right, v, u_);
  const Index order_right = counter_.count(v, u_, s2, limit_, {left_.data(), passed_left});
  return std::max(order_left, order_right);
}

/// Of the chain, all to the left of ab, the vertex whose circle with a and b holds no other.
template <int kWords>
VertexId WindowWalk<kWords>::first_point(const std::vector<VertexId>& chain, Index length,
                                         VertexId a, VertexId b) const {
  const Point &pa = graph_.point(a), &pb = graph_.point(b);
  VertexId first = chain[0];
  for (Index i = 1; i < length; ++i)
    if (in_circle(pa, pb, graph_.point(first), graph_.point(chain[i]))) first = chain[i];
  return first;
}

template class WindowWalk<1>;
template class WindowWalk<4>;
template class WindowWalk<16>;

}  // namespace hodt
