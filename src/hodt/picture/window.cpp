#include "hodt/picture/window.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace hodt {

void Window::include(const Point& p) {
  low = {std::min(low.x, p.x), std::min(low.y, p.y)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y)};
}

Window bounding_box(std::span<const Point> points) {
  Window box{points.front(), points.front()};
  for (const Point& p : points) box.include(p);
  return box;
}

namespace {

/// Without its rim, where the outline of the points cuts in and triangles are long, as long as
/// `side` fits in the rest.
Window without_rim(const Window& box, double side) {
  constexpr double kRim = 0.2;
  const double x = std::clamp((box.high.x - box.low.x - side) / 2, 0.0, kRim * side);
  const double y = std::clamp((box.high.y - box.low.y - side) / 2, 0.0, kRim * side);
  return {{box.low.x + x, box.low.y + y}, {box.high.x - x, box.high.y - y}};
}

/// The bounding box of the largest set of targets that a square of side `side` covers. Some best
/// square has a target on its west and one on its south side, so those are all that are tried.
Window densest(std::vector<Point> by_x, double side) {
  std::sort(by_x.begin(), by_x.end(), lexicographically_less);
  std::size_t most = 0;
  Window best;
  std::vector<Point> strip;
  for (std::size_t west = 0; west < by_x.size(); ++west) {
    strip.clear();
    for (std::size_t i = west; i < by_x.size() && by_x[i].x <= by_x[west].x + side; ++i) {
      strip.push_back(by_x[i]);
    }
    std::sort(strip.begin(), strip.end(), [](const Point& a, const Point& b) {
      return a.y < b.y || (a.y == b.y && a.x < b.x);
    });
    std::size_t north = 0;
    for (std::size_t south = 0; south < strip.size(); ++south) {
      while (north < strip.size() && strip[north].y <= strip[south].y + side) ++north;
      if (north - south <= most) continue;
      most = north - south;
      best = bounding_box(std::span(strip).subspan(south, most));
    }
  }
  return best;
}

/// Where an interval of length `side` around `middle` begins, moved into [low, high].
double placed(double middle, double side, double low, double high) {
  return std::max(low, std::min(middle - side / 2, high - side));
}

}  // namespace

Window best_window(std::span<const Point> points, std::span<const Point> targets, double side) {
  const Window all = without_rim(bounding_box(points), side);
  std::vector<Point> inside;
  for (const Point& p : targets) {
    if (all.contains(p)) inside.push_back(p);
  }
  // A target on the very border of the picture would be cut; so leave a margin.
  const Window shown = inside.empty() ? all : densest(std::move(inside), 0.92 * side);
  const Point middle = shown.middle();
  const Point low{placed(middle.x, side, all.low.x, all.high.x),
                  placed(middle.y, side, all.low.y, all.high.y)};
  return {low, {low.x + side, low.y + side}};
}

}  // namespace hodt
