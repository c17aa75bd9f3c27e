#include "hodt/picture/picture.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "hodt/base/error.h"
#include "hodt/picture/difference.h"
#include "hodt/picture/legend.h"
#include "hodt/picture/order_colours.h"
#include "hodt/picture/relief.h"
#include "hodt/picture/svg.h"
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
  EXPECT_EQ(found.minima.before(), 2u);
  EXPECT_EQ(found.minima.vanished, (std::vector<Index>{0}));
  EXPECT_EQ(found.minima.remaining, (std::vector<Index>{1}));
  EXPECT_TRUE(found.minima.made.empty());
  EXPECT_EQ(found.maxima.remaining, (std::vector<Index>{3}));
  EXPECT_EQ(found.maxima.made, (std::vector<Index>{2}));
  const Difference back = difference(drained(), dammed());
  EXPECT_EQ(back.minima.made, (std::vector<Index>{0}));
  EXPECT_EQ(back.minima.after(), 2u);
  EXPECT_EQ(back.maxima.vanished, (std::vector<Index>{2}));
}

TEST(Difference, BreaksEqualHeightsByPlace) {
  Tin level = dammed();
  level.points.z = {1, 1, 1, 1};
  // Lowest by (z, x, y): 0. Vertex 1 has the neighbours 2 and 3, which lie further west.
  EXPECT_EQ(difference(level, level).minima.remaining, (std::vector<Index>{0}));
}

TEST(Difference, SetsMinimaApartThatWereToStay) {
  const std::vector<Index> kept = {0, 1, 3};
  const Difference same = difference(dammed(), dammed(), kept);
  EXPECT_EQ(same.minima.kept, (std::vector<Index>{0, 1}));
  EXPECT_TRUE(same.minima.remaining.empty());
  EXPECT_EQ(same.minima.before(), 2u);
  EXPECT_EQ(same.minima.after(), 2u);
  const Difference found = difference(dammed(), drained(), std::vector<Index>{0});
  EXPECT_TRUE(found.minima.kept.empty()) << "it went";
  EXPECT_EQ(found.minima.remaining, (std::vector<Index>{1}));
}

TEST(Difference, CountsNoVertexWithoutTriangle) {
  Tin tin = dammed();
  tin.points.xy.push_back({9, 9});
  tin.points.z.push_back(-5);
  EXPECT_EQ(difference(tin, tin).minima.before(), 2u);
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
  EXPECT_EQ(again.low, window.low);
}

TEST(Window, StaysWithinThePoints) {
  const std::vector<Point> points = {{0, 0}, {100, 0}, {0, 100}, {100, 100}};
  const Window corner = best_window(points, std::vector<Point>{{0, 0}}, 30);
  EXPECT_GE(corner.low.x, 0);
  EXPECT_LE(corner.high.y, 100);
  const Window middle = best_window(points, {}, 100);
  EXPECT_EQ(middle.low, (Point{0, 0}));
}

TEST(Relief, IsBrighterTowardsTheLamp) {
  // Ground that rises to the south-east faces the lamp in the north-west.
  EXPECT_GT(shaded(0.5, 0.5, -0.5), shaded(0.5, 0, 0));
  EXPECT_LT(shaded(0.5, -0.5, 0.5), shaded(0.5, 0, 0));
  EXPECT_EQ(tint(-1), tint(0));
  EXPECT_EQ(tint(2), tint(1));
}

TEST(Difference, TellsTheLargerOrderAtANewEdge) {
  Tin after = drained();
  after.order = {1, 3};
  EXPECT_EQ(difference(dammed(), after).added_order, (std::vector<Index>{3}));
  EXPECT_TRUE(difference(dammed(), drained()).added_order.empty());
}

TEST(OrderClasses, HoldEveryEdgeOnce) {
  Difference changes;
  for (Index order = 1; order <= 40; ++order) {
    changes.added.push_back({0, order});
    changes.added_order.push_back(order);
  }
  std::vector<std::string> labels;
  Index next = 1;
  for (const OrderClass& each : order_classes(changes)) {
    labels.push_back(each.label());
    for (const Edge& edge : each.edges) EXPECT_EQ(edge[1], next++);
  }
  EXPECT_EQ(next, 41u);
  EXPECT_EQ(labels, (std::vector<std::string>{
                        "new edge of order 1", "new edge of order 2", "new edge of order 3 to 4",
                        "new edge of order 5 to 8", "new edge of order 9 to 40"}));
  changes.added_order.resize(4);
  changes.added.resize(4);
  EXPECT_EQ(order_classes(changes).back().label(), "new edge of order 4");
  changes.added_order.clear();
  EXPECT_EQ(order_classes(changes).at(0).label(), "new edge");
  EXPECT_TRUE(order_classes({}).empty());
}

