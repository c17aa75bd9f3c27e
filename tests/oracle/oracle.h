// The oracle: what hodt computes, written straight from the definitions and from nothing else.
//
// Exact rational arithmetic, tables of signs, and the enumeration of all triangulations of a small
// point set. It shares no code with hodt, so that the two cannot share a mistake. Points are plain
// pairs of doubles and ints are indices, for the same reason.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gmpxx.h>

namespace oracle {

using Points = std::vector<std::pair<double, double>>;
using Heights = std::vector<double>;

/// Three corners. Canonical: counter-clockwise, the smallest index first.
using Triangle = std::array<int, 3>;
/// Canonical triangles, sorted.
using Triangles = std::vector<Triangle>;
/// Two ends, the smaller first.
using Edge = std::array<int, 2>;
inline Edge edge_of(int u, int v) {
  return u < v ? Edge{u, v} : Edge{v, u};
}

struct SplitCount {
  int interior = 0;
  int boundary = 0;

  int total() const { return interior + boundary; }
  friend bool operator==(const SplitCount&, const SplitCount&) = default;
};

/// Vertices with no lower neighbour, with no higher one, and connected sets of equal height with
/// no lower neighbour. Lower is (z, x, y) for the first two, z alone for pits.
struct ExtremaCount {
  SplitCount minima;
  SplitCount maxima;
  SplitCount pits;
};

/// A point set and the signs of all its triples and quadruples.
///
/// Four cocircular points are decided by the perturbation: every point's lift x² + y² is raised by
/// an infinitesimal, and the infinitesimal of a lexicographically larger point is infinitely larger
/// than that of a smaller one. Functions without `plain` in the name obey it. Signs of quadruples
/// are computed when first asked for, so an Instance is not for two threads at once.
class Instance {
 public:
  /// Throws std::invalid_argument if two points are equal, a coordinate is not finite, or the
  /// number of heights is neither 0 nor that of the points.
  explicit Instance(const Points& points, const Heights& z = {});

  int size() const { return static_cast<int>(points_.size()); }
  const Points& points() const { return points_; }
  const Heights& heights() const { return z_; }
  /// The same points with other heights: cheaper than a new Instance.
  void set_heights(const Heights& z);

  /// +1 if i, j, k make a left turn, -1 a right turn, 0 if collinear. Exact, never perturbed.
  int orient(int i, int j, int k) const { return orient_[(i * stride() + j) * stride() + k]; }
  /// +1 if l is strictly inside the circle through i, j, k, 0 on it, -1 outside, whichever way
  /// the three turn. Requires that i, j, k are not collinear and all four are different.
  int in_circle_plain(int i, int j, int k, int l) const;
  /// The same under the perturbation: never 0.
  int in_circle(int i, int j, int k, int l) const;
  /// Coordinates times one common power of two: integers. A scale changes no sign.
  const mpz_class& x(int i) const { return x_[i]; }
  const mpz_class& y(int i) const { return y_[i]; }
  /// Twice the signed area of a triangle, in units common to all triangles of this instance.
  const mpz_class& double_area_of_sorted(int i, int j, int k) const;

  bool all_collinear() const;
  /// No third point lies on the segment.
  bool is_segment_free(int u, int v) const;
  /// The segments have a point in common that is interior to both, and are not collinear.
  bool segments_cross(int a, int b, int c, int d) const;
  /// Not degenerate, and no other point inside or on the boundary.
  bool is_triangle_empty(int a, int b, int c) const;
  /// v follows u counter-clockwise on the boundary of the convex hull, collinear points included.
  bool is_hull_half_edge(int u, int v) const;
  bool is_on_hull(int v) const { return on_hull_[v]; }

  /// Points strictly inside the circumcircle. Requires a triangle that is not degenerate.
  int triangle_order(int a, int b, int c) const;
  int triangle_order_plain(int a, int b, int c) const;
  /// The largest order of a triangle; 0 for none.
  int order(const Triangles& triangles) const;
  int order_plain(const Triangles& triangles) const;

  /// The least number of points strictly inside any circle through u and v: the sweep of the whole
  /// pencil. Empty if the segment passes through a third point or all points are collinear.
  std::optional<int> edge_order(int u, int v) const;
  /// The useful order by the paper's Lemma 4. Empty as above.
  std::optional<int> useful_order_by_lemma(int u, int v) const;

  /// All triples that are not degenerate and have no point inside their circle, perturbed.
  Triangles delaunay() const;
  /// All empty triangles of order at most `max_order`, by trying all triples.
  Triangles empty_triangles(int max_order) const;
  /// The Delaunay triangles whose interior the segment meets: the hull of the edge.
  Triangles hull_of_edge(int u, int v) const;

