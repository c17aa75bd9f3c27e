// From the Voronoi diagram of one order to that of the next.
// Tested by tests/order/voronoi_polygons_test.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hodt/order/voronoi/voronoi.h"

namespace hodt {

/// Divides every cell by the nearest of the points that are no members. What was new becomes old,
/// what was old disappears, and what is found inside the cells is new.
///
/// Inside a cell the answer is a tree that joins the new vertices on the cell's boundary, where the
/// nearest of the others changes. It is the dual of a triangulation: of an abstract convex polygon
/// whose corners, the cell's ring, are the points nearest along the boundary.
class VoronoiRefinement {
 public:
  VoronoiRefinement(std::span<const Point> xy, const VoronoiDiagram& coarse);
  VoronoiDiagram run();

 private:
  /// A corner of the abstract polygon, and the side from it to the next corner.
  struct Corner {
    VertexId site;    // none: infinity
    HalfEdgeId leaf;  // half-edge of an old vertex that the side is glued to; none at infinity
  };

  void gather_ring(Index cell);
  void triangulate_ring(Index cell);
  void choose_insertion_order();
  void add_triangle(Index a, Index b, Index c);
  void insert(Index corner);
  void legalise(HalfEdgeId h);
  void flip(HalfEdgeId h);
  void set_outer_twin(HalfEdgeId h, Index twin);
  bool conflicts(HalfEdgeId h, Index corner) const;
  bool is_infinite(Index corner) const { return !ring_[corner].site.valid(); }
  const Point& point(Index corner) const { return xy_[ring_[corner].site]; }
  void glue(Index a, Index b);
  void drop_infinite_triangles(Index first);
  void remove_last_into(Index triangle);

  VoronoiDiagram assemble() const;
  void number_cells(VoronoiDiagram& fine) const;
  void append_members(HalfEdgeId h, std::vector<VertexId>& members) const;

  std::span<const Point> xy_;
  const VoronoiDiagram& coarse_;
  const Index first_new_;  // of the coarse diagram's triangles; those from there on stay, as old
  const Index old_;        // how many these are
  Buffer<HalfEdgeId> outgoing_;

  // The finer diagram's triangles. In the cell that is being divided, site_ holds ring corners.
  std::vector<Index> twin_, site_;
  std::vector<Index> cell_;  // of each new triangle: the coarse cell that it lies in

  // The cell that is being divided.
  std::vector<Corner> ring_;
  std::vector<Index> next_, prev_;  // the corners present, as a ring
  std::vector<Index> side_;         // the half-edge on the side that begins at a corner
  std::vector<Index> removed_, pending_;
};

}  // namespace hodt
