#include "scene.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "hodt/geometry/predicates.h"
#include "hodt/order/edges.h"
#include "hodt/order/hull.h"

namespace gallery {
namespace {

double distance(const Point& p, const Point& q) {
  return std::hypot(p.x - q.x, p.y - q.y);
}

std::vector<OrderedEdge> edges(const Scene& scene, hodt::EdgeClass edge_class, Index k) {
  std::vector<OrderedEdge> result;
  hodt::for_each_edge(scene.graph, edge_class, k, [&](std::span<const hodt::EdgeRecord> piece) {
    for (const auto& [u, v, order] : piece) result.push_back({VertexId(u), VertexId(v), order});
  });
  return result;
}

/// Where on the bisector of two points the circles through them have their centres.
struct Bisector {
  Bisector(const Point& u, const Point& v)
      : middle{(u.x + v.x) / 2, (u.y + v.y) / 2}, along{u.y - v.y, v.x - u.x} {}
  Point at(double place) const { return {middle.x + place * along.x, middle.y + place * along.y}; }
  /// Of the centre of the circle that passes through w too.
  double place_through(const Point& u, const Point& w) const {
    const Point to_w{w.x - u.x, w.y - u.y};
    const Point chord{middle.x - u.x, middle.y - u.y};
    const double square = to_w.x * to_w.x + to_w.y * to_w.y;
    return (square / 2 - (chord.x * to_w.x + chord.y * to_w.y)) /
           (along.x * to_w.x + along.y * to_w.y);
  }
  Point middle, along;
};

}  // namespace

Scene::Scene(hodt::PointSet given)
    : points(std::move(given)), delaunay(hodt::delaunay(points)), graph(delaunay) {
  const auto vertices = hodt::vertices_of_rows(points, delaunay.vertices);
  vertex_of_row_.assign(vertices.begin(), vertices.end());
}

std::array<Point, 3> Scene::points_of(const Corners& corners) const {
  return {point(corners[0]), point(corners[1]), point(corners[2])};
}

Corners Scene::counter_clockwise(Corners corners) const {
  if (hodt::orient(point(corners[0]), point(corners[1]), point(corners[2])) < 0)
    std::swap(corners[1], corners[2]);
  return corners;
}

std::vector<VertexId> Scene::inside(Corners corners) const {
  const auto [a, b, c] = counter_clockwise(corners);
  hodt::CircleCounter counter(graph);
  counter.count(a, b, c, hodt::kUnlimited);
  return {counter.inside().begin(), counter.inside().end()};
}

Index Scene::order_of(Corners corners) const {
  return static_cast<Index>(inside(corners).size());
}

Circle Scene::circle(const Corners& corners) const {
  const auto [a, b, c] = points_of(corners);
  const Bisector bisector(a, b);
  const Point centre = bisector.at(bisector.place_through(a, c));
  return {centre, distance(centre, a)};
}

std::vector<OrderedEdge> Scene::kod_edges(Index k) const {
  return edges(*this, hodt::EdgeClass::kod, k);
}

std::vector<OrderedEdge> Scene::useful_edges(Index k) const {
  return edges(*this, hodt::EdgeClass::useful, k);
}

Ends Scene::beside(VertexId u, VertexId v) const {
  Ends result;
  for (const Corners& corners : hodt::greedy_triangulation(graph, u, v)) {
    for (int i = 0; i < 3; ++i) {
      const VertexId from = corners[i], to = corners[(i + 1) % 3], apex = corners[(i + 2) % 3];
      if (from == u && to == v) result[0] = apex;
      if (from == v && to == u) result[1] = apex;
    }
  }
  return result;
}

std::vector<VertexId> Scene::inside(const Circle& circle, const Ends& except) const {
  std::vector<VertexId> result;
  for (Index i = 0; i < graph.xy.size(); ++i) {
    const VertexId v(i);
    if (v == except[0] || v == except[1]) continue;
    if (distance(point(v), circle.centre) < circle.radius) result.push_back(v);
  }
  return result;
}

Circle Scene::emptiest_circle(VertexId u, VertexId v) const {
  const Bisector bisector(point(u), point(v));
  std::vector<double> places;
  for (Index i = 0; i < graph.xy.size(); ++i)
    if (i != u && i != v) places.push_back(bisector.place_through(point(u), graph.xy[i]));
  std::sort(places.begin(), places.end());
  Circle best{};
  std::size_t fewest = graph.xy.size();
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const Point centre = bisector.at((places[i] + places[i + 1]) / 2);
    const Circle circle{centre, distance(centre, point(u))};
    const std::size_t count = inside(circle, {u, v}).size();
    if (count > fewest || (count == fewest && circle.radius >= best.radius)) continue;
    fewest = count;
    best = circle;
  }
  return best;
}

std::vector<Ends> edges_of(const hodt::TriangleMesh& mesh) {
  std::vector<Ends> edges;
  for (Index i = 0; i < mesh.halfedge_count(); ++i) {
    const hodt::HalfEdgeId h(i);
    if (mesh.is_boundary(h) || mesh.twin(h) > h) edges.push_back({mesh.origin(h), mesh.target(h)});
  }
  return edges;
}

std::vector<Corners> triangles_of(const hodt::TriangleMesh& mesh) {
  std::vector<Corners> triangles;
  for (Index t = 0; t < mesh.triangle_count(); ++t)
    triangles.push_back(mesh.corners(hodt::TriangleId(t)));
  return triangles;
}

}  // namespace gallery