TEST(Wrapped, BreaksAtSpacesAndCutsLongWords) {
  EXPECT_EQ(wrapped("one two  three", 7), (std::vector<std::string>{"one two", "three"}));
  EXPECT_EQ(wrapped("äöüäöü", 6), (std::vector<std::string>{"äöüäöü"}));
  EXPECT_EQ(wrapped("äöüäöüä", 6), (std::vector<std::string>{"äöüäö…"}));
  EXPECT_TRUE(wrapped(" ", 6).empty());
}

TEST(Legend, RoundsNumbersToTheirRange) {
  EXPECT_EQ(number_within(305.4, 305.4, 672.1), "305");
  EXPECT_EQ(number_within(0.012345, 0.01, 0.02), "0.0123");
  EXPECT_EQ(number_within(5, 5, 5), "5");
  EXPECT_EQ(number_within(1e300, 0, 1e300), "1e+300");
}

/// Packs nothing, and says what it was given.
std::string pack_of(const Image& image) {
  EXPECT_EQ(image.pixels.size(), image.width * image.height);
  EXPECT_LE(image.colours.size(), 256u);
  for (const auto pixel : image.pixels) EXPECT_LT(pixel, image.colours.size());
  return "abcd";
}

/// A lattice of n by n with heights, cut along one or the other diagonal.
Tin lattice(Index n, bool turned) {
  Tin tin;
  for (Index y = 0; y < n; ++y)
    for (Index x = 0; x < n; ++x) {
      tin.points.xy.push_back({double(x), double(y)});
      tin.points.z.push_back((x * 7 + y * 13) % 5);
    }
  for (Index y = 0; y + 1 < n; ++y)
    for (Index x = 0; x + 1 < n; ++x) {
      const Index a = y * n + x, b = a + 1, c = b + n, d = a + n;
      if (turned) {
        tin.triangles.push_back({a, b, d});
        tin.triangles.push_back({b, c, d});
      } else {
        tin.triangles.push_back({a, b, c});
        tin.triangles.push_back({a, c, d});
      }
    }
  return tin;
}

std::string svg_of(const Tin& before, const Tin& after, const PictureOptions& options = {}) {
  std::string svg = comparison_picture(before, after, options).svg;
  EXPECT_TRUE(well_formed(svg));
  return svg;
}

TEST(Picture, IsWellFormedAndTheSameEachTime) {
  PictureOptions options;
  options.title = "A & B <k = \"8\">";
  options.caption = "no height changed & so on";
  const std::string svg = svg_of(strip(40, false), strip(40, true), options);
  EXPECT_EQ(svg.substr(0, 4), "<svg");
  EXPECT_NE(svg.find("A &amp; B &lt;k = &quot;8&quot;&gt;"), std::string::npos);
  EXPECT_EQ(svg, svg_of(strip(40, false), strip(40, true), options));
}

TEST(Picture, MarksTheMinimaInTheWindow) {
  PictureOptions options;
  options.window = Window{{-1, -3}, {25, 3}};  // three of the diamonds, ten apart
  const std::string svg = svg_of(strip(40, false), strip(40, true), options);
  EXPECT_EQ(count(svg, "class=\"vanished\""), 3u);
  EXPECT_EQ(count(svg, "class=\"gone\""), 3u);
  EXPECT_EQ(count(svg, "class=\"remains\""), 6u);
  EXPECT_NE(svg.find("local minimum that goes (3 here)"), std::string::npos);
  EXPECT_NE(svg.find("edge that goes (3 here)"), std::string::npos);
  EXPECT_NE(svg.find("new edge (3 here)"), std::string::npos);
  EXPECT_NE(svg.find(": 80 local minima"), std::string::npos);
  EXPECT_NE(svg.find(": 40 local minima"), std::string::npos);
}

TEST(Picture, ShowsTheWholeOfSmallTerrains) {
  const std::string svg = svg_of(dammed(), drained());
  EXPECT_EQ(count(svg, "class=\"vanished\""), 1u);
  EXPECT_EQ(count(svg, "class=\"remains\""), 2u);
  EXPECT_EQ(count(svg, "the part shown"), 0u);
}

TEST(Picture, ShowsNothingVanishedWhereNothingChanged) {
  const std::string svg = svg_of(strip(3, false), strip(3, false));
  EXPECT_EQ(count(svg, "class=\"vanished\""), 0u);
}

