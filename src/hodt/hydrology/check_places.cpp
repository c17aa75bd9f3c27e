#include "hodt/hydrology/check_places.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "hodt/base/error.h"

namespace hodt {

namespace {

bool is_finite(const Point& p) {
  return std::isfinite(p.x) && std::isfinite(p.y);
}

/// "feature 3 of lakes.geojson", or "polygon 3 of the places" if nothing is known of a source.
std::string name_of(const Places& places, const std::vector<Index>& parts, std::string_view kind,
                    std::size_t i) {
  if (i < parts.size()) return fmt::format("{} {} of {}", places.part, parts[i], places.source);
  return fmt::format("{} {} of the places", kind, i);
}

class Checker {
 public:
  Checker(const Places& places, std::span<const Point> points)
      : places_(places), box_(box_of(points)) {}

  void check() const {
    for (std::size_t i = 0; i < places_.points.size(); ++i) check_point(i);
    for (std::size_t i = 0; i < places_.polygons.size(); ++i) check_polygon(i);
  }

 private:
  void check_point(std::size_t i) const {
    const Point& p = places_.points[i];
    const std::string name = name_of(places_, places_.part_of_point, "point", i);
    if (!is_finite(p)) throw InputError(fmt::format("{} has a coordinate that is no number", name));
    if (is_far(p))
      refuse(fmt::format("{}, at {}, {}, is farther from the points than they are wide", name, p.x,
                         p.y));
  }

  void check_polygon(std::size_t i) const {
    const auto& rings = places_.polygons[i].rings;
    const std::string name = name_of(places_, places_.part_of_polygon, "polygon", i);
    if (rings.empty() ||
        std::any_of(rings.begin(), rings.end(), [](const auto& ring) { return ring.size() < 3; }))
      throw InputError(fmt::format("{} has a ring of fewer than three corners", name));
    for (const auto& ring : rings)
      if (!std::all_of(ring.begin(), ring.end(), is_finite))
        throw InputError(fmt::format("{} has a coordinate that is no number", name));
    if (!meet(box_of(rings[0]), box_))
      refuse(fmt::format("{}, a polygon at {}, {}, lies outside the points", name, rings[0][0].x,
                         rings[0][0].y));
  }

  /// By halves, which no difference is out of range of.
  bool is_far(const Point& p) const {
    const auto beyond = [](double at, double low, double high) {
      return std::max({low / 2 - at / 2, at / 2 - high / 2, 0.0});
    };
    const double width =
        std::max(box_.high.x / 2 - box_.low.x / 2, box_.high.y / 2 - box_.low.y / 2);
    return std::max(beyond(p.x, box_.low.x, box_.high.x), beyond(p.y, box_.low.y, box_.high.y)) >
           width;
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(fmt::format(
        "{} (x {} to {}, y {} to {}); give the places in the points' coordinate system, and cut "
        "off those elsewhere",
        what, box_.low.x, box_.high.x, box_.low.y, box_.high.y));
  }

  const Places& places_;
  Box box_;
};

}  // namespace

void check_places(const Places& places, std::span<const Point> points) {
  Checker(places, points).check();
}

void check_polygons_hold_points(const Places& places, const Buffer<bool>& holds_point) {
  if (places.polygons.empty() ||
      std::any_of(holds_point.begin(), holds_point.end(), [](bool holds) { return holds; }))
    return;
  const Point& corner = places.polygons[0].rings[0][0];
  throw InputError(fmt::format(
      "no point is in {}, a polygon at {}, {}{}; give the polygons in the points' coordinate "
      "system, and large enough to hold one",
      name_of(places, places.part_of_polygon, "polygon", 0), corner.x, corner.y,
      places.polygons.size() > 1 ? ", nor in any other" : ""));
}

}  // namespace hodt
