// Breaklines and outlines: what is reached inside a circle, and what becomes of a triangulation.
// Tested by tests/CMakeLists.txt.
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "drawing.h"
#include "figures.h"
#include "point_sets.h"
#include "scene.h"
#include <fmt/format.h>

#include "hodt/order/constrained/constrained_delaunay.h"
#include "hodt/pipeline.h"

namespace gallery {
namespace {

using hodt::Constraints;
using hodt::PointSet;

constexpr std::string_view kBeyond = R"(r="5" fill="#b9b2a5" stroke="#ffffff" stroke-width="1")";
constexpr std::string_view kBreakline = R"(stroke="#c2331f" stroke-width="3.4")";

/// The triangle of rows 0, 1 and 2 with its circle: what of its inside is reached is red, what is
/// beyond the breakline grey.
void draw_reached(Page& page, const Frame& frame, const PointSet& points,
                  const std::vector<Constraints::Edge>& breakline, std::string_view title) {
  const Scene scene(points);
  hodt::Delaunay constrained = hodt::delaunay(points);
  std::vector<std::array<VertexId, 2>> walls;
  for (const auto& [a, b] : breakline) walls.push_back({scene.at(a), scene.at(b)});
  if (!walls.empty()) hodt::insert_walls(constrained, walls);
  const hodt::DelaunayGraph graph(constrained);
  hodt::CircleCounter counter(graph);
  const Corners corners{scene.at(0), scene.at(1), scene.at(2)};
  const Index order = counter.count(corners[0], corners[1], corners[2], hodt::kUnlimited);

  const Circle circle = scene.circle(corners);
  std::vector<Point> shown(points.xy);
  shown.push_back({circle.centre.x - circle.radius, circle.centre.y - circle.radius});
  shown.push_back({circle.centre.x + circle.radius, circle.centre.y + circle.radius});
  Panel panel(page, frame, shown, fmt::format("{}: order {}", title, order));
  panel.circle(circle.centre, circle.radius, look::kCircle);
  panel.polygon(scene.points_of(corners), look::kTriangle);
  for (const Point& p : points.xy) panel.dot(p, look::kPoint);
  for (const VertexId v : scene.inside(corners)) panel.dot(scene.point(v), kBeyond);
  for (const VertexId v : counter.inside()) panel.dot(graph.point(v), look::kInside);
  for (const auto& [a, b] : breakline) panel.line(points.xy[a], points.xy[b], kBreakline);
}

void draw_tin(Page& page, const Frame& frame, const hodt::Tin& tin, const std::vector<Point>& shown,
              const PointSet& points, const std::vector<Constraints::Edge>& outline,
              const std::vector<Constraints::Edge>& breakline, std::string_view title) {
  Panel panel(page, frame, shown, title);
  for (const auto& [a, b, c] : tin.triangles)
    for (const auto& [u, v] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      panel.line(tin.points.xy[u], tin.points.xy[v], look::kDelaunay);
  for (const auto& [a, b] : outline) panel.line(points.xy[a], points.xy[b], look::kFixed);
  for (const auto& [a, b] : breakline) panel.line(points.xy[a], points.xy[b], kBreakline);
}

}  // namespace

std::string constrained_order() {
  // A triangle, what is inside its circle on either side of a line, and the line's ends.
  const PointSet points{{{20, 50},
                         {64, 14},
                         {64, 86},
                         {40, 76},
                         {67, 62},
                         {80, 36},
                         {85, 55},
                         {78, 70},
                         {72, -4},
                         {73, 106},
                         {72, 46},
                         {8, 14},
                         {104, 92},
                         {10, 90},
                         {106, 10}},
                        {}};
  Page page(270, "A breakline keeps points out of a count");
  constexpr double kWidth = kPageWidth / 3, kHeight = 230;
  draw_reached(page, {0, 0, kWidth, kHeight}, points, {}, "no breakline");
  draw_reached(page, {kWidth, 0, kWidth, kHeight}, points, {{8, 10}, {10, 9}}, "across the circle");
  draw_reached(page, {2 * kWidth, 0, kWidth, kHeight}, points, {{8, 10}}, "ending inside");
  page.dot_key(40, 258, look::kInside, "counts: reached from the triangle");
  page.dot_key(300, 258, kBeyond, "inside the circle, but beyond");
  page.line_key(530, 258, kBreakline, "breakline");
  return std::move(page).finish();
}

std::string breaklines() {
  // Scattered points, a road through them and a field's outline with a pond.
  PointSet points;
  std::uint32_t state = 7;
  const auto random = [&] {
    state = state * 1664525u + 1013904223u;
    return double(state >> 8) / double(1u << 24);
  };
  for (int i = 0; i < 170; ++i) {
    const double x = 100 * random();
    points.xy.push_back({x, 100 * random()});
  }
  const auto add = [&](const std::vector<Point>& line, bool is_closed) {
    std::vector<Constraints::Edge> edges;
    const auto first = static_cast<Index>(points.size());
    for (const Point& p : line) points.xy.push_back(p);
    for (Index i = 1; i < line.size(); ++i) edges.push_back({first + i - 1, first + i});
    if (is_closed) edges.push_back({static_cast<Index>(points.size() - 1), first});
    return edges;
  };
  const auto scattered = points;
  const auto road = add({{11, 22}, {34, 34}, {58, 37}, {76, 52}, {87, 78}}, false);
  const auto field =
      add({{6, 8}, {60, 12}, {94, 5}, {92, 60}, {96, 93}, {52, 76}, {30, 92}, {10, 90}}, true);
  const auto pond = add({{22, 52}, {38, 50}, {42, 64}, {30, 72}, {19, 64}}, true);
  Constraints constraints{road, field, std::numeric_limits<double>::infinity(), {}};
  constraints.boundary.insert(constraints.boundary.end(), pond.begin(), pond.end());
  const hodt::TriangulateOptions plain{.objective = hodt::Objective::none};
  const hodt::TriangulateOptions better{
      .order = 4,
      .objective = hodt::Objective(hodt::Direction::minimize, hodt::Aggregate::sum,
                                   hodt::TriangleMeasure::length)};

  Page page(400, "The same points without and with an outline, a hole and a breakline");
  constexpr double kWidth = kPageWidth / 2, kHeight = 360;
  draw_tin(page, {0, 0, kWidth, kHeight}, hodt::triangulate(scattered, plain).tin, points.xy,
           points, {}, {}, "the points alone");
  const auto result = hodt::triangulate(points, better, constraints);
  std::vector<Constraints::Edge> outline = field;
  outline.insert(outline.end(), pond.begin(), pond.end());
  draw_tin(page, {kWidth, 0, kWidth, kHeight}, result.tin, points.xy, points, outline, road,
           fmt::format("with lines, of order {}", result.report.order));
  page.line_key(150, 388, look::kFixed, "outline and hole");
  page.line_key(420, 388, kBreakline, "breakline");
  return std::move(page).finish();
}

}  // namespace gallery