TEST(Picture, ShowsWhereALargeTerrainChanges) {
  // All is the same but in a corner.
  Tin before = lattice(80, false), after = before;
  const Tin turned = lattice(80, true);
  for (const std::size_t square : {70u + 70 * 79u, 72u + 70 * 79u})
    for (std::size_t t = 2 * square; t < 2 * square + 2; ++t)
      after.triangles[t] = turned.triangles[t];
  const Picture picture = comparison_picture(before, after);
  EXPECT_TRUE(picture.view.contains({70, 70}));
  EXPECT_TRUE(picture.view.contains({73, 71}));
  EXPECT_LT(picture.view.width(), 30);
  EXPECT_EQ(count(picture.svg, "the part shown"), 1u);
}

TEST(Picture, DrawsManyTrianglesAsAnImage) {
  const Tin before = lattice(130, false), after = lattice(130, true);
  PictureOptions options;
  options.window = Window{{0, 0}, {129, 129}};
  options.pack = pack_of;
  const std::string svg = svg_of(before, after, options);
  EXPECT_EQ(count(svg, "href=\"data:image/png;base64,YWJjZA==\""), 2u);
  EXPECT_EQ(count(svg, "class=\"kept\""), 0u) << "nobody could tell them apart";
  EXPECT_EQ(count(svg, "<g class=\"added\""), 2u) << "with their halo";
}

TEST(Picture, GoesWithoutHeights) {
  Tin before = dammed(), after = drained();
  before.points.z.clear();
  after.points.z.clear();
  after.order = {1, 1};
  const std::string svg = svg_of(before, after);
  EXPECT_EQ(count(svg, "minim"), 0u);
  EXPECT_NE(svg.find("new edge of order 1 (1 here)"), std::string::npos);
}

TEST(Picture, ShowsMaximaWhereTheyMatter) {
  PictureOptions options;
  options.minima = false;
  options.maxima = true;
  const std::string svg = svg_of(drained(), dammed(), options);
  EXPECT_EQ(count(svg, "class=\"vanished peak\""), 1u);
  EXPECT_EQ(count(svg, "minim"), 0u);
  EXPECT_NE(svg.find(": 2 local maxima"), std::string::npos);
  EXPECT_NE(svg.find(": 1 local maxima"), std::string::npos);
}

TEST(Picture, SaysTheUnits) {
  PictureOptions options;
  EXPECT_NE(svg_of(dammed(), drained(), options).find(">0.5 units of x and y<"), std::string::npos);
  options.unit = "°";
  const std::string svg = svg_of(dammed(), drained(), options);
  EXPECT_NE(svg.find(">0.5°<"), std::string::npos) << svg;
  EXPECT_NE(svg.find("degrees"), std::string::npos);
  options.unit = options.height_unit = "m";
  options.window = Window{{-5000, -5000}, {5000, 5000}};
  const std::string metres = svg_of(dammed(), drained(), options);
  EXPECT_NE(metres.find(">2 km<"), std::string::npos);
  EXPECT_NE(metres.find(">1.00 to 9.00 m<"), std::string::npos);
}

TEST(Picture, TakesExtremeCoordinatesAndWindows) {
  for (const double scale : {1e-300, 1e-9, 1e150, 1e300}) {
    Tin before = dammed(), after = drained();
    for (Tin* tin : {&before, &after})
      for (Point& p : tin->points.xy) p = {p.x * scale, p.y * scale};
    const std::string svg = svg_of(before, after);
    EXPECT_EQ(count(svg, "nan"), 0u) << scale;
    EXPECT_EQ(count(svg, "inf\""), 0u) << scale;
  }
  PictureOptions options;
  options.window = Window{{-1, -1e-9}, {5, 1e-9}};
  const Picture narrow = comparison_picture(dammed(), drained(), options);
  EXPECT_EQ(narrow.view.width(), 6);
  EXPECT_GT(narrow.view.height(), 0.5);
}

TEST(Picture, RefusesWhatCannotBeCompared) {
  EXPECT_THROW(comparison_picture(strip(2, false), strip(3, true)), ParameterError);
  EXPECT_THROW(comparison_picture(Tin{}, Tin{}), ParameterError);
  PictureOptions options;
  options.window = Window{{100, 100}, {101, 101}};
  EXPECT_THROW(comparison_picture(dammed(), drained(), options), ParameterError);
  options.window = Window{{1, 1}, {1, 1}};
  EXPECT_THROW(comparison_picture(dammed(), drained(), options), ParameterError);
  options.window = Window{{0, 0}, {400, 400}};
  EXPECT_THROW(comparison_picture(lattice(400, false), lattice(400, true), options), ParameterError)
      << "300 thousand changed edges in one picture";
}

}  // namespace
}  // namespace hodt
