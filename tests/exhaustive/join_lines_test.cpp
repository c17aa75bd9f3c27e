// Points and lines joined: by hand, and lines at random that are split where they cross.
#include "hodt/pipeline/join_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "families.h"
#include <gmpxx.h>
#include <gtest/gtest.h>

#include "hodt/base/error.h"
#include "hodt/pipeline.h"
#include "hodt/pipeline/constrain.h"

namespace hodt {
namespace {

using Edge = Constraints::Edge;
using Edges = std::vector<Edge>;
using Heights = std::vector<double>;

/// A square of side 10; the heights are those of the plane 1 + x + 2 y.
PointSet square() {
  return {{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {1, 11, 31, 21}};
}

Lines lines(std::vector<Line> parts) {
  Index number = 0;
  for (Line& line : parts) line.part = ++number;
  return {std::move(parts), "roads.geojson", "feature"};
}

Joined join(const PointSet& points, const Lines& source, const JoinOptions& options = {}) {
  return join_lines(points, std::array{source}, {}, options);
}

/// What is thrown by join().
std::string error_of(const PointSet& points, const Lines& source, const JoinOptions& options = {}) {
  try {
    join(points, source, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// ---- Vertices and heights. ----

TEST(JoinLines, VerticesBecomePointsAfterThoseThatAreThere) {
  const Joined joined = join(square(), lines({{{{2, 3}, {4, 5}, {10, 10}}, {7, 8, 31}}}));
  const std::vector<Point> xy{{0, 0}, {10, 0}, {10, 10}, {0, 10}, {2, 3}, {4, 5}};
  EXPECT_EQ(joined.points.xy, xy);
  EXPECT_EQ(joined.points.z, (Heights{1, 11, 31, 21, 7, 8}));
  EXPECT_EQ(joined.constraints.edges, (Edges{{4, 5}, {5, 2}}));
  EXPECT_TRUE(joined.constraints.boundary.empty());
  EXPECT_EQ(joined.report.added, 2u);
  EXPECT_EQ(joined.report.at_points, 1u);
  EXPECT_EQ(joined.report.soft, 0u);
  EXPECT_EQ(joined.report.heights_replaced, 0u);  // 31 was there
  EXPECT_EQ(joined.place_of(1), "roads.geojson, feature 1, between x 4, y 5 and x 10, y 10");
}

TEST(JoinLines, TheLinesHeightWinsOverAllPointsAtItsPlace) {
  PointSet points = square();
  for (const double z : {7.0, 6.0, 8.0}) {
    points.xy.push_back({5, 5});
    points.z.push_back(z);
  }
  const Joined joined =
      join(points, lines({{{{5, 5}, {8, 5}}, {9.5, 1}}, {{{-0.0, 0}, {5, 5}}, {0, 9.5}}}));
  EXPECT_EQ(joined.points.z, (Heights{0, 11, 31, 21, 9.5, 9.5, 9.5, 1}));
  EXPECT_EQ(joined.report.at_points, 3u);
  EXPECT_EQ(joined.report.added, 1u);
  EXPECT_EQ(joined.report.heights_replaced, 2u);
  EXPECT_EQ(joined.report.largest_replacement,
            3.5);  // the lowest of the points was the one to stay
  EXPECT_EQ(joined.report.heights_in_conflict, 0u);
  const TriangulateResult result = triangulate(joined.points, {}, joined.constraints);
  EXPECT_EQ(result.report.duplicates, 2u);
  EXPECT_EQ(result.report.constraints.walls, 2u);
}

TEST(JoinLines, LinesThatDifferInHeightAreCountedAndTheFirstOneCounts) {
  const Joined joined = join(square(), lines({{{{5, 5}, {6, 6}}, {1, 2}},
                                              {{{6, 6}, {7, 5}}, {5, 0}},
                                              {{{6, 6}, {7, 7}}, {-4, 0}},
                                              {{{10, 0}, {6, 6}}, {12, 2}}}));
  EXPECT_EQ(joined.points.z, (Heights{1, 12, 31, 21, 1, 2, 0, 0}));
  EXPECT_EQ(joined.report.heights_in_conflict, 2u);
  EXPECT_EQ(joined.report.largest_conflict, 6);
  EXPECT_EQ(joined.report.heights_replaced, 1u);
  EXPECT_EQ(joined.report.largest_replacement, 1);
}

TEST(JoinLines, ARingsLastVertexIsItsFirst) {
  const Line ring{{{2, 2}, {8, 2}, {10, 10}, {2, 8}, {2, 2}}, {1, 1, 1, 1, 1}};
  const Joined joined = join(square(), lines({ring}));
  EXPECT_EQ(joined.report.added, 3u);
  EXPECT_EQ(joined.report.at_points, 1u);
  EXPECT_EQ(joined.report.heights_replaced, 1u);
  EXPECT_EQ(joined.report.heights_in_conflict, 0u);
  EXPECT_EQ(joined.constraints.edges, (Edges{{4, 5}, {5, 2}, {2, 6}, {6, 4}}));
}

TEST(JoinLines, ALineThatReturnsAtAnotherHeightIsInConflict) {
  const Joined joined = join(square(), lines({{{{2, 2}, {8, 2}, {5, 6}, {2, 2}}, {1, 2, 3, 4.5}}}));
  EXPECT_EQ(joined.points.z, (Heights{1, 11, 31, 21, 1, 2, 3}));
  EXPECT_EQ(joined.report.added, 3u);
  EXPECT_EQ(joined.report.heights_in_conflict, 1u);
  EXPECT_EQ(joined.report.largest_conflict, 3.5);
}

TEST(JoinLines, PointsWithoutHeightsStayWithout) {
  PointSet points = square();
  points.z.clear();
  const Joined joined =
      join(points,
           lines({{{{1, 1}, {9, 9}}, {3, 4}}, {{{1, 9}, {9, 1}}, {}}, {{{0, 0}, {1, 1}}, {7, 8}}}),
           {.split_crossings = true});
  EXPECT_TRUE(joined.points.z.empty());
  EXPECT_EQ(joined.points.size(), 9u);
  EXPECT_EQ(joined.report.soft, 0u);
  EXPECT_EQ(joined.report.heights_replaced, 0u);
  EXPECT_EQ(joined.report.heights_in_conflict, 0u);
  EXPECT_EQ(joined.report.crossings, 1u);
  EXPECT_EQ(joined.report.largest_crossing_difference, 0);
}

TEST(JoinLines, SoftVerticesTakeTheHeightOfTheSurface) {
  // Two triangles with a valley between them, at x = 5.
  const PointSet roof{{{0, 0}, {10, 0}, {5, 3}, {5, -3}}, {10, 10, 0, 0}};
  const Joined joined = join(roof, lines({{{{2.5, 0}, {5, 1}}, {}},  // inside; on an edge
                                          {{{2.5, 1.5}, {5, 3}, {7.5, 0}}, {}}}));  // hull; a point
  EXPECT_EQ(joined.points.z, (Heights{10, 10, 0, 0, 5, 0, 5, 5}));
  EXPECT_EQ(joined.report.soft, 4u);
  EXPECT_EQ(joined.report.added, 4u);
  EXPECT_EQ(joined.report.at_points, 1u);
  EXPECT_EQ(joined.report.heights_replaced, 0u);
}

TEST(JoinLines, TheSurfaceHasTheLinesWithHeights) {
  const PointSet points{{{0, 0}, {10, 0}, {5, 10}}, {0, 0, 0}};
  // Whichever comes first in the file.
  for (const bool is_soft_first : {false, true}) {
    std::vector<Line> parts{{{{5, 5}, {5, 6}}, {8, 8}}, {{{5, 2.5}, {5, 5}}, {}}};
    if (is_soft_first) std::swap(parts[0], parts[1]);
    const Joined joined = join(points, lines(parts));
    EXPECT_EQ(joined.points.z, (Heights{0, 0, 0, 8, 8, 4}));
    EXPECT_EQ(joined.report.soft, 1u);
    EXPECT_EQ(joined.report.added, 3u);
    EXPECT_EQ(joined.report.at_points, 0u);
    EXPECT_EQ(joined.constraints.edges[is_soft_first ? 0 : 1], (Edge{5, 3}));
  }
}

TEST(JoinLines, HeightsThatLinesPassThroughStayAndAreTold) {
  PointSet points = square();
  points.xy.insert(points.xy.end(), {{3, 4}, {5, 4}, {7, 4}});
  points.z.insert(points.z.end(), {60, 100, 120});
  const Line passing{{{1, 4}, {9, 4}}, {20, 180}}, ending{{{4, 4}, {4, 6}}, {50, 1}};
  const Joined joined = join(points, lines({passing, ending}));
  EXPECT_EQ(joined.points.z[4], 60);
  EXPECT_EQ(joined.points.z[5], 100);
  EXPECT_EQ(joined.points.z[6], 120);
  // 60 and 100 are on the line; 120 is not 140, and the other line ends at 50, not at 80.
  EXPECT_EQ(joined.report.heights_passed, 2u);
  EXPECT_EQ(joined.report.largest_passed, 30);
  EXPECT_EQ(joined.report.heights_in_conflict, 0u);
}

TEST(JoinLines, TheSurfaceBendsAtLinesWithHeights) {
  const PointSet flat{{{0, 0}, {10, 0}, {20, 0}, {0, 10}, {10, 10}, {20, 10}}, {0, 0, 0, 0, 0, 0}};
  const Line embankment{{{1, 5}, {19, 5}}, {100, 100}}, ditch{{{10, 5}, {10, 7.5}}, {}};
  for (const auto& parts : {std::vector{embankment, ditch}, std::vector{ditch, embankment}}) {
    const Joined joined = join(flat, lines(parts));
    EXPECT_EQ(joined.points.z, (Heights{0, 0, 0, 0, 0, 0, 100, 100, 100, 50}));
  }
}

TEST(JoinLines, TheSurfaceOfAMeshIsItsOwn) {
  // Not the Delaunay triangulation's, which has the other diagonal.
  const PointSet ridge{{{0, 0}, {4, -1.5}, {8, 0}, {4, 1.5}}, {100, 0, 100, 0}};
  const std::vector<std::array<Index, 3>> triangles{{0, 1, 2}, {0, 2, 3}};
  const Lines line = lines({{{{4, 0}, {4, 1.5}}, {}}});
  EXPECT_EQ(join(ridge, line).points.z[4], 0);
  EXPECT_EQ(join(ridge, line, {.surface = triangles}).points.z[4], 100);
}

TEST(JoinLines, OutsideThereIsNoHeightToTake) {
  const Lines source = lines({{{{1, 1}, {11, 1}}, {3, 3}}, {{{5, 5}, {10.9, 9}}, {}}});
  const std::string error = error_of({{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {0, 0, 0, 0}},
                                     lines({{{{5, 5}, {10.5, 5}}, {}}}));
  EXPECT_NE(error.find("roads.geojson, feature 1: its vertex at x 10.5, y 5"), std::string::npos)
      << error;
  EXPECT_EQ(error_of(square(), source).find("roads.geojson, feature 2"), 0u)
      << error_of(square(), source);
  // A line with heights may leave the points, and takes the surface along.
  EXPECT_EQ(error_of(square(), lines({{{{9, 5}, {20, 5}}, {0, 10}}, {{{11, 5}, {9, 6}}, {}}})), "");
  PointSet flat = square();
  flat.z.clear();
  EXPECT_EQ(error_of(flat, source), "");
}

TEST(JoinLines, AnOutlineIsTheBoundary) {
  const Outline outline{{{{{2, 2}, {8, 2}, {8, 8}, {2, 2}}, {}, 1}}, "area.geojson", "feature"};
  const Joined joined =
      join_lines(square(), std::array{lines({{{{0, 0}, {2, 2}}, {1, 50}}})}, outline);
  EXPECT_EQ(joined.constraints.edges, (Edges{{0, 4}}));
  EXPECT_EQ(joined.constraints.boundary, (Edges{{4, 5}, {5, 6}, {6, 4}}));
  EXPECT_EQ(joined.points.z[4], 50);
  EXPECT_EQ(joined.report.soft, 2u);
  EXPECT_EQ(joined.place_of(0), "roads.geojson, feature 1, between x 0, y 0 and x 2, y 2");
  EXPECT_EQ(joined.place_of(2), "area.geojson, feature 1, between x 8, y 2 and x 8, y 8");
}

// ---- Snapping. ----

TEST(JoinLines, VerticesSnapToTheNearestPointUpToTheDistance) {
  PointSet points = square();
  points.xy.push_back({7, 4});
  points.z.push_back(100);
  const Lines source = lines({{{{3, 4}, {6, 4.5}, {7, 4}}, {}}});
  const Joined exactly = join(points, source, {.snap = 5});  // (0, 0) is 5 away, (7, 4) is 4
  EXPECT_EQ(exactly.constraints.edges, (Edges{{4, 4}, {4, 4}}));
  EXPECT_EQ(exactly.report.snapped, 2u);    // not that which is there
  EXPECT_EQ(exactly.report.at_points, 2u);  // closed now
  EXPECT_EQ(exactly.report.added, 0u);
  EXPECT_EQ(exactly.points.size(), 5u);

  const Lines corner = lines({{{{3, 4}, {13, 14}}, {-1, -2}}});
  PointSet four = square();
  const Joined at = join(four, corner, {.snap = 5});
  EXPECT_EQ(at.constraints.edges, (Edges{{0, 2}}));
  EXPECT_EQ(at.points.z, (Heights{-1, 11, -2, 21}));
  EXPECT_EQ(at.report.snapped, 2u);
  EXPECT_EQ(at.report.heights_replaced, 2u);
  EXPECT_EQ(at.report.largest_replacement, 33);
  const Joined beyond = join(four, corner, {.snap = std::nextafter(5.0, 0.0)});
  EXPECT_EQ(beyond.report.snapped, 0u);
  EXPECT_EQ(beyond.report.added, 2u);
  EXPECT_EQ(beyond.points.xy[4], (Point{3, 4}));
}

TEST(JoinLines, ARingsFirstVertexSnapsOnce) {
  const Line ring{{{0.5, 0}, {8, 2}, {5, 6}, {0.5, 0}}, {}};
  const Joined joined = join(square(), lines({ring}), {.snap = 1});
  EXPECT_EQ(joined.report.snapped, 1u);
  EXPECT_EQ(joined.report.at_points, 1u);
  EXPECT_EQ(joined.report.added, 2u);
  EXPECT_EQ(joined.constraints.edges, (Edges{{0, 4}, {4, 5}, {5, 0}}));
}

TEST(JoinLines, OutlinesSnapToo) {
  const Outline outline{{{{{0, 0.25}, {10, 0}, {10, 9.75}, {0, 0.25}}, {}, 1}}, "a.geojson", ""};
  const Joined joined = join_lines(square(), {}, outline, {.snap = 0.25});
  EXPECT_EQ(joined.constraints.boundary, (Edges{{0, 1}, {1, 2}, {2, 0}}));
  EXPECT_EQ(joined.report.snapped, 2u);
  const TriangulateResult result = triangulate(joined.points, {}, joined.constraints);
  EXPECT_EQ(result.report.triangles, 1u);
  EXPECT_EQ(result.report.constraints.unused_points, 1u);
}

// ---- Crossings. ----

constexpr JoinOptions kSplit{.split_crossings = true, .snap = 0};

TEST(JoinLines, CrossingLinesAreNamed) {
  const Joined joined =
      join(square(), lines({{{{0, 1}, {1, 1}, {9, 9}}, {0, 0, 8}}, {{{1, 9}, {9, 1}}, {4, 4}}}));
  try {
    triangulate(joined.points, {}, joined.constraints);
    FAIL() << "no error";
  } catch (const CrossingError& error) {
    EXPECT_EQ(error.crossings(), (std::vector<CrossingEdges>{{1, 2}}));
    EXPECT_EQ(crossing_text(joined, error.crossings().front()),
              "lines cross near x 5, y 5: that of roads.geojson, feature 1, between x 1, y 1 and x "
              "9, y 9, and that of roads.geojson, feature 2, between x 1, y 9 and x 9, y 1");
  }
}

TEST(JoinLines, ACrossingGetsAVertexWithTheHeightOfTheLineNamedFirst) {
  const Joined joined =
      join(square(), lines({{{{0, 1}, {1, 1}, {9, 9}}, {0, 0, 8}}, {{{1, 9}, {9, 1}}, {4, 8.5}}}),
           kSplit);
  ASSERT_EQ(joined.points.size(), 10u);
  EXPECT_EQ(joined.points.xy[9], (Point{5, 5}));
  EXPECT_EQ(joined.points.z[9], 4);
  EXPECT_EQ(joined.report.crossings, 1u);
  EXPECT_EQ(joined.report.added, 5u);
  EXPECT_EQ(joined.report.largest_crossing_difference, 2.25);
  EXPECT_EQ(joined.constraints.edges, (Edges{{4, 5}, {5, 9}, {9, 6}, {7, 9}, {9, 8}}));
  EXPECT_EQ(joined.place_of(0), "roads.geojson, feature 1, between x 0, y 1 and x 1, y 1");
  EXPECT_EQ(joined.place_of(2), "roads.geojson, feature 1, between x 1, y 1 and x 9, y 9");
  EXPECT_EQ(joined.place_of(3), "roads.geojson, feature 2, between x 1, y 9 and x 9, y 1");
  EXPECT_EQ(joined.place_of(4), joined.place_of(3));
}

TEST(JoinLines, ACrossingWithALineWithoutHeightsHasThatOfTheOther) {
  const Line hard{{{1, 5}, {9, 5}}, {50, 50}}, soft{{{5, 1}, {5, 9}}, {}};
  for (const auto& parts : {std::vector{hard, soft}, std::vector{soft, hard}}) {
    const Joined joined = join(square(), lines(parts), kSplit);
    ASSERT_EQ(joined.report.crossings, 1u);
    EXPECT_EQ(joined.points.z.back(), 50);
  }
}

TEST(JoinLines, LinesAlongEachOtherAreNotSplitWithoutEnd) {
  // One straight line, four times, with other vertices each.
  std::vector<Line> parts;
  for (int i = 1; i <= 4; ++i) {
    Line line;
    for (const double t : {0.0, 0.11 * i, 0.2 + 0.1 * i, 0.93 - 0.013 * i, 1.0})
      line.xy.push_back({433000.1 + 900.2 * t, 5400000.1 + 777.6 * t});
    parts.push_back(line);
  }
  const PointSet corners{
      {{433000, 5400000}, {434000, 5400000}, {433000, 5401000}, {434000, 5401000}}, {1, 2, 3, 4}};
  try {
    EXPECT_LT(join(corners, lines(parts), kSplit).report.crossings, 100u);
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("along each other"), std::string::npos);
  }
}

TEST(JoinLines, ManyLinesThroughOnePlaceHaveOneVertexThere) {
  const Joined joined = join(square(),
                             lines({{{{1, 1}, {9, 9}}, {1, 1}},
                                    {{{1, 9}, {9, 1}}, {2, 2}},
                                    {{{5, 1}, {5, 9}}, {40, 40}},
                                    {{{1, 5}, {9, 5}}, {3, 3}}}),
                             kSplit);
  EXPECT_EQ(joined.report.crossings, 1u);
  ASSERT_EQ(joined.points.size(), 13u);
  EXPECT_EQ(joined.points.z[12], 1);
  // Not only of the two lines that were first.
  EXPECT_EQ(joined.report.largest_crossing_difference, 39);
  EXPECT_EQ(triangulate(joined.points, {}, joined.constraints).report.constraints.walls, 8u);
}

TEST(JoinLines, ACrossingAtAPointNeedsNoVertex) {
  PointSet points = square();
  points.xy.push_back({5, 5});
  points.z.push_back(77);
  const Lines source = lines({{{{4, 4}, {6, 6}}, {1, 1}}, {{{4, 6}, {6, 4}}, {2, 2}}});
  const Joined joined = join(points, source, kSplit);
  EXPECT_EQ(joined.report.crossings, 0u);
  EXPECT_EQ(joined.points.size(), 9u);
  EXPECT_EQ(joined.points.z[4], 77);
  EXPECT_EQ(joined.constraints.edges, (Edges{{5, 6}, {7, 8}}));
  EXPECT_EQ(triangulate(joined.points, {}, joined.constraints).report.constraints.walls, 4u);
}

TEST(JoinLines, TouchingAndOverlappingLinesDoNotCross) {
  const Joined joined = join(square(),
                             lines({{{{1, 1}, {9, 1}}, {1, 1}},
                                    {{{3, 1}, {3, 5}}, {1, 1}},    // ends on it
                                    {{{5, 1}, {12, 1}}, {1, 1}},   // runs along it
                                    {{{9, 1}, {1, 1}}, {1, 1}}}),  // again
                             kSplit);
  EXPECT_EQ(joined.report.crossings, 0u);
  EXPECT_EQ(triangulate(joined.points, {}, joined.constraints).report.constraints.walls, 5u);
}

TEST(JoinLines, LinesCrossOutlines) {
  const Outline outline{
      {{{{2, 2}, {8, 2}, {8, 8}, {2, 8}, {2, 2}}, {0, 0, 0, 0, 0}, 1}}, "area.geojson", "feature"};
  const Joined joined = join_lines(
      square(), std::array{lines({{{{0, 5}, {5, 5}, {9, 5}}, {0, 10, 20}}})}, outline, kSplit);
  EXPECT_EQ(joined.report.crossings, 2u);
  EXPECT_EQ(joined.report.largest_crossing_difference, 17.5);
  EXPECT_EQ(joined.constraints.edges.size(), 4u);
  EXPECT_EQ(joined.constraints.boundary.size(), 6u);
  for (Index e = 0; e < 4; ++e) EXPECT_EQ(joined.place_of(e).find("roads.geojson"), 0u);
  for (Index e = 4; e < 10; ++e) EXPECT_EQ(joined.place_of(e).find("area.geojson"), 0u);
  EXPECT_EQ(joined.place_of(5), "area.geojson, feature 1, between x 8, y 2 and x 8, y 8");
  EXPECT_EQ(joined.place_of(6), joined.place_of(5));
  const TriangulateResult result = triangulate(joined.points, {}, joined.constraints);
  EXPECT_EQ(result.tin.points.size(), 7u);
  EXPECT_EQ(result.report.constraints.unused_points, 6u);
  EXPECT_EQ(result.report.constraints.walls, 8u);  // six of the boundary, two within
}

// ---- At random, against exact arithmetic. ----

using ExactPoint = std::pair<mpq_class, mpq_class>;

ExactPoint exact(const Point& p) {
  return {mpq_class(p.x), mpq_class(p.y)};
}
int side(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
  return sgn(mpq_class((b.first - a.first) * (c.second - a.second) -
                       (b.second - a.second) * (c.first - a.first)));
}

/// Where the insides of two segments cross, if they do.
std::optional<ExactPoint> crossing(const std::array<Point, 2>& s, const std::array<Point, 2>& t) {
  const ExactPoint a = exact(s[0]), b = exact(s[1]), c = exact(t[0]), d = exact(t[1]);
  if (side(a, b, c) * side(a, b, d) >= 0 || side(c, d, a) * side(c, d, b) >= 0) return {};
  const mpq_class abx = b.first - a.first, aby = b.second - a.second;
  const mpq_class cdx = d.first - c.first, cdy = d.second - c.second;
  const mpq_class part =
      ((c.first - a.first) * cdy - (c.second - a.second) * cdx) / (abx * cdy - aby * cdx);
  return ExactPoint{a.first + part * abx, a.second + part * aby};
}

/// A pair of pieces that cross elsewhere than at a point, in words; empty if there is none.
std::string why_crossing(const Joined& joined) {
  std::vector<ExactPoint> places;
  for (const Point& p : joined.points.xy) places.push_back(exact(p));
  std::sort(places.begin(), places.end());
  std::vector<std::array<Point, 2>> pieces;
  for (const Edges* edges : {&joined.constraints.edges, &joined.constraints.boundary})
    for (const auto& [u, v] : *edges) pieces.push_back({joined.points.xy[u], joined.points.xy[v]});
  for (Index i = 0; i < pieces.size(); ++i)
    for (Index j = 0; j < i; ++j)
      if (const auto at = crossing(pieces[i], pieces[j]);
          at && !std::binary_search(places.begin(), places.end(), *at))
        return joined.place_of(j) + " and " + joined.place_of(i);
  return "";
}

double distance_to_segment(const Point& p, const Point& a, const Point& b) {
  using Real = long double;
  const Real dx = Real(b.x) - a.x, dy = Real(b.y) - a.y, length = std::hypot(dx, dy);
  if (length == 0) return std::hypot(p.x - a.x, p.y - a.y);
  return static_cast<double>(std::fabs((Real(p.x) - a.x) * dy - (Real(p.y) - a.y) * dx) / length);
}

/// Whether the pieces of each line are a chain along it, each vertex a few ulps from it at most.
std::string why_not_covered(const Joined& before, const Joined& joined, double ulp) {
  const auto edge = [](const Joined& of, std::size_t e) {
    const Constraints& c = of.constraints;
    return e < c.edges.size() ? c.edges[e] : c.boundary[e - c.edges.size()];
  };
  std::size_t next = 0;
  for (std::size_t e = 0; e < before.origins.size(); ++e) {
    const auto [from, to] = edge(before, e);
    const Point &a = before.points.xy[from], &b = before.points.xy[to];
    const Joined::Origin& origin = before.origins[e];
    Index last = from;
    bool is_first = true;
    for (; next < joined.origins.size(); ++next, is_first = false) {
      const auto& [s, l, i] = joined.origins[next];
      if (s != origin.source || l != origin.line || i != origin.segment) break;
      const auto [u, v] = edge(joined, next);
      if (u != last) return "a gap";
      if (distance_to_segment(joined.points.xy[v], a, b) > 4 * ulp) return "off the line";
      last = v;
    }
    if (is_first || last != to) return "not up to the end";
  }
  return next == joined.origins.size() ? "" : "pieces of no line";
}

double ulp_at(double x) {
  return std::nextafter(x, std::numeric_limits<double>::infinity()) - x;
}

struct Place {
  std::string name;
  double offset, size;
  bool is_whole;  ///< whole coordinates: touching, overlapping, and many lines through one place
};

void PrintTo(const Place& place, std::ostream* out) {
  *out << place.name;
}

class RandomLines : public testing::TestWithParam<Place> {};

TEST_P(RandomLines, SplitUntilNoneCross) {
  const auto& [name, offset, size, is_whole] = GetParam();
  const double nearness = std::max(1e-6 * size, 1e3 * ulp_at(offset + size));
  std::size_t crossings = 0;
  for (int seed = 0; seed < 150; ++seed) {
    families::Random random(static_cast<std::uint64_t>(seed));
    const auto coordinate = [&] {
      return offset + (is_whole ? random.integer(0, static_cast<int>(size)) : random.real(0, size));
    };
    PointSet points{{{offset, offset}, {offset + size, offset}, {offset, offset + size}},
                    {0, 5, 9}};
    for (int i = 0; i < 4; ++i) {
      points.xy.push_back({coordinate(), coordinate()});
      points.z.push_back(i);
    }
    std::vector<Line> parts;
    for (int i = 0; i < 8; ++i) {
      Line line;
      // Every third line runs nearly along the last one.
      const bool is_near = i % 3 == 2;
      for (int v = 0; v < 2 + i % 2; ++v) {
        line.xy.push_back({coordinate(), coordinate()});
        line.z.push_back(random.real());
      }
      if (is_near) {
        line.xy = {parts.back().xy[0], parts.back().xy[1]};
        line.z = {0.25, 0.75};
        if (!is_whole) {
          line.xy[0].y += nearness;
          line.xy[1].y -= nearness;
        }
      }
      parts.push_back(line);
    }
    std::optional<Outline> outline;
    if (seed % 2 == 1) {
      outline = Outline{{{{}, {}, 1}}, "area", "feature"};
      for (int v = 0; v < 3; ++v) {
        outline->rings[0].xy.push_back({coordinate(), coordinate()});
        outline->rings[0].z.push_back(50);
      }
      outline->rings[0].xy.push_back(outline->rings[0].xy[0]);
      outline->rings[0].z.push_back(50);
    }
    const Joined before = join_lines(points, std::array{lines(parts)}, outline);
    const Joined joined = join_lines(points, std::array{lines(parts)}, outline, kSplit);
    const double ulp = ulp_at(offset + size);
    ASSERT_EQ(why_crossing(joined), "") << seed;
    ASSERT_EQ(why_not_covered(before, joined, ulp), "") << seed;
    ASSERT_EQ(joined.points.size(), before.points.size() + joined.report.crossings) << seed;
    ASSERT_EQ(joined.points.z.size(), joined.points.size()) << seed;
    ASSERT_EQ(joined.report.crossings == 0 && joined.origins.size() == before.origins.size(),
              why_crossing(before).empty())
        << seed;
    Constraints edges;  // an outline at random need not enclose anything
    edges.edges = joined.constraints.edges;
    edges.edges.insert(edges.edges.end(), joined.constraints.boundary.begin(),
                       joined.constraints.boundary.end());
    ASSERT_NO_THROW(triangulate(joined.points, {}, edges)) << seed;
    crossings += joined.report.crossings;
  }
  EXPECT_GT(crossings, 300u);
}

INSTANTIATE_TEST_SUITE_P(JoinLines, RandomLines,
                         testing::Values(Place{"lattice", 0, 6, true}, Place{"unit", 0, 1, false},
                                         Place{"far", 5e6, 1000, false},
                                         Place{"very_far", 1e12, 1, false},
                                         Place{"tiny", 0, 1e-300, false},
                                         Place{"huge", 0, 1e150, false}),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace hodt
