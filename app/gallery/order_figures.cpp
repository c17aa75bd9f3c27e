// Orders of triangulations, edges and triangles.
// Tested by tests/CMakeLists.txt.
#include <algorithm>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "drawing.h"
#include "figures.h"
#include "point_sets.h"
#include "scene.h"
#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/order/constrained/constrained_triangulation.h"

namespace gallery {
namespace {

using hodt::TriangleMesh;

std::string coloured(Index order, double width) {
  return fmt::format("stroke=\"{}\" stroke-width=\"{}\"", colour_of_order(order), width);
}

void draw_edges(Panel& panel, const Scene& scene, const TriangleMesh& mesh,
                std::string_view style) {
  for (const auto& [u, v] : edges_of(mesh)) panel.line(scene.point(u), scene.point(v), style);
}

void draw_points(Panel& panel, const Scene& scene) {
  for (const Point& p : scene.graph.xy) panel.dot(p, look::kPoint);
}

void mark(Panel& panel, const Scene& scene, const std::vector<VertexId>& inside) {
  for (const VertexId v : inside) panel.dot(scene.point(v), look::kInside);
}

void draw_end(Panel& panel, const Scene& scene, VertexId v, std::string_view name) {
  panel.dot(scene.point(v), look::kEnd);
  panel.label(scene.point(v), name);
}

/// The points and the box around a circle, for a panel that is to show both.
std::vector<Point> with_circle(const Scene& scene, const Circle& circle) {
  std::vector<Point> shown(scene.graph.xy.begin(), scene.graph.xy.end());
  const auto& [centre, radius] = circle;
  shown.push_back({centre.x - radius, centre.y - radius});
  shown.push_back({centre.x + radius, centre.y + radius});
  return shown;
}

/// A triangle with its circle and what that holds.
void draw_triangle(Panel& panel, const Scene& scene, const Corners& corners) {
  const Circle circle = scene.circle(corners);
  panel.circle(circle.centre, circle.radius, look::kCircle);
  panel.polygon(scene.points_of(corners), look::kTriangle);
  mark(panel, scene, scene.inside(corners));
}

/// Of the largest order; of these the one whose circle is the smallest.
Corners worst_triangle(const Scene& scene, const TriangleMesh& mesh) {
  const std::vector<Corners> all = triangles_of(mesh);
  return *std::ranges::max_element(all, {}, [&](const Corners& corners) {
    return std::pair(scene.order_of(corners), -scene.circle(corners).radius);
  });
}

Index order_of_mesh(const Scene& scene, const TriangleMesh& mesh) {
  return scene.order_of(worst_triangle(scene, mesh));
}

void draw_triangulation(Panel& panel, const Scene& scene, const TriangleMesh& mesh,
                        const Corners& shown) {
  draw_triangle(panel, scene, shown);
  draw_edges(panel, scene, mesh, look::kDelaunay);
  for (const Ends& ends : edges_of(mesh)) {
    bool old = false;
    scene.graph.for_each_neighbour(ends[0], [&](VertexId w) { old |= w == ends[1]; });
    if (!old) panel.line(scene.point(ends[0]), scene.point(ends[1]), look::kNew);
  }
}

Index order_among(const std::vector<OrderedEdge>& edges, VertexId u, VertexId v) {
  for (const OrderedEdge& e : edges)
    if ((e.u == u && e.v == v) || (e.u == v && e.v == u)) return e.order;
  return hodt::kNone;
}

void draw_kod_panel(Page& page, const Frame& frame, const Scene& scene, Index k,
                    std::string_view title) {
  Panel panel(page, frame, scene.graph.xy, title);
  for (const auto& [u, v, order] : scene.kod_edges(k))
    panel.line(scene.point(u), scene.point(v), coloured(order, order == k && k > 0 ? 1.9 : 1.1));
  draw_points(panel, scene);
}

void draw_edge_order(Page& page, const Frame& frame, const Scene& scene, VertexId u, VertexId v) {
  const Index order = order_among(scene.kod_edges(9), u, v);
  const Circle circle = scene.emptiest_circle(u, v);
  const auto inside = scene.inside(circle, {u, v});
  if (inside.size() != order) throw hodt::Error("the circle drawn is not the emptiest");
  Panel panel(page, frame, scene.graph.xy, fmt::format("the edge uv has order {}", order));
  panel.circle(circle.centre, circle.radius, look::kCircle);
  draw_edges(panel, scene, scene.graph.mesh, look::kFaint);
  panel.line(scene.point(u), scene.point(v), look::kNew);
  draw_points(panel, scene);
  mark(panel, scene, inside);
  draw_end(panel, scene, u, "u");
  draw_end(panel, scene, v, "v");
}

void draw_edges_at(Page& page, const Frame& frame, const Scene& scene, VertexId u, Index k) {
  Panel panel(page, frame, scene.graph.xy, fmt::format("the edges at u of order {} or less", k));
  std::vector<OrderedEdge> edges = scene.kod_edges(k);
  std::ranges::stable_sort(edges, std::ranges::greater(), &OrderedEdge::order);
  for (const auto& [a, b, order] : edges) {
    if (a != u && b != u) continue;
    panel.line(scene.point(a), scene.point(b), coloured(order, 2.2));
    const VertexId other = a == u ? b : a;
    panel.label(scene.point(other), fmt::format("{}", order), colour_of_order(order));
  }
  draw_points(panel, scene);
  draw_end(panel, scene, u, "u");
}

/// Points by three rows of the input, with the orders of the three edges between.
struct NamedTriangle {
  Index u, v, w;
};

void draw_counterexample(Page& page, const Frame& frame, const Scene& scene,
                         const NamedTriangle& rows, bool useful) {
  const Corners corners{scene.at(rows.u), scene.at(rows.v), scene.at(rows.w)};
  const auto edges = useful ? scene.useful_edges(6) : scene.kod_edges(6);
  Panel panel(page, frame, with_circle(scene, scene.circle(corners)),
              fmt::format("a triangle of order {}", scene.order_of(corners)));
  draw_triangle(panel, scene, corners);
  draw_edges(panel, scene, scene.graph.mesh, look::kFaint);
  for (int i = 0; i < 3; ++i) {
    const VertexId a = corners[i], b = corners[(i + 1) % 3];
    const Index order = order_among(edges, a, b);
    const Point p = scene.point(a), q = scene.point(b);
    panel.line(p, q, coloured(order, 2.6));
    panel.label({(p.x + q.x) / 2, (p.y + q.y) / 2}, fmt::format("{}", order),
                colour_of_order(order));
  }
  draw_points(panel, scene);
  mark(panel, scene, scene.inside(corners));
}

void draw_usefulness(Page& page, const Frame& frame, const Scene& scene, VertexId u, VertexId v) {
  const Ends s = scene.beside(u, v);
  const auto inside_1 = scene.inside(Corners{u, v, s[0]});
  const auto inside_2 = scene.inside(Corners{u, v, s[1]});
  const std::size_t order = std::max(inside_1.size(), inside_2.size());
  Panel panel(
      page, frame, scene.graph.xy,
      fmt::format("{} and {} inside: useful order {}", inside_1.size(), inside_2.size(), order));
  const Circle first = scene.circle({u, v, s[0]}), second = scene.circle({u, v, s[1]});
  panel.circle(first.centre, first.radius, look::kCircle);
  panel.circle(second.centre, second.radius, look::kOtherCircle);
  draw_edges(panel, scene, scene.graph.mesh, look::kFaint);
  panel.line(scene.point(u), scene.point(v), look::kNew);
  for (int i = 0; i < 2; ++i)
    for (const VertexId end : {u, v})
      panel.line(scene.point(s[i]), scene.point(end),
                 i == 0 ? R"(stroke="#0b8a6f" stroke-width="1.8")"
                        : R"(stroke="#d9730d" stroke-width="1.8")");
  draw_points(panel, scene);
  mark(panel, scene, inside_1);
  mark(panel, scene, inside_2);
  draw_end(panel, scene, u, "u");
  draw_end(panel, scene, v, "v");
  panel.label(scene.point(s[0]), "s1", "#0b8a6f");
  panel.label(scene.point(s[1]), "s2", "#d9730d");
}

}  // namespace

std::string triangulation_orders() {
  const Scene scene(eighteen());
  Page page(300, "Triangulations of order 0, 1 and 2 of the same points");
  constexpr Index kEdges[][2] = {{11, 1}, {8, 5}, {1, 10}};
  for (int i = 0; i < 3; ++i) {
    const Frame frame{8 + 229.0 * i, 8, 226, 250};
    hodt::ConstrainedTriangulation triangulation(scene.graph);
    triangulation.lock(scene.at(kEdges[i][0]), scene.at(kEdges[i][1]));
    const TriangleMesh mesh = std::move(triangulation).take_mesh();
    const Corners shown =
        i == 0 ? Corners{scene.at(0), scene.at(11), scene.at(8)} : worst_triangle(scene, mesh);
    const Index order = order_of_mesh(scene, mesh);
    Panel panel(page, frame, scene.graph.xy,
                order == 0 ? "order 0: Delaunay" : fmt::format("order {}", order));
    draw_triangulation(panel, scene, mesh, shown);
    draw_points(panel, scene);
    mark(panel, scene, scene.inside(shown));
  }
  page.area_key(20, 284, look::kTriangle, "a triangle and its circle");
  page.dot_key(250, 284, look::kInside, "a point inside");
  page.line_key(400, 284, look::kNew, "an edge that is not Delaunay");
  return std::move(page).finish();
}

std::string kod_edges() {
  const Scene scene(eighteen());
  Page page(300, "The edges of order 0, 1 and 2");
  draw_kod_panel(page, {8, 8, 226, 250}, scene, 0, "(a) order 0");
  draw_kod_panel(page, {237, 8, 226, 250}, scene, 1, "(b) and order 1");
  draw_kod_panel(page, {466, 8, 226, 250}, scene, 2, "(c) and order 2");
  for (Index k = 0; k < 3; ++k)
    page.line_key(110 + 190.0 * k, 284, coloured(k, 2.2), fmt::format("edges of order {}", k));
  return std::move(page).finish();
}

std::string edge_order() {
  const Scene scene(eighteen());
  Page page(366, "The order of an edge");
  draw_edge_order(page, {10, 8, 336, 320}, scene, scene.at(1), scene.at(10));
  draw_edges_at(page, {354, 8, 336, 320}, scene, scene.at(11), 4);
  page.dot_key(20, 350, look::kInside, "inside the emptiest circle through u and v");
  for (Index k = 0; k < 5; ++k)
    page.line_key(368 + 64.0 * k, 350, coloured(k, 2.2), fmt::format("{}", k));
  return std::move(page).finish();
}

std::string order_of_triangles() {
  Page page(366, "Triangles and the orders of their edges");
  const Scene left({{{32, 71}, {19, 17}, {69, 29}, {3, 64}, {72, 61}, {49, 6}}, {}});
  draw_counterexample(page, {10, 8, 336, 320}, left, {5, 4, 3}, false);
  const Scene right({{{16, 23}, {13, 60}, {2, 41}, {42, 36}, {50, 53}, {46, 4}}, {}});
  draw_counterexample(page, {354, 8, 336, 320}, right, {4, 1, 0}, true);
  page.text(178, 350, 13, "(a) at the edges: their orders", R"(text-anchor="middle")");
  page.text(522, 350, 13, "(b) at the edges: their useful orders", R"(text-anchor="middle")");
  return std::move(page).finish();
}

std::string useful_edge() {
  const Scene scene(eighteen());
  Page page(366, "Two circles tell whether an edge is useful");
  draw_usefulness(page, {10, 8, 336, 320}, scene, scene.at(0), scene.at(15));
  draw_usefulness(page, {354, 8, 336, 320}, scene, scene.at(0), scene.at(1));
  page.line_key(20, 350, R"(stroke="#0b8a6f" stroke-width="2.2")", "circle u, v, s1");
  page.line_key(180, 350, R"(stroke="#d9730d" stroke-width="2.2")", "circle u, v, s2");
  page.dot_key(340, 350, look::kInside, "a point inside one of them");
  return std::move(page).finish();
}

std::string crossing_edges() {
  const Scene scene({{{-1, 0},
                      {-0.7, 0.24},
                      {-0.7, -0.25},
                      {0.95, 0.75},
                      {0.98, 0.5},
                      {0.995, 0.25},
                      {1, 0.01},
                      {0.994, -0.24},
                      {0.979, -0.51},
                      {0.949, -0.76}},
                     {}});
  const VertexId u = scene.at(1), v = scene.at(2);
  const auto edges = scene.kod_edges(2), useful = scene.useful_edges(7);
  Page page(366, "Many edges of order 2 cross one Delaunay edge, few of them useful");
  {
    const Circle circle = scene.emptiest_circle(scene.at(0), scene.at(6));
    Panel panel(page, {10, 8, 480, 346}, with_circle(scene, circle), "edges of order 2 across uv");
    draw_edges(panel, scene, scene.graph.mesh, look::kFaint);
    for (Index row = 3; row < 10; ++row) {
      const VertexId w = scene.at(row);
      if (order_among(edges, scene.at(0), w) != 2) continue;
      panel.line(scene.point(scene.at(0)), scene.point(w), coloured(2, 2));
      const Index order = order_among(useful, scene.at(0), w);
      panel.label(scene.point(w), order == hodt::kNone ? "–" : fmt::format("{}", order));
    }
    panel.circle(circle.centre, circle.radius, look::kCircle);
    panel.line(scene.point(u), scene.point(v), look::kFixed);
    draw_points(panel, scene);
    draw_end(panel, scene, u, "u");
    draw_end(panel, scene, v, "v");
  }
  page.line_key(505, 120, look::kFixed, "the Delaunay edge uv");
  page.line_key(505, 148, coloured(2, 2), "edges of order 2");
  page.text(505, 180, 13, "the circle shows it for one:");
  page.text(505, 198, 13, "it holds u and v alone");
  page.text(505, 230, 13, "numbers: useful orders");
  return std::move(page).finish();
}

}  // namespace gallery
