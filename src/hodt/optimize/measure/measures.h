// What a triangle measures. A new measure is one more function here, and a name in objective; one's
// own is an OwnTriangleMeasure.
// Tested by tests/optimize/optimize_measure_test.cpp.
#pragma once

#include <cstddef>
#include <span>

#include "hodt/base/buffer.h"
#include "hodt/geometry/point.h"
#include "hodt/mesh/triangle_mesh.h"
#include "hodt/optimize/aggregator.h"

namespace hodt {

/// Values of triangles for an objective with a TriangleMeasure, and how they combine. `z` may be
/// empty unless the measure needs heights. A view: the points and heights must outlive it.
class TriangleValues : public Aggregator {
 public:
  TriangleValues(const Objective& objective, std::span<const Point> xy, std::span<const double> z);

  /// The value of a triangle, finite and never negative; the corners in any order,
  /// counter-clockwise for measures of one's own. Throws InputError if a double cannot hold it.
  double of(VertexId a, VertexId b, VertexId c) const;

  /// Whether the two triangles of the first pair are better than those of the second, by value, and
  /// lexicographically (the sorted values) for max and min. Values, or ranks.
  bool better_pair(double a1, double a2, double b1, double b2) const;
  /// The same of so many pairs, side by side.
  void better_pairs(std::size_t count, const double* a1, const double* a2, const double* b1,
                    const double* b2, bool* is_better) const;

  /// Moves the edges whose flips make a better pair of triangles to the front, in their order, and
  /// returns how many they are. No edge may be on the boundary. By sums, what the others would gain
  /// in spite of that, as a gain within rounding is none, is added to `missed`.
  std::size_t keep_better_flips(const TriangleMesh& mesh, std::span<HalfEdgeId> edges,
                                ExactSum& missed) const;

  /// The objective's value of a triangulation.
  double of(const TriangleMesh& mesh) const { return with_flips(mesh, {}).before; }
  /// That, and what flips make of it. No two may have a triangle in common. The bound is that of
  /// sums that are better by what was missed.
  struct BeforeAfter {
    double before, after, bound;
  };
  BeforeAfter with_flips(const TriangleMesh& mesh, std::span<const HalfEdgeId> flips,
                         const ExactSum& missed = {}) const;

  /// What is missing when the edges of all triangles count half: that of the hull.
  Total half_boundary_length(const TriangleMesh& mesh) const;

 private:
  // Ranks compare as values do, and for sums they are the values: angles that are compared only
  // need no arctangents. They are measured block by block, or one by one.
  class BlockRanks;
  struct Totals;
  template <class F>
  void with_rank(const F& f) const;
  double rank(VertexId a, VertexId b, VertexId c) const;
  bool compares_angles() const;
  double value(double rank) const;
  bool is_triangle(VertexId a, VertexId b, VertexId c) const;
  double of_none() const;
  double own_value(VertexId a, VertexId b, VertexId c) const;
  double wide_value(VertexId a, VertexId b, VertexId c) const;
  double wide_rank(VertexId a, VertexId b, VertexId c) const;
  [[noreturn]] void throw_out_of_range(VertexId a, VertexId b, VertexId c, bool is_large) const;
  Totals fold(const TriangleMesh& mesh, std::size_t first, std::size_t last,
              const Buffer<bool>& flipped) const;
  Totals fold_flipped(const TriangleMesh& mesh, std::span<const HalfEdgeId> flips,
                      Buffer<bool>& flipped) const;

  TriangleMeasure measure_;
  bool is_wide_;        // no double holds all squares and products of the coordinates
  bool is_one_by_one_;  // nothing to measure side by side
  std::span<const Point> xy_;
  std::span<const double> z_;
};

}  // namespace hodt
