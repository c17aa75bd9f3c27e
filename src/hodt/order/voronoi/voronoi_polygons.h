// The cells of a Voronoi diagram as polygons, clipped to a box.
#pragma once

#include <span>
#include <vector>

#include "hodt/order/voronoi/voronoi.h"

namespace hodt {

/// The smallest box around the points, enlarged on all sides by this share of its longer side.
Box enlarged_bounding_box(std::span<const Point> xy, double share);

/// Coordinates are rounded, decisions are not: vertices of the diagram that are at the same place
/// (several points on one circle) have the same coordinates, so a cell that exists by the
/// perturbation only has no polygon. Neighbouring cells share their vertices bit for bit.
class VoronoiPolygons {
 public:
  /// The diagram must outlive this, and be of these points. Throws ParameterError unless the box
  /// has a finite area that is not zero.
  VoronoiPolygons(std::span<const Point> xy, const VoronoiDiagram& diagram, const Box& box);

  /// The corners of a cell, counter-clockwise; empty if it has no area in the box. The first corner
  /// does not come again at the end. May be called by several threads at once.
  void polygon_of(Index cell, std::vector<Point>& polygon) const;

 private:
  /// Homogeneous: the point (x / w, y / w) with w = 1, or with w = 0 the direction (x, y).
  struct Corner {
    double x, y, w;
  };
  /// One side of the box: inside is where sign * (coordinate - bound) >= 0.
  struct Side {
    double Corner::*coordinate;
    double bound, sign;
  };

  void scale(const Box& box);
  void place_vertices();
  void unite_vertices_at_one_place();
  Corner end_of_edge(HalfEdgeId h) const;
  Corner direction_of_edge(HalfEdgeId h) const;
  void append_vertex(HalfEdgeId h, std::vector<Corner>& corners) const;
  void corners_of(Index cell, std::vector<Corner>& corners) const;
  static void clip(const Side& side, std::vector<Corner>& corners, std::vector<Corner>& scratch);
  static Corner crossing(const Side& side, const Corner& in, const Corner& out);

  std::span<const Point> xy_;
  const VoronoiDiagram& diagram_;
  Buffer<HalfEdgeId> outgoing_;
  // Computed with in multiples of 2^exponent_, so that the box is neither huge nor tiny.
  int exponent_ = 0;
  Buffer<Point> scaled_;
  Box box_;
  double reach_ = 0;  // from where edges end in place of far vertices
  // Of each vertex of the diagram the first one at the same place, and where that is; not a number
  // if it is far from the box.
  Buffer<Index> first_at_place_;
  Buffer<Point> place_;
};

}  // namespace hodt
