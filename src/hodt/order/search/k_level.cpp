#include "hodt/order/search/k_level.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numbers>

namespace hodt {

namespace {

constexpr Index kFew = 200;              // undecided points that are not worth another split
constexpr double kNarrow = 0x1p-24;      // of a sector, in radians
constexpr std::size_t kMostStored = 64;  // undecided, for every point
constexpr Index kRoots = 8;              // sectors to begin with: less than a right angle each
constexpr double kPi = std::numbers::pi;

double dot(const Point& a, const Point& b) {
  return a.x * b.x + a.y * b.y;
}
double cross(const Point& a, const Point& b) {
  return a.x * b.y - a.y * b.x;
}
/// By how much a product with p may be off.
double slack(const Point& p) {
  return KLevel::kRounding * (std::fabs(p.x) + std::fabs(p.y));
}
Point middle(const Point& a, const Point& b) {
  return {(a.x + b.x) / 2, (a.y + b.y) / 2};
}

}  // namespace

void KLevel::build(std::span<const Point> points, Index k, const Deadline& deadline) {
  k_ = k;
  const auto n = static_cast<Index>(points.size());
  most_stored_ = kMostStored * points.size();
  undecided_.assign(points.begin(), points.end());
  sectors_.clear();
  const auto direction = [](Index i) {
    const double angle = 2 * kPi * (i % kRoots) / kRoots;
    return Point{std::cos(angle), std::sin(angle)};
  };
  for (Index i = 0; i < kRoots; ++i)
    sectors_.push_back({.from = direction(i), .to = direction(i + 1), .first = 0, .last = n});
  // The widest come first: should there be too much to store, all are equally wide in the end.
  for (std::size_t at = 0; at < sectors_.size(); ++at) {
    deadline.check();
    bound(sectors_[at]);
    if (!is_worth_splitting(sectors_[at])) continue;
    Sector child = sectors_[at];
    Point half = middle(child.from, child.to);
    const double length = std::hypot(half.x, half.y);
    half = {half.x / length, half.y / length};
    sectors_[at].children = static_cast<Index>(sectors_.size());
    sectors_.push_back(child);
    sectors_.back().to = half;
    sectors_.push_back(child);
    sectors_.back().from = half;
  }
}

bool KLevel::is_worth_splitting(const Sector& sector) const {
  // Where no line can have so many points beyond it, all is decided.
  return sector.high > 0 && sector.last - sector.first > kFew && undecided_.size() < most_stored_ &&
         std::fabs(cross(sector.from, sector.to)) > kNarrow;
}

// With n = a from + b to, where a, b >= 0: p·n is between (a + b) times the smaller and (a + b)
// times the larger of p·from and p·to. So the (k + 1)-th largest of the smaller, times a + b, is at
// most the level, and the (k + 1)-th largest of the larger at least.
void KLevel::bound(Sector& sector) {
  const Point from = sector.from, to = sector.to;
  const Index first = sector.first, last = sector.last;
  const Index rank = k_ - sector.beyond;  // so many of these are beyond the level
  const auto bound = [&](const auto& value) {
    if (last - first <= rank) return -std::numeric_limits<double>::infinity();
    values_.resize(last - first);
    for (Index i = first; i < last; ++i) values_[i - first] = value(undecided_[i]);
    std::nth_element(values_.begin(), values_.begin() + rank, values_.end(), std::greater<>());
    return values_[rank];
  };
  const auto least = [&](const Point& p) { return std::min(dot(p, from), dot(p, to)) - slack(p); };
  const auto most = [&](const Point& p) { return std::max(dot(p, from), dot(p, to)) + slack(p); };
  sector.low = bound(least);
  sector.high = bound(most);
  sector.first = static_cast<Index>(undecided_.size());
  for (Index i = first; i < last; ++i) {
    const Point p = undecided_[i];
    if (least(p) > sector.high)
      ++sector.beyond;
    else if (most(p) >= sector.low)
      undecided_.push_back(p);
  }
  sector.last = static_cast<Index>(undecided_.size());
}

bool KLevel::surely_more(const Point& n, double distance) const {
  const double angle = std::atan2(n.y, n.x);
  auto at =
      static_cast<Index>(std::floor((angle < 0 ? angle + 2 * kPi : angle) * kRoots / (2 * kPi)));
  at = std::min(at, kRoots - 1);
  while (sectors_[at].children != 0) {
    const Index children = sectors_[at].children;
    at = children + (cross(sectors_[children].to, n) >= 0 ? 1 : 0);
  }
  const Sector& sector = sectors_[at];
  const Point half = middle(sector.from, sector.to);
  const double scale = dot(n, half) / dot(half, half);  // a + b
  if (distance < scale * sector.low) return true;
  if (distance > scale * sector.high) return false;
  // The line is between the bounds, as the level is, so the points outside of them are decided.
  Index count = sector.beyond;
  for (Index i = sector.first; i < sector.last; ++i)
    count += dot(undecided_[i], n) - slack(undecided_[i]) > distance;
  return count > k_;
}

bool KLevel::surely_deep(const Point& p) const {
  std::array<Index, 128> stack;
  std::size_t depth = 0;
  for (Index i = 0; i < kRoots; ++i) stack[depth++] = i;
  while (depth > 0) {
    const Sector& sector = sectors_[stack[--depth]];
    const double most = std::max(dot(p, sector.from), dot(p, sector.to));
    if (most < -slack(p)) continue;  // no line of these directions
    if (sector.low > 0 && most + slack(p) < sector.low) continue;
    if (sector.children == 0) return false;
    stack[depth++] = sector.children;
    stack[depth++] = sector.children + 1;
  }
  return true;
}

}  // namespace hodt
