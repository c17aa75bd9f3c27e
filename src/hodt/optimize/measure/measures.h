// What a triangle measures. A new measure is one more function here, and a name in objective.
#pragma once

#include <cstddef>
#include <span>

#include "hodt/base/buffer.h"
#include "hodt/base/lanes.h"
#include "hodt/geometry/point.h"
#include "hodt/mesh/triangle_mesh.h"
#include "hodt/optimize/combination.h"

namespace hodt {

/// Where rounding leaves no area, or coordinates are huge, values can be infinite or undefined.
/// Then they are 1e150 or 0.
HODT_INLINE double finite(double value) {
  constexpr double kLargest = 1e150;
  return value < kLargest ? value : value >= kLargest ? kLargest : 0;  // 0: not a number
}

/// Values of triangles for an objective of kind measured, and how they combine. `z` may be empty
/// unless the measure needs heights. A view: the points and heights must outlive it.
class TriangleValues : public Combination {
 public:
  TriangleValues(const Objective& objective, std::span<const Point> xy, std::span<const double> z)
      : Combination(objective),
        is_flat_area_(objective.measure == Measure::flat_area),
        xy_(xy),
        z_(z) {}

  /// The value of a triangle, its corners in any order; never negative, at most 1e150.
  double of(VertexId a, VertexId b, VertexId c) const;

  /// Whether the two triangles of the first pair are better than those of the second, by value, and
  /// lexicographically (the sorted values) for max and min. Values, or ranks.
  bool better_pair(double a1, double a2, double b1, double b2) const;
  /// The same of so many pairs, side by side.
  void better_pairs(std::size_t count, const double* a1, const double* a2, const double* b1,
                    const double* b2, bool* is_better) const;

  /// Moves the edges whose flips make a better pair of triangles to the front, in their order, and
  /// returns how many they are. No edge may be on the boundary.
  std::size_t keep_better_flips(const TriangleMesh& mesh, std::span<HalfEdgeId> edges) const;

  /// The objective's value of a triangulation.
  double of(const TriangleMesh& mesh) const { return with_flips(mesh, {}).before; }
  /// That, and what flips make of it. No two may have a triangle in common.
  struct BeforeAfter {
    double before, after;
  };
  BeforeAfter with_flips(const TriangleMesh& mesh, std::span<const HalfEdgeId> flips) const;

 private:
  // Ranks compare as values do, and for sums they are the values: angles that are compared only
  // need no arctangents. They are measured block by block.
  class Ranks;
  template <class F>
  void with_rank(const F& f) const;
  double value(double rank) const;
  BeforeAfter fold(const TriangleMesh& mesh, std::size_t first, std::size_t last,
                   const Buffer<bool>& flipped) const;
  double fold_flipped(const TriangleMesh& mesh, std::span<const HalfEdgeId> flips,
                      Buffer<bool>& flipped) const;
  double half_boundary_length(const TriangleMesh& mesh) const;

  bool is_flat_area_;
  std::span<const Point> xy_;
  std::span<const double> z_;
};

}  // namespace hodt
