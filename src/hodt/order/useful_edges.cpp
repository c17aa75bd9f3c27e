#include "hodt/order/useful_edges.h"

#include <algorithm>

namespace hodt {

namespace {

/// std::popcount, which without an instruction for it is a call.
Index count_bits(std::uint64_t v) {
  v -= (v >> 1) & 0x5555555555555555u;
  v = (v & 0x3333333333333333u) + ((v >> 2) & 0x3333333333333333u);
  v = (v + (v >> 4)) & 0x0F0F0F0F0F0F0F0Fu;
  return static_cast<Index>((v * 0x0101010101010101u) >> 56);
}

}  // namespace

void UsefulEdgeSearch::begin(VertexId u, Index limit) {
  u_ = u;
  limit_ = limit;
  found_.clear();
  gather_neighbourhood();
}

void UsefulEdgeSearch::finish() {
  for (Index i = 0; i < slots_.size(); ++i) slot_of_[vertex_[i]] = kNoSlot;
  std::sort(found_.begin(), found_.end(), [](const UsefulEdge& a, const UsefulEdge& b) {
    return a.order != b.order ? a.order < b.order : a.to < b.to;
  });
}

/// Takes up the vertices nearest to u in the graph, breadth first. Which ones, and how many, has no
/// effect on the result: each is only one more point that can prove a branch hopeless.
void UsefulEdgeSearch::gather_neighbourhood() {
  const Index wanted = std::min(kSlots, 16 + 4 * std::min(limit_, kSlots));
  slots_.clear();
  const Point origin = graph_.point(u_);
  const auto take = [&](VertexId v) {
    if (slots_.size() == wanted || v == u_ || slot_of_[v] != kNoSlot) return;
    vertex_[slots_.size()] = v;
    slot_of_[v] = static_cast<std::uint8_t>(slots_.size());
    slots_.add(graph_.point(v).x - origin.x, graph_.point(v).y - origin.y);
  };
  graph_.for_each_neighbour(u_, take);
  for (Index i = 0; i < slots_.size() && slots_.size() < wanted; ++i)
    graph_.for_each_neighbour(vertex_[i], take);
}

/// Starts the walk across the edge that u sees in one of its triangles.
void UsefulEdgeSearch::enter(HalfEdgeId opposite) {
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

UsefulEdgeSearch::Mask UsefulEdgeSearch::proven_inside(VertexId right, VertexId left) const {
  const Point &u = graph_.point(u_), &b = graph_.point(right), &c = graph_.point(left);
  return slots_.inside_circle(b.x - u.x, b.y - u.y, c.x - u.x, c.y - u.y);
}

UsefulEdgeSearch::Sides UsefulEdgeSearch::proven_sides(VertexId v) const {
  return slots_.sides_of_ray(graph_.point(v).x - graph_.point(u_).x,
                             graph_.point(v).y - graph_.point(u_).y);
}

/// Adds what is inside the circle of the crossed edge to what every later circle holds: on the
/// left what is to the left of the whole window, that is, of both its rays; likewise on the right.
void UsefulEdgeSearch::push_if_hopeful(Node& child, Mask inside) {
  child.inside_left |= inside & child.left_sides.left & child.right_sides.left;
  child.inside_right |= inside & child.left_sides.right & child.right_sides.right;
  if (!too_many(child.inside_left, child.distinct_left) &&
      !too_many(child.inside_right, child.distinct_right))
    stack_.push_back(child);
}

bool UsefulEdgeSearch::too_many(Mask mask, Index passed) const {
  return passed > limit_ || count_bits(mask) > limit_;
}

/// Whether v is in the chain. Of a vertex with a slot the mask knows that it is not: what was
/// passed has its bit.
bool UsefulEdgeSearch::was_passed(VertexId v, Mask inside, const std::vector<VertexId>& chain,
                                  Index length) const {
  if (bit(v) && !(bit(v) & inside)) return false;
  return std::find(chain.begin(), chain.begin() + length, v) != chain.begin() + length;
}

/// Lemma 4: the larger count of the circles through u, v and the first point on either side. The
/// first point is a corner of a crossed triangle, so one of those passed; and by Corollary 1 those
/// passed on the other side are all inside, which is where the count starts.
Index UsefulEdgeSearch::useful_order(VertexId v, Index passed_left, Index passed_right) {
  const VertexId s1 = first_point(left_, passed_left, u_, v);
  const Index order_left = counter_.count(u_, v, s1, limit_, {right_.data(), passed_right});
  if (order_left > limit_) return order_left;
  const VertexId s2 = first_point(right_, passed_right, v, u_);
  const Index order_right = counter_.count(v, u_, s2, limit_, {left_.data(), passed_left});
  return std::max(order_left, order_right);
}

/// Of the chain, all to the left of ab, the vertex whose circle with a and b holds no other.
VertexId UsefulEdgeSearch::first_point(const std::vector<VertexId>& chain, Index length, VertexId a,
                                       VertexId b) const {
  const Point &pa = graph_.point(a), &pb = graph_.point(b);
  VertexId first = chain[0];
  for (Index i = 1; i < length; ++i)
    if (in_circle(pa, pb, graph_.point(first), graph_.point(chain[i]))) first = chain[i];
  return first;
}

}  // namespace hodt
