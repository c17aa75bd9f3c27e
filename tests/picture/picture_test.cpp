#include "hodt/picture/picture.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "hodt/base/error.h"
#include "hodt/picture/difference.h"
#include "hodt/picture/relief.h"
#include "hodt/picture/window.h"

namespace hodt {
namespace {

/// Two hills with a pass between them, and two hollows on either side of the pass: the edge along
/// the ridge dams the higher hollow, the edge through the pass drains it.
///
///      3 (9)
///     /   \          .
///  0 (2)  1 (1)
///     \   /
///      2 (8)
Tin diamond(std::vector<std::array<Index, 3>> triangles) {
  return {{{{0, 0}, {4, 0}, {2, -2}, {2, 2}}, {2, 1, 8, 9}}, std::move(triangles), ""};
}
Tin dammed() {
  return diamond({{0, 2, 3}, {2, 1, 3}});
}
Tin drained() {
  return diamond({{0, 2, 1}, {0, 1, 3}});
}

/// A strip of `n` diamonds side by side.
Tin strip(std::size_t n, bool drain) {
  Tin result;
  for (std::size_t i = 0; i < n; ++i) {
    const Tin one = drain ? drained() : dammed();
    const auto offset = static_cast<Index>(result.points.size());
    for (const Point& p : one.points.xy) {
      result.points.xy.push_back({p.x + 10.0 * static_cast<double>(i), p.y});
    }
    result.points.z.insert(result.points.z.end(), one.points.z.begin(), one.points.z.end());
    for (const auto& t : one.triangles) {
      result.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
    }
  }
  return result;
}

std::size_t count(std::string_view text, std::string_view part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
  return found;
}

/// Every tag closes in the right order, quotes are balanced within tags, no stray '&' or '<'.
bool well_formed(std::string_view text) {
  std::vector<std::string> open;
  while (true) {
    const std::size_t begin = text.find('<');
    const std::string_view content = text.substr(0, begin);
    for (std::size_t at = content.find('&'); at != content.npos; at = content.find('&', at + 1)) {
      const std::string_view entity = content.substr(at, content.find(';', at) - at);
      if (entity != "&amp" && entity != "&lt" && entity != "&gt" && entity != "&quot") return false;
    }
    if (begin == text.npos) return open.empty();
    const std::size_t end = text.find('>', begin);
    if (end == text.npos) return false;
    std::string_view tag = text.substr(begin + 1, end - begin - 1);
    text.remove_prefix(end + 1);
    if (count(tag, "\"") % 2 != 0 || tag.find('<') != tag.npos) return false;
    if (tag.front() == '/') {
      if (open.empty() || open.back() != tag.substr(1)) return false;
      open.pop_back();
    } else if (tag.back() != '/') {
      open.emplace_back(tag.substr(0, tag.find(' ')));
    }
  }
}

TEST(Difference, FindsEdgesAndMinima) {
  const Difference found = difference(dammed(), drained());
  EXPECT_EQ(found.kept, (std::vector<Edge>{{0, 2}, {0, 3}, {1, 2}, {1, 3}}));
  EXPECT_EQ(found.removed, (std::vector<Edge>{{2, 3}}));
  EXPECT_EQ(found.added, (std::vector<Edge>{{0, 1}}));
  EXPECT_EQ(found.minima_before, 2u);
  EXPECT_EQ(found.vanished_minima, (std::vector<Index>{0}));
  EXPECT_EQ(found.remaining_minima, (std::vector<Index>{1}));
}

TEST(Difference, BreaksEqualHeightsByPlace) {
  Tin level = dammed();
  level.points.z = {1, 1, 1, 1};
  // Lowest by (z, x, y): 0. Vertex 1 has the neighbours 2 and 3, which lie further west.
  EXPECT_EQ(difference(level, level).remaining_minima, (std::vector<Index>{0}));
}

TEST(Difference, CountsNoVertexWithoutTriangle) {
  Tin tin = dammed();
  tin.points.xy.push_back({9, 9});
  tin.points.z.push_back(-5);
  EXPECT_EQ(difference(tin, tin).minima_before, 2u);
}

TEST(Window, HoldsMostTargets) {
  std::vector<Point> points;
  for (int i = 0; i < 400; ++i) points.push_back({double(i % 20), double(i / 20)});
  std::vector<Point> targets = {{1, 1}, {10, 10}, {11, 11}, {11, 10}, {18, 3}};
  const Window window = best_window(points, targets, 4);
  EXPECT_EQ(std::count_if(targets.begin(), targets.end(),
                          [&](const Point& p) { return window.contains(p); }),
            3);
  std::reverse(targets.begin(), targets.end());
  std::reverse(points.begin(), points.end());
  const Window again = best_window(points, targets, 4);
  EXPECT_EQ(again.south_west, window.south_west);
}

TEST(Window, StaysWithinThePoints) {
  const std::vector<Point> points = {{0, 0}, {100, 0}, {0, 100}, {100, 100}};
  const Window corner = best_window(points, std::vector<Point>{{0, 0}}, 30);
  EXPECT_GE(corner.south_west.x, 0);
  EXPECT_LE(corner.south_west.y + corner.side, 100);
  const Window middle = best_window(points, {}, 100);
  EXPECT_EQ(middle.south_west, (Point{0, 0}));
}

TEST(Relief, IsBrighterTowardsTheLamp) {
  // Ground that rises to the south-east faces the lamp in the north-west.
  EXPECT_GT(shaded(0.5, 0.5, -0.5), shaded(0.5, 0, 0));
  EXPECT_LT(shaded(0.5, -0.5, 0.5), shaded(0.5, 0, 0));
  EXPECT_EQ(tint(-1), tint(0));
  EXPECT_EQ(tint(2), tint(1));
}

TEST(Picture, IsWellFormedAndTheSameEachTime) {
  const PictureOptions options{"A & B <k = \"8\">", "no height changed & so on", 0};
  const std::string svg = svg_comparison(strip(40, false), strip(40, true), options);
  EXPECT_TRUE(well_formed(svg));
  EXPECT_EQ(svg.substr(0, 4), "<svg");
  EXPECT_NE(svg.find("A &amp; B &lt;k = &quot;8&quot;&gt;"), std::string::npos);
  EXPECT_EQ(svg, svg_comparison(strip(40, false), strip(40, true), options));
}

TEST(Picture, MarksTheMinimaInTheWindow) {
  // A window of side 26 can hold the hollows at 0 of three diamonds, ten apart.
  const std::string svg = svg_comparison(strip(40, false), strip(40, true), {"", "", 26});
  EXPECT_EQ(count(svg, "class=\"vanished\""), 3u);
  EXPECT_NE(svg.find("vanishing minimum (3 here)"), std::string::npos);
  EXPECT_NE(svg.find("80 → 40"), std::string::npos);
}

TEST(Picture, ShowsTheWholeOfSmallTerrains) {
  const std::string svg = svg_comparison(dammed(), drained());
  EXPECT_EQ(count(svg, "class=\"vanished\""), 1u);
  EXPECT_EQ(count(svg, "class=\"remains\""), 1u);
}

TEST(Picture, ShowsNothingVanishedWhereNothingChanged) {
  const std::string svg = svg_comparison(strip(3, false), strip(3, false));
  EXPECT_TRUE(well_formed(svg));
  EXPECT_EQ(count(svg, "class=\"vanished\""), 0u);
}

TEST(Picture, RefusesWhatCannotBeCompared) {
  EXPECT_THROW(svg_comparison(strip(2, false), strip(3, true)), ParameterError);
  EXPECT_THROW(svg_comparison(Tin{}, Tin{}), ParameterError);
  Tin flat = dammed();
  flat.points.z.clear();
  EXPECT_THROW(svg_comparison(flat, flat), ParameterError);
}

}  // namespace
}  // namespace hodt