  /// Heights compared lexicographically as (z, x, y). Requires heights.
  bool is_lower(int u, int v) const { return height_rank_[u] < height_rank_[v]; }
  ExtremaCount count_extrema(const Triangles& triangles) const;
  /// The same where other vertices than those of the hull are boundary.
  ExtremaCount count_extrema(const Triangles& triangles, const std::vector<bool>& boundary) const;

  /// Rotated (and turned, if need be) to canonical triangles, sorted.
  Triangles canonical(const Triangles& triangles) const;
  /// Empty if the triangles are a triangulation of all the points, else what is wrong. By the
  /// definition: empty triangles, no two of which overlap, as large together as the convex hull.
  std::string why_not_triangulation(const Triangles& triangles) const;
  /// The interiors of two triangles have a point in common.
  bool triangles_overlap(const Triangle& s, const Triangle& t) const;

 private:
  struct RationalPoint {
    mpq_class x, y;
  };

  std::size_t stride() const { return points_.size(); }
  void scale_to_integers(const std::vector<RationalPoint>& exact);
  void fill_orientations();
  void rank_lexicographically();
  void find_hull();
  int determinant_sign(int i, int j, int k, int l) const;
  int perturbed_determinant_sign(int i, int j, int k, int l) const;
  template <class Sign>
  int sign_of_quadruple(std::array<int, 4> q, std::vector<std::int8_t>& memo, Sign sign) const;
  /// The first point on u → v's left (side = 1) or right (-1): the circle through the three holds
  /// no point of that side. Empty if the side is.
  std::optional<int> first_point(int u, int v, int side) const;

  Points points_;
  Heights z_;
  std::vector<mpz_class> x_, y_, lift_;  // scaled
  std::vector<std::int8_t> orient_;
  std::vector<mpz_class> double_area_;  // of i < j < k
  std::vector<int> lexicographic_rank_;
  std::vector<int> height_rank_;
  std::vector<bool> on_hull_;
  mutable std::vector<std::int8_t> plain_sign_, perturbed_sign_;  // of i < j < k < l
};

/// No bound on the order.
inline constexpr int kUnrestricted = 1 << 20;

/// Calls visit(triangles, order) for every triangulation of all the points whose triangles all have
/// order at most max_order, each once. The triangles are canonical but not sorted. There are none
/// if all points are collinear. Meant for n <= 12; a 4×4 lattice still works.
void for_each_triangulation(const Instance& instance, int max_order,
                            const std::function<void(const Triangles&, int)>& visit);
std::size_t count_triangulations(const Instance& instance, int max_order = kUnrestricted);

struct OrderedTriangle {
  Triangle triangle;
  int order = 0;
};

/// The same for the triangulations that consist of the given triangles, whose orders are what is
/// said of them. The triangles must be canonical, different and empty.
void for_each_triangulation(const Instance& instance, const std::vector<OrderedTriangle>& triangles,
                            const std::function<void(const Triangles&, int)>& visit);

struct Triangulation {
  Triangles triangles;
  int order = 0;
};

/// Those same triangulations, each with its triangles sorted.
std::vector<Triangulation> list_triangulations(const Instance& instance,
                                               const std::vector<OrderedTriangle>& triangles);

/// The least number of local minima, maxima and extrema over all triangulations of order <= k, for
/// every k.
struct Optima {
  std::vector<int> minima, maxima, extrema;  // indexed by k; the last is that of every larger k

  static int at(const std::vector<int>& of, int k);
};

/// All triangulations (up to an order), and what the definitions say about edges and triangles.
class Catalogue {
 public:
  explicit Catalogue(const Instance& instance, int max_order = kUnrestricted);

  const std::vector<Triangulation>& triangulations() const { return triangulations_; }
  /// The least order of a triangulation with this edge; empty if there is none.
  std::optional<int> useful_order(int u, int v) const;
  /// The least order of a triangulation with this triangle; empty if there is none.
  std::optional<int> least_order_with(const Triangle& triangle) const;
  std::vector<Edge> useful_edges(int k) const;
  /// Useful edges that no other useful edge crosses.
  std::vector<Edge> fixed_edges(int k) const;
  /// Edges of every triangulation of order <= k.
  std::vector<Edge> edges_in_all(int k) const;
  /// Empty triangles of order <= k with three useful edges.
  Triangles valid_triangles(int k) const;
  /// With the heights that `heights` has; its points must be those of the catalogue. A point that
  /// no triangle uses is no extremum.
  Optima optima(const Instance& heights) const;

 protected:
  /// Of other triangulations, or with other orders: all triangles that may be used, sorted,
  /// and all triangulations.
  Catalogue(const Instance& instance, std::vector<OrderedTriangle> triangles,
            std::vector<Triangulation> triangulations);

 private:
  const Instance& instance_;
  std::vector<OrderedTriangle> triangles_;
  std::vector<Triangulation> triangulations_;
  std::vector<int> useful_;  // n × n; kUnrestricted where there is none
};

}  // namespace oracle
