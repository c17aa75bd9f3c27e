#include "hodt/order/search/angular_hulls.h"

#include <algorithm>
#include <cmath>

#include "hodt/geometry/predicates.h"
#include "hodt/order/search/k_level.h"

namespace hodt {

ImageLine::ImageLine(const Point& a, const Point& b) : normal{b.y - a.y, a.x - b.x} {
  const double length = std::hypot(normal.x, normal.y);
  const double size = std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(b.x), std::fabs(b.y)});
  normal = {normal.x / length, normal.y / length};
  distance = normal.x * a.x + normal.y * a.y;
  if (distance < 0) {
    normal = {-normal.x, -normal.y};
    distance = -distance;
  }
  slack = KLevel::kRounding * size;
  // Closer images leave too little of the direction.
  if (!(length > 1e-6 * size)) distance = 0;
}

void AngularHulls::build(const Point& u, std::span<const Point> points,
                         std::span<const Point> images, const Deadline& deadline) {
  u_ = u;
  points_ = points;
  images_ = images;
  chains_.clear();
  used_ = 0;
  const auto n = static_cast<Index>(points.size());
  for (Index size = 1; size <= n; size *= 2) {
    deadline.check();
    if (levels_.size() == used_) levels_.emplace_back();
    std::vector<Run>& runs = levels_[used_++];
    runs.clear();
    for (Index first = 0; first + size <= n; first += size) {
      const auto begin = static_cast<Index>(chains_.size());
      const auto add = [&](Index i) {
        const auto is_within = [&] {
          const Index before = chains_[chains_.size() - 2], b = chains_.back();
          return !in_circle(u, points[before], points[i], points[b]);
        };
        while (chains_.size() >= begin + 2 && is_within()) chains_.pop_back();
        chains_.push_back(i);
      };
      if (size == 1) {
        add(first);
        runs.push_back({begin, begin + 1, {images[first], images[first]}});
        continue;
      }
      // What is on the hull of both halves is on those of the halves.
      const Run left = levels_[used_ - 2][first / size * 2];
      const Run right = levels_[used_ - 2][first / size * 2 + 1];
      if (left.first < left.last && right.first < right.last &&
          orient(u, points[first], points[first + size - 1]) > 0) {
        for (Index i = left.first; i < left.last; ++i) add(chains_[i]);
        for (Index i = right.first; i < right.last; ++i) add(chains_[i]);
      }
      runs.push_back({begin, static_cast<Index>(chains_.size()), joined(left.box, right.box)});
    }
  }
}

/// Along a chain the circles through u, v and one of its points grow emptier up to the first point,
/// and fuller from there: the chain is convex, and a line that touches it elsewhere does not have
/// the origin and the chain on the same side.
template <bool kLeft>
Index AngularHulls::first_met(Index v, Index first, Index last) const {
  const auto n = static_cast<Index>(points_.size());
  const auto is_before = [&](Index a, Index b) {
    return kLeft ? in_circle(u_, points_[v], points_[b], points_[a])
                 : in_circle(points_[v], u_, points_[b], points_[a]);
  };
  Index best = kNone;
  ImageLine line(images_[v], images_[v]);
  const auto is_far = [&](const Box& box) {  // none of it is beyond the line
    const double x = line.normal.x * (line.normal.x > 0 ? box.high.x : box.low.x);
    const double y = line.normal.y * (line.normal.y > 0 ? box.high.y : box.low.y);
    const double size = std::max(
        {std::fabs(box.low.x), std::fabs(box.low.y), std::fabs(box.high.x), std::fabs(box.high.y)});
    return x + y + 2 * KLevel::kRounding * size < line.distance - line.slack;
  };
  const auto try_run = [&](const Run& run) {
    if (best != kNone && line.is_sure() && is_far(run.box)) return;
    Index low = run.first, high = run.last - 1;
    while (low < high) {
      const Index mid = low + (high - low) / 2;
      if (is_before(chains_[mid + 1], chains_[mid]))
        low = mid + 1;
      else
        high = mid;
    }
    if (best != kNone && !is_before(chains_[low], best)) return;
    best = chains_[low];
    line = ImageLine(images_[v], images_[best]);
  };
  while (first < last) {
    const Index at = first % n;
    // The longest run that begins here and ends in time.
    std::size_t level = 0;
    for (Index twice = 2; at % twice == 0 && at + twice <= n && first + twice <= last; twice *= 2)
      ++level;
    try_run(levels_[level][at >> level]);
    first += Index(1) << level;
  }
  return best;
}

template Index AngularHulls::first_met<true>(Index, Index, Index) const;
template Index AngularHulls::first_met<false>(Index, Index, Index) const;

}  // namespace hodt
