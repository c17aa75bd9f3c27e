#include "hodt/order/search/large_order_search.h"

#include <algorithm>
#include <cmath>

#include "hodt/geometry/direction.h"
#include "hodt/geometry/predicates.h"

namespace hodt {

LargeOrderSearch::LargeOrderSearch(const DelaunayGraph& graph, const PointTree& tree)
    : graph_(graph), tree_(tree), seen_(graph.xy.size()) {}

Point LargeOrderSearch::image_of(VertexId v) const {
  const double x = scale_ * (graph_.point(v).x - graph_.point(u_).x);
  const double y = scale_ * (graph_.point(v).y - graph_.point(u_).y);
  const double r = x * x + y * y;
  // Too far away for doubles is as good as infinitely far.
  return std::isfinite(r) ? Point{x / r, y / r} : Point{0, 0};
}

/// Takes up the neighbours of u, and of all vertices but those that are proven no k-OD neighbours
/// by what was gathered before (as Neighbourhood does).
void LargeOrderSearch::gather() {
  seen_.begin_round();
  around_.clear();
  all_images_.clear();
  seen_.mark(u_);
  scale_ = std::ldexp(1.0, -std::clamp(std::ilogb(graph_.nearest(u_)), -1000, 1000));
  const auto take = [&](VertexId v) {
    if (!seen_.mark(v)) return;
    around_.push_back({v, false});
    all_images_.push_back(image_of(v));
  };
  graph_.for_each_neighbour(u_, take);
  for (Neighbour& v : around_) v.is_ruled_out = true;
  if (graph_.has_hubs()) graph_.for_each_onward(u_, u_, take);  // around them
  // About as many as there are k-OD neighbours; then a check of all, whenever there are half more.
  std::size_t enough = 6 * std::size_t(limit_), checked = 0;
  for (std::size_t i = 0; i < around_.size(); ++i) {
    if (around_.size() >= enough) {
      level_.build(all_images_, limit_, deadline_);
      checked = around_.size();
      enough = around_.size() + around_.size() / 2;
    }
    if (i % 1024 == 0) deadline_.check();
    if (checked > 0 && level_.surely_deep(all_images_[i]))
      around_[i].is_ruled_out = true;
    else
      graph_.for_each_onward(around_[i].vertex, u_, take);
  }
  // The level of a part is a bound, too.
  if (around_.size() > checked + checked / 4) level_.build(all_images_, limit_, deadline_);
}

/// Counter-clockwise. Of several in the same direction only the nearest can have an edge to u, or
/// be a first point.
void LargeOrderSearch::sort_by_direction() {
  const Point& u = graph_.point(u_);
  const auto is_lower_half = [&](const Point& p) { return p.y < u.y || (p.y == u.y && p.x < u.x); };
  const auto is_nearer = [&](const Point& a, const Point& b) {
    return lexicographically_less(u, a) ? lexicographically_less(a, b)
                                        : lexicographically_less(b, a);
  };
  std::sort(around_.begin(), around_.end(), [&](const Neighbour& a, const Neighbour& b) {
    const Point &pa = graph_.point(a.vertex), &pb = graph_.point(b.vertex);
    const bool lower_a = is_lower_half(pa), lower_b = is_lower_half(pb);
    if (lower_a != lower_b) return lower_b;
    const int turn = orient(u, pa, pb);
    return turn != 0 ? turn > 0 : is_nearer(pa, pb);
  });
}

void LargeOrderSearch::build_hulls() {
  const Point& u = graph_.point(u_);
  points_.clear();
  images_.clear();
  std::size_t kept = 0;
  for (const Neighbour& v : around_) {
    const Point& p = graph_.point(v.vertex);
    if (kept > 0 && is_same_direction(u, points_.back(), p)) continue;
    points_.push_back(p);
    images_.push_back(image_of(v.vertex));
    around_[kept++] = v;
  }
  around_.resize(kept);
  hulls_.build(u, points_, images_, deadline_);
}

/// False if the circle through u, v and the first point on one side surely holds more than the
/// limit on the other.
bool LargeOrderSearch::may_hold_few(Index i, Index first) const {
  const ImageLine line(images_[i], images_[first]);
  return !line.is_sure() || !level_.surely_more(line.normal, line.distance + line.slack);
}

}  // namespace hodt
