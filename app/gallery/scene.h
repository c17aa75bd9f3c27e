// A small point set with all that the library says about it, by the rows of the input.
// Tested by tests/CMakeLists.txt.
#pragma once

#include <array>
#include <vector>

#include "hodt/delaunay/delaunay.h"
#include "hodt/geometry/point_set.h"
#include "hodt/order/circle_counter.h"
#include "hodt/order/delaunay_graph.h"

namespace gallery {

using hodt::Index;
using hodt::Point;
using hodt::VertexId;

using Corners = std::array<VertexId, 3>;
using Ends = std::array<VertexId, 2>;

struct Circle {
  Point centre;
  double radius;
};

/// An edge and its order, of one kind or another.
struct OrderedEdge {
  VertexId u, v;
  Index order;
};

class Scene {
 public:
  explicit Scene(hodt::PointSet points);

  const hodt::PointSet points;
  const hodt::Delaunay delaunay;
  const hodt::DelaunayGraph graph;

  VertexId at(Index row) const { return vertex_of_row_[row]; }
  const Point& point(VertexId v) const { return graph.xy[v]; }
  double height(VertexId v) const { return delaunay.vertices.z[v]; }
  std::array<Point, 3> points_of(const Corners& corners) const;

  Index order_of(Corners corners) const;
  /// The points inside the circle of a triangle.
  std::vector<VertexId> inside(Corners corners) const;
  Circle circle(const Corners& corners) const;
  /// All k-OD edges.
  std::vector<OrderedEdge> kod_edges(Index k) const;
  /// All useful edges up to that order.
  std::vector<OrderedEdge> useful_edges(Index k) const;
  /// The third corners of the triangles beside uv in its greedy triangulation: s1 on the left of
  /// u -> v and s2 on the right.
  Ends beside(VertexId u, VertexId v) const;
  /// Of the circles through u and v that hold the fewest points, the smallest to speak of.
  Circle emptiest_circle(VertexId u, VertexId v) const;
  std::vector<VertexId> inside(const Circle& circle, const Ends& except) const;

 private:
  Corners counter_clockwise(Corners corners) const;
  std::vector<hodt::VertexId> vertex_of_row_;
};

/// Of every edge of a mesh its ends, once.
std::vector<Ends> edges_of(const hodt::TriangleMesh& mesh);
std::vector<Corners> triangles_of(const hodt::TriangleMesh& mesh);

}  // namespace gallery
