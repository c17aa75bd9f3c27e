#include "hodt/order/k_level.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numbers>

namespace hodt {

namespace {

constexpr Index kFew = 200;          // undecided points that are not worth another split
constexpr double kNarrow = 0x1p-24;  // of a sector, in radians
constexpr Index kRoots = 8;          // sectors to begin with: less than a right angle each
constexpr double kPi = std::numbers::pi;

double dot(const Point& a, const Point& b) {
  return a.x * b.x + a.y * b.y;
}
double cross(const Point& a, const Point& b) {
  return a.x * b.y - a.y * b.x;
}
Point middle(const Point& a, const Point& b) {
  return {(a.x + b.x) / 2, (a.y + b.y) / 2};
}

}  // namespace

void KLevel::build(std::span<const Point> points, Index k) {
  k_ = k;
  double largest = 0;
  for (const Point& p : points) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
  slack_ = 1e-9 * largest;
  sectors_.clear();
  undecided_.clear();
  stack_.assign(points.begin(), points.end());
  const auto direction = [](Index i) {
    const double angle = 2 * kPi * (i % kRoots) / kRoots;
    return Point{std::cos(angle), std::sin(angle)};
  };
  for (Index i = 0; i < kRoots; ++i) {
    sectors_.push_back({.from = direction(i), .to = direction(i + 1)});
  }
  for (Index i = 0; i < kRoots; ++i) split(i, 0, points.size());
}

// With n = a from + b to, where a, b >= 0: p·n is between (a + b) times the smaller and (a + b)
// times the larger of p·from and p·to. So the (k + 1)-th largest of the smaller, times a + b, is at
// most the level, and the (k + 1)-th largest of the larger at least.
void KLevel::split(Index at, std::size_t first, std::size_t last) {
  const Point from = sectors_[at].from, to = sectors_[at].to;
  const Index beyond = sectors_[at].beyond;
  const Index rank = k_ - beyond;  // so many of the undecided are beyond the level
  const auto bound = [&](const auto& combine) {
    if (last - first <= rank) return -std::numeric_limits<double>::infinity();
    values_.resize(last - first);
    for (std::size_t i = first; i < last; ++i)
      values_[i - first] = combine(dot(stack_[i], from), dot(stack_[i], to));
    std::nth_element(values_.begin(), values_.begin() + rank, values_.end(), std::greater<>());
    return values_[rank];
  };
  const double low = bound([](double a, double b) { return std::min(a, b); }) - slack_;
  const double high = bound([](double a, double b) { return std::max(a, b); }) + slack_;
  sectors_[at].low = low;
  sectors_[at].high = high;
  const std::size_t stacked = stack_.size();
  for (std::size_t i = first; i < last; ++i) {
    const Point p = stack_[i];
    const double a = dot(p, from), b = dot(p, to);
    if (std::min(a, b) > high + slack_)
      ++sectors_[at].beyond;
    else if (std::max(a, b) >= low - slack_)
      stack_.push_back(p);
  }
  const std::size_t end = stack_.size();
  // Where no line can have so many points beyond it, all is decided.
  const bool is_leaf = high <= 0 || end - stacked <= kFew || std::fabs(cross(from, to)) < kNarrow;
  sectors_[at].first = static_cast<Index>(undecided_.size());
  if (is_leaf && high > 0)
    undecided_.insert(undecided_.end(), stack_.begin() + std::ptrdiff_t(stacked), stack_.end());
  sectors_[at].last = static_cast<Index>(undecided_.size());
  if (!is_leaf) {
    Point half = middle(from, to);
    const double length = std::hypot(half.x, half.y);
    half = {half.x / length, half.y / length};
    const auto children = static_cast<Index>(sectors_.size());
    const Index all_beyond = sectors_[at].beyond;
    sectors_[at].children = children;
    sectors_.push_back({.from = from, .to = half, .beyond = all_beyond});
    sectors_.push_back({.from = half, .to = to, .beyond = all_beyond});
    split(children, stacked, end);
    split(children + 1, stacked, end);
  }
  stack_.resize(stacked);
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
  if (distance + 2 * slack_ < scale * sector.low) return true;
  if (distance > scale * sector.high) return false;
  // The line is between the bounds, as the level is, so the points outside of them are decided.
  Index count = sector.beyond;
  for (Index i = sector.first; i < sector.last; ++i)
    count += dot(undecided_[i], n) > distance + 2 * slack_;
  return count > k_;
}

bool KLevel::surely_deep(const Point& p) const {
  std::array<Index, 128> stack;
  std::size_t depth = 0;
  for (Index i = 0; i < kRoots; ++i) stack[depth++] = i;
  while (depth > 0) {
    const Sector& sector = sectors_[stack[--depth]];
    const double most = std::max(dot(p, sector.from), dot(p, sector.to));
    if (most < -slack_) continue;  // no line of these directions
    const Point half = middle(sector.from, sector.to);
    const double scale = 1 / std::sqrt(dot(half, half));  // a + b is at least 1, and at most this
    if (sector.low > 0 && scale * most + 2 * slack_ < sector.low) continue;
    if (sector.children == 0) return false;
    stack[depth++] = sector.children;
    stack[depth++] = sector.children + 1;
  }
  return true;
}

}  // namespace hodt
