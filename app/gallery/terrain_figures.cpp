// Extrema of triangulations of order 1.
// Tested by tests/CMakeLists.txt.
#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "drawing.h"
#include "figures.h"
#include "point_sets.h"
#include "scene.h"
#include <fmt/format.h>

#include "hodt/optimize/extrema/first_order_extrema.h"
#include "hodt/optimize/extrema/remove_extrema.h"
#include "hodt/order/first_order/first_order.h"

namespace gallery {
namespace {

using hodt::HalfEdgeId;
using hodt::TriangleMesh;

enum class Kind : std::uint8_t { none, minimum, maximum };

/// What a vertex is among the neighbours that some edges give it.
Kind kind_of(const Scene& scene, const std::vector<Ends>& edges, VertexId v) {
  bool lower = false, higher = false;
  for (const auto& [a, b] : edges) {
    if (a != v && b != v) continue;
    const VertexId other = a == v ? b : a;
    (scene.height(other) < scene.height(v) ? lower : higher) = true;
  }
  if (!lower) return Kind::minimum;
  return higher ? Kind::none : Kind::maximum;
}

void draw_heights(Panel& panel, const Scene& scene, const std::vector<Ends>& edges,
                  bool with_maxima) {
  for (Index i = 0; i < scene.graph.xy.size(); ++i) {
    const VertexId v(i);
    const Kind kind = kind_of(scene, edges, v);
    const bool is_maximum = kind == Kind::maximum && with_maxima;
    panel.dot(scene.point(v), kind == Kind::minimum ? look::kMinimum
                              : is_maximum          ? look::kMaximum
                                                    : look::kPoint);
    panel.label(scene.point(v), fmt::format("{}", scene.height(v)));
  }
}

bool contains(const std::vector<Ends>& edges, const Ends& e) {
  return std::ranges::any_of(edges, [&](const Ends& f) { return f == e || f == Ends{e[1], e[0]}; });
}

void draw_change(Panel& panel, const Scene& scene, const std::vector<Ends>& before,
                 const std::vector<Ends>& after) {
  for (const Ends& e : after)
    panel.line(scene.point(e[0]), scene.point(e[1]),
               contains(before, e) ? look::kDelaunay : look::kNew);
}

/// The convex quadrilaterals of which either diagonal may be chosen, the Delaunay one first.
struct Quadrilateral {
  Ends delaunay, other;
};

std::vector<Quadrilateral> quadrilaterals(const Scene& scene) {
  const TriangleMesh& mesh = scene.graph.mesh;
  std::vector<Quadrilateral> result;
  for (const HalfEdgeId h : hodt::first_order_edges(scene.graph))
    result.push_back({{mesh.origin(h), mesh.target(h)}, {mesh.apex(h), mesh.apex(mesh.twin(h))}});
  return result;
}

std::vector<Ends> fixed_edges_of(const Scene& scene) {
  std::vector<Ends> result = edges_of(scene.graph.mesh);
  for (const Quadrilateral& q : quadrilaterals(scene))
    std::erase_if(result, [&](const Ends& e) { return contains({q.delaunay}, e); });
  return result;
}

/// Of a diagonal the end that it keeps from being an extremum of that kind, if it is one without
/// the diagonal.
VertexId relieved(const Scene& scene, const std::vector<Ends>& fixed, const Ends& diagonal,
                  Kind kind) {
  const bool first_lower = scene.height(diagonal[0]) < scene.height(diagonal[1]);
  const VertexId end = diagonal[first_lower == (kind == Kind::minimum) ? 1 : 0];
  return kind_of(scene, fixed, end) == kind ? end : VertexId();
}

/// The paper's graph: a minimum that one diagonal removes, a maximum that the other does.
std::vector<Ends> conflicts(const Scene& scene) {
  const std::vector<Ends> fixed = fixed_edges_of(scene);
  std::vector<Ends> arcs;
  for (const Quadrilateral& q : quadrilaterals(scene)) {
    for (const auto& [a, b] : {std::pair(q.delaunay, q.other), std::pair(q.other, q.delaunay)}) {
      const VertexId low = relieved(scene, fixed, a, Kind::minimum);
      const VertexId high = relieved(scene, fixed, b, Kind::maximum);
      if (low.valid() && high.valid()) arcs.push_back({low, high});
    }
  }
  return arcs;
}

void draw_quadrilaterals(Panel& panel, const Scene& scene) {
  for (const Quadrilateral& q : quadrilaterals(scene)) {
    const std::array<Point, 4> corners{scene.point(q.delaunay[0]), scene.point(q.other[0]),
                                       scene.point(q.delaunay[1]), scene.point(q.other[1])};
    panel.polygon(corners, look::kRegion);
    for (const Ends& e : {q.delaunay, q.other})
      panel.line(scene.point(e[0]), scene.point(e[1]), look::kChoice);
  }
}

}  // namespace

std::string artificial_dam() {
  const Scene scene(valley());
  const auto solution =
      hodt::remove_extrema({.graph = scene.graph, .z = scene.delaunay.vertices.z, .order = 1});
  const std::vector<Ends> before = edges_of(scene.graph.mesh),
                          after = edges_of(solution.change.applied_to(scene.delaunay.mesh));
  Page page(366, "An artificial dam, and the flip that opens it");
  {
    Panel panel(page, {10, 8, 336, 320}, scene.graph.xy,
                fmt::format("Delaunay: {} local minima", solution.delaunay));
    for (const Ends& e : before)
      panel.line(scene.point(e[0]), scene.point(e[1]),
                 contains(after, e) ? look::kDelaunay : look::kGone);
    draw_heights(panel, scene, before, false);
  }
  {
    Panel panel(page, {354, 8, 336, 320}, scene.graph.xy,
                fmt::format("order 1: {} local minimum", solution.result));
    draw_change(panel, scene, before, after);
    draw_heights(panel, scene, after, false);
  }
  page.dot_key(20, 350, look::kMinimum, "local minimum (numbers: heights)");
  page.line_key(290, 350, look::kGone, "the dam");
  page.line_key(400, 350, look::kNew, "the new edge, along the valley");
  return std::move(page).finish();
}

std::string extrema_cycle() {
  const Scene scene(ring());
  const auto solution = hodt::minimize_first_order_extrema(scene.graph, scene.delaunay.vertices.z);
  const std::vector<Ends> fixed = fixed_edges_of(scene),
                          after = edges_of(solution.change.applied_to(scene.delaunay.mesh));
  Page page(386, "Minima and maxima that compete for quadrilaterals");
  {
    Panel panel(page, {10, 8, 336, 320}, scene.graph.xy, "fixed edges for k = 1");
    draw_quadrilaterals(panel, scene);
    for (const Ends& e : fixed) panel.line(scene.point(e[0]), scene.point(e[1]), look::kFixed);
    for (const Ends& e : conflicts(scene))
      panel.line(scene.point(e[0]), scene.point(e[1]), look::kArc);
    draw_heights(panel, scene, fixed, true);
  }
  {
    Panel panel(page, {354, 8, 336, 320}, scene.graph.xy,
                fmt::format("the optimum: {} extrema left (Delaunay: {})", solution.result,
                            solution.delaunay));
    draw_change(panel, scene, fixed, after);
    draw_heights(panel, scene, after, true);
  }
  page.dot_key(20, 350, look::kMinimum, "local minimum");
  page.dot_key(160, 350, look::kMaximum, "local maximum");
  page.line_key(300, 350, look::kArc, "a minimum and a maximum want different ones");
  page.line_key(20, 374, look::kChoice, "either diagonal may be chosen");
  page.line_key(300, 374, look::kNew, "the one that is chosen");
  return std::move(page).finish();
}

}  // namespace gallery
