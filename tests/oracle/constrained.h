// The oracle for order with constraints: from the definition, by enumeration, for n <= 9.
//
// The constrained order of a triangle t is the number of vertices inside its open circumdisc that a
// path from t reaches, in the disc and in the convex hull of the points, without crossing a
// constraint. A vertex at the end of a constraint counts if it is reached from either side.
//
// How it is found: in any triangulation of the points that contains the constraints, walk from the
// triangles that overlap t over edges that are no constraints and meet the disc. What a triangle
// has in common with the disc is convex, so the triangles met are those that paths reach. Nothing
// here supposes that all triangulations give the same answer: the test shows it.
//
// The hull is a border as an outline is: a constraint that ends on it is not gone around outside,
// and constraints along it change nothing. (Paths that may leave the hull give another order,
// larger for some triangles. All facts of the test hold for it too, so the choice is one of
// meaning.)
//
// Ties. A vertex is inside if the perturbed in-circle question says so, never a corner of t. An
// edge meets the disc if an end of it is inside, or a point between its ends is nearer to the
// centre than the radius: exactly, without perturbation. Why: raise each vertex's lift by its
// infinitesimal, and the paraboloid over each triangle by the linear function through its corners'
// infinitesimals. The disc is where this surface is below the plane through the corners of t. In
// each triangle that is convex again, and on each edge it is where a parabola is negative:
//   - With an end inside, the edge meets the disc, whatever way it goes. So a vertex on the circle
//     that the rule takes in has a neighbourhood in the disc: a path may go around it,
//     and a constraint that leads from it into the disc does not by itself keep its sides apart.
//   - A vertex on the circle that the rule leaves out, and every corner, has no such neighbourhood:
//     a constraint that leads from it into the disc keeps its sides apart.
//   - An edge that touches the circle, with both ends not inside, may or may not meet the raised
//     disc. It does not matter: beyond it is an infinitesimal part of the disc, without a vertex,
//     and no other edge meets that part.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "oracle.h"

namespace oracle {

/// Constraint edges over the points of an Instance, which must outlive it. Orders are remembered
/// when first asked for, so it is not for two threads at once.
class Constrained {
 public:
  /// The edges either way round, repetitions allowed. Throws std::invalid_argument if two of them
  /// cross, or one has equal ends or passes through a third point, or all points are collinear.
  Constrained(const Instance& instance, std::vector<Edge> edges);

  const Instance& instance() const { return instance_; }
  /// Sorted, each once.
  const std::vector<Edge>& edges() const { return edges_; }
  bool is_constraint(int u, int v) const;
  /// The segment passes through no third point and crosses no constraint.
  bool is_edge_possible(int u, int v) const;
  /// An empty triangle of three possible edges: some triangulation with the constraints has it.
  bool is_triangle_possible(const Triangle& t) const;
  /// All of them, canonical, sorted.
  Triangles possible_triangles() const;

  /// The vertices that count in the order of a possible triangle, ascending.
  std::vector<int> reachable_inside(const Triangle& t) const;
  /// The same, found by a walk in the given triangulation, which must contain the constraints but
  /// need not contain t.
  std::vector<int> reachable_inside(const Triangle& t, const Triangles& triangulation) const;
  int triangle_order(const Triangle& t) const;
  /// Points exactly on the circle count as outside, and no path goes around them.
  int triangle_order_plain(const Triangle& t) const;
  /// The largest order of a triangle; 0 for none.
  int order(const Triangles& triangles) const;
  int order_plain(const Triangles& triangles) const;

  /// All possible triangles of order 0: the constrained Delaunay triangulation.
  Triangles delaunay() const;
  /// By Lemma 4: the larger of the orders of the triangles at uv in the constrained Delaunay
  /// triangulation of the constraints and uv. uv itself does not block when counting. Empty if
  /// the edge is not possible, 0 for a constraint.
  std::optional<int> useful_order_by_lemma(int u, int v) const;

  /// The fewest vertices inside a circle through u and v that paths in it reach from the edge uv,
  /// which blocks nothing. Empty if the edge is not possible, 0 for a constraint. (Circles that
  /// pass through a third vertex are enough: as one changes, what is inside and reached only
  /// changes there.)
  std::optional<int> edge_order(int u, int v) const;
  /// The order of any three vertices: other ones may lie in the triangle or on its sides. Empty if
  /// they are collinear, or a constraint enters the interior of the triangle.
  std::optional<int> open_triangle_order(const Triangle& t) const;

  /// A triangulation that contains the constraints and the edges: possible, none crossing another.
  Triangles some_triangulation(const std::vector<Edge>& with = {}) const;
  /// Calls visit(triangles, order) for every triangulation of all the points that contains the
  /// constraints and whose triangles all have order at most max_order, each once.
  void for_each_triangulation(int max_order,
                              const std::function<void(const Triangles&, int)>& visit) const;
  std::vector<OrderedTriangle> possible_triangles_with_orders() const;

 private:
  const Instance& instance_;
  std::vector<Edge> edges_;
  mutable std::map<Triangle, int> orders_;
};

/// `count` edges (as many as fit) that do not cross and pass through no third point, drawn at
/// random. The same seed gives the same edges.
std::vector<Edge> random_constraints(const Instance& instance, int count, std::uint64_t seed);

/// Closed chains of vertices. Inside is what is surrounded an odd number of times, so rings may be
/// outlines, holes and islands in any order and direction, and may touch.
using Rings = std::vector<std::vector<int>>;

/// Whether the centroid is inside, exactly. Requires a triangle that no edge of a ring crosses.
bool is_in_domain(const Instance& instance, const Rings& rings, const Triangle& t);

/// All triangulations that contain the constraints, and what the definitions say about edges and
/// triangles.
///
/// With a domain the triangulations are those of the domain: their triangles inside it, each set of
/// them once, whose order is that of the triangles inside. Points in none of them are unused.
class ConstrainedCatalogue : public Catalogue {
 public:
  explicit ConstrainedCatalogue(const Constrained& constrained, int max_order = kUnrestricted);
  /// Throws std::invalid_argument if an edge of a ring is no constraint.
  ConstrainedCatalogue(const Constrained& constrained, const Rings& domain);
};

/// The ends of edges that only one triangle has: the border of a mesh. One entry a point.
std::vector<bool> boundary_vertices(const Instance& instance, const Triangles& triangles);

}  // namespace oracle
