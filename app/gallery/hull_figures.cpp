// Hulls, and the structures that all edges make together.
// Tested by tests/CMakeLists.txt.
#include <algorithm>
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
#include "hodt/order/fixed_edges.h"
#include "hodt/order/hull.h"
#include "hodt/order/useful_edges.h"
#include "hodt/order/voronoi/voronoi.h"
#include "hodt/order/voronoi/voronoi_polygons.h"

namespace gallery {
namespace {

using hodt::HalfEdgeId;
using hodt::TriangleMesh;

void draw_mesh(Panel& panel, const Scene& scene, std::string_view style) {
  for (const auto& [u, v] : edges_of(scene.graph.mesh))
    panel.line(scene.point(u), scene.point(v), style);
}

void draw_points(Panel& panel, const Scene& scene) {
  for (const Point& p : scene.graph.xy) panel.dot(p, look::kPoint);
}

void draw_end(Panel& panel, const Scene& scene, VertexId v, std::string_view name) {
  panel.dot(scene.point(v), look::kEnd);
  panel.label(scene.point(v), name);
}

/// The walks of the hull, numbered l1, l2, ... and r1, r2, ... from u to v.
void label_hull(Panel& panel, const Scene& scene, const hodt::Hull& hull) {
  for (std::size_t i = 0; i < hull.left.size(); ++i)
    panel.label(scene.point(hull.left[i]), fmt::format("l{}", i + 1));
  for (std::size_t i = 0; i < hull.right.size(); ++i)
    panel.label(scene.point(hull.right[i]), fmt::format("r{}", i + 1));
}

void draw_hull(Page& page, const Frame& frame, const Scene& scene, VertexId u, VertexId v) {
  const hodt::Hull hull = hodt::hull_of_edge(scene.graph, u, v);
  Panel panel(page, frame, scene.graph.xy, "(4b) the hull of uv");
  draw_mesh(panel, scene, look::kFaint);
  for (const hodt::TriangleId t : hull.triangles) {
    const Corners corners = scene.graph.mesh.corners(t);
    panel.polygon(scene.points_of(corners), look::kRegion);
    for (int i = 0; i < 3; ++i)
      panel.line(scene.point(corners[i]), scene.point(corners[(i + 1) % 3]), look::kDelaunay);
  }
  panel.line(scene.point(u), scene.point(v), look::kGone);
  draw_points(panel, scene);
  draw_end(panel, scene, u, "u");
  draw_end(panel, scene, v, "v");
  label_hull(panel, scene, hull);
}

void draw_greedy(Page& page, const Frame& frame, const Scene& scene, VertexId u, VertexId v) {
  const auto triangles = hodt::greedy_triangulation(scene.graph, u, v);
  Panel panel(page, frame, scene.graph.xy, "(5) its greedy triangulation");
  draw_mesh(panel, scene, look::kFaint);
  for (const Corners& corners : triangles) {
    panel.polygon(scene.points_of(corners), look::kRegion);
    for (int i = 0; i < 3; ++i)
      panel.line(scene.point(corners[i]), scene.point(corners[(i + 1) % 3]), look::kDelaunay);
    const auto [a, b, c] = scene.points_of(corners);
    panel.centred({(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3},
                  fmt::format("{}", scene.order_of(corners)), "#0b8a6f");
  }
  panel.line(scene.point(u), scene.point(v), look::kNew);
  draw_points(panel, scene);
  draw_end(panel, scene, u, "u");
  draw_end(panel, scene, v, "v");
}

// ---- Fixed edges ----

std::string filled(std::string_view colour) {
  return fmt::format("fill=\"{}\" fill-opacity=\"0.8\" stroke=\"none\"", colour);
}

void draw_faces(Panel& panel, const Scene& scene, const hodt::FixedFaces& faces) {
  std::size_t number = 0;
  for (Index face = 0; face < faces.size(); ++face) {
    const auto triangles = faces.triangles(face);
    if (triangles.size() == 1) continue;
    for (const hodt::TriangleId t : triangles)
      panel.polygon(scene.points_of(scene.graph.mesh.corners(t)), filled(area_colour(number)));
    ++number;
  }
}

void draw_fixed(Page& page, const Frame& frame, const Scene& scene, Index k) {
  const auto fixed = hodt::fixed_edges(scene.graph, k);
  const hodt::FixedFaces faces(scene.graph, fixed);
  const TriangleMesh& mesh = scene.graph.mesh;
  std::size_t count = 0;
  for (Index i = 0; i < mesh.halfedge_count(); ++i) {
    const HalfEdgeId h(i);
    count += fixed[h] && (mesh.is_boundary(h) || mesh.twin(h) > h);
  }
  Panel panel(page, frame, scene.graph.xy,
              fmt::format("k = {}: {} of {} edges are fixed", k, count, edges_of(mesh).size()));
  draw_faces(panel, scene, faces);
  for (Index i = 0; i < mesh.halfedge_count(); ++i) {
    const HalfEdgeId h(i);
    if (!mesh.is_boundary(h) && mesh.twin(h) < h) continue;
    panel.line(scene.point(mesh.origin(h)), scene.point(mesh.target(h)),
               fixed[h] ? look::kFixed : look::kGone);
  }
  for (const Point& p : scene.graph.xy) panel.dot(p, R"(r="2.6" fill="#2b2a28")");
}

// ---- Voronoi ----

void draw_cells(Page& page, const Frame& frame, const Scene& scene, Index order, Ends shown) {
  const hodt::VoronoiDiagram diagram = hodt::voronoi_diagram(scene.graph, order);
  const hodt::Box box = hodt::enlarged_bounding_box(scene.graph.xy, 0.06);
  const hodt::VoronoiPolygons polygons(scene.graph.xy, diagram, box);
  const std::vector<Point> corners{box.low, box.high};
  Panel panel(page, frame, corners, fmt::format("order {}: {} cells", order, diagram.cell_count()));
  if (shown[1] < shown[0]) std::swap(shown[0], shown[1]);
  std::vector<Point> polygon;
  for (Index cell = 0; cell < diagram.cell_count(); ++cell) {
    polygons.polygon_of(cell, polygon);
    if (polygon.empty()) continue;
    const bool is_shown = std::ranges::equal(diagram.members_of(cell), shown);
    for (std::size_t i = 0; i < polygon.size(); ++i)
      panel.line(polygon[i], polygon[(i + 1) % polygon.size()], look::kDelaunay);
    if (is_shown) panel.polygon(polygon, filled(area_colour(0)));
  }
  draw_points(panel, scene);
  draw_end(panel, scene, shown[0], "p");
  draw_end(panel, scene, shown[1], "q");
}

void draw_bisector_pairs(Page& page, const Frame& frame, const Scene& scene, Index order) {
  const hodt::VoronoiDiagram diagram = hodt::voronoi_diagram(scene.graph, order);
  const hodt::Box box = hodt::enlarged_bounding_box(scene.graph.xy, 0.06);
  const std::vector<Point> corners{box.low, box.high};
  Panel panel(page, frame, corners, "pairs whose bisector has an edge there");
  if (hodt::bisector_pairs(diagram).size() != scene.kod_edges(order - 1).size())
    throw hodt::Error("the picture of Lemma 2 needs points that it holds for");
  for (const auto& [u, v] : hodt::bisector_pairs(diagram))
    panel.line(scene.point(u), scene.point(v), R"(stroke="#0f55a8" stroke-width="1.4")");
  draw_points(panel, scene);
}

// ---- Conflicts ----

struct Candidate {
  VertexId from, to;
  Index order;
  hodt::Hull hull;
};

bool is_lower(const Scene& scene, VertexId u, VertexId v) {
  return scene.height(u) < scene.height(v);
}

bool is_minimum(const Scene& scene, VertexId v) {
  bool result = true;
  scene.graph.for_each_neighbour(v, [&](VertexId w) { result &= is_lower(scene, v, w); });
  return result;
}

/// The useful edges from local minima to lower vertices.
std::vector<Candidate> candidates(const Scene& scene, Index k) {
  hodt::UsefulEdgeSearch search(scene.graph);
  std::vector<Candidate> result;
  for (Index i = 0; i < scene.graph.xy.size(); ++i) {
    const VertexId u(i);
    if (!is_minimum(scene, u)) continue;
    for (const auto& [v, order] :
         search.from(u, k, [&](VertexId w) { return is_lower(scene, w, u); }))
      result.push_back({u, v, order, hodt::hull_of_edge(scene.graph, u, v)});
  }
  return result;
}

/// A place on each edge for its node: not the same share of all, so that nodes and arcs keep apart.
std::vector<Point> nodes_of(const Scene& scene, const std::vector<Candidate>& edges) {
  std::vector<Point> nodes;
  for (const Candidate& c : edges) {
    const double share = nodes.size() % 2 == 0 ? 0.42 : 0.7;
    const Point &a = scene.point(c.from), &b = scene.point(c.to);
    nodes.push_back({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)});
  }
  return nodes;
}

bool conflict(const Candidate& a, const Candidate& b) {
  return std::ranges::any_of(a.hull.triangles, [&](hodt::TriangleId t) {
    return std::ranges::find(b.hull.triangles, t) != b.hull.triangles.end();
  });
}

void draw_minima(Panel& panel, const Scene& scene) {
  for (Index i = 0; i < scene.graph.xy.size(); ++i)
    if (is_minimum(scene, VertexId(i))) panel.dot(scene.graph.xy[i], look::kMinimum);
}

void draw_hulls(Panel& panel, const Scene& scene, const std::vector<Candidate>& edges) {
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (const hodt::TriangleId t : edges[i].hull.triangles)
      panel.polygon(scene.points_of(scene.graph.mesh.corners(t)),
                    fmt::format("fill=\"{}\" fill-opacity=\"0.55\"", area_colour(i)));
}

}  // namespace

std::string hull() {
  const Scene scene(with_long_edge());
  Page page(366, "The hull of an edge and its greedy triangulation");
  const VertexId u = scene.at(0), v = scene.at(1);
  draw_hull(page, {10, 8, 336, 320}, scene, u, v);
  draw_greedy(page, {354, 8, 336, 320}, scene, u, v);
  page.area_key(20, 350, look::kRegion, "the hull");
  page.line_key(130, 350, look::kGone, "the edge uv to come");
  page.text(364, 350, 13, "green: the orders of the new triangles");
  return std::move(page).finish();
}

std::string fixed_edges() {
  const Scene scene(sixty());
  Page page(330, "Fixed edges and the faces between them");
  draw_fixed(page, {10, 8, 336, 280}, scene, 1);
  draw_fixed(page, {354, 8, 336, 280}, scene, 4);
  page.line_key(20, 312, look::kFixed, "fixed");
  page.line_key(120, 312, look::kGone, "Delaunay, but not fixed");
  page.area_key(330, 312, filled(area_colour(0)), "a face of more than one triangle");
  return std::move(page).finish();
}

std::string voronoi() {
  const Scene scene(eighteen());
  Page page(366, "The order-2 Voronoi diagram and the edges of order 1");
  draw_cells(page, {10, 8, 336, 320}, scene, 2, {scene.at(15), scene.at(8)});
  draw_bisector_pairs(page, {354, 8, 336, 320}, scene, 2);
  page.area_key(20, 350, filled(area_colour(0)), "where p and q are the two nearest points");
  page.line_key(364, 350, R"(stroke="#0f55a8" stroke-width="1.4")",
                "exactly the edges of order 0 or 1");
  return std::move(page).finish();
}

std::string conflict_graph() {
  constexpr Index kOrder = 5;
  const Scene scene(rough_slope());
  const std::vector<Candidate> edges = candidates(scene, kOrder);
  const std::vector<Point> nodes = nodes_of(scene, edges);
  const std::vector<Point> shown{{69, 17}, {141, 86}};  // a part with much to do
  Page page(424, "Hulls of edges that remove local minima, and which of them meet");
  {
    Panel panel(page, {10, 8, 336, 380}, shown,
                fmt::format("edges to lower points, order {} or less", kOrder));
    draw_hulls(panel, scene, edges);
    draw_mesh(panel, scene, look::kFaint);
    for (const Candidate& c : edges) panel.line(scene.point(c.from), scene.point(c.to), look::kNew);
    draw_minima(panel, scene);
  }
  {
    Panel panel(page, {354, 8, 336, 380}, shown, "the hull intersection graph");
    draw_hulls(panel, scene, edges);
    draw_mesh(panel, scene, look::kFaint);
    for (const Candidate& c : edges)
      panel.line(scene.point(c.from), scene.point(c.to), look::kChoice);
    for (std::size_t i = 0; i < edges.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (conflict(edges[i], edges[j])) panel.line(nodes[i], nodes[j], look::kArc);
    for (const Point& node : nodes)
      panel.dot(node, R"(r="6" fill="#7a3fa0" stroke="#ffffff" stroke-width="1.4")");
  }
  page.dot_key(20, 408, look::kMinimum, "local minimum");
  page.line_key(150, 408, look::kNew, "an edge that removes it");
  page.dot_key(364, 408, R"(r="6" fill="#7a3fa0")", "hull of an edge");
  page.line_key(500, 408, look::kArc, "hulls that meet");
  return std::move(page).finish();
}

}  // namespace gallery
