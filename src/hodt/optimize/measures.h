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
  /// The same of so many pairs.
  void better_pairs(std::size_t count, const double* a1, const double* a2, const double* b1,
                    const double* b2, bool* is_better) const;

  /// Numbers that compare as the values of a mesh's triangles do, and for sums these values: angles
  /// that are compared only need no arctangents.
  Buffer<double> ranks(const TriangleMesh& mesh) const;
  /// The same of what flips would make: the triangle on the left of the edge's other diagonal, from
  /// the corner on its left, and the triangle on the right. No edge may be on the boundary.
  void ranks_flipped(const TriangleMesh& mesh, std::span<const HalfEdgeId> edges, double* left,
                     double* right) const;
  /// The objective's value of a triangulation, given those.
  double of(const TriangleMesh& mesh, std::span<const double> ranks) const;

 private:
  template <class F>
  void with_rank(const F& f) const;
  double half_boundary_length(const TriangleMesh& mesh) const;

  bool is_flat_area_;
  std::span<const Point> xy_;
  std::span<const double> z_;
};

}  // namespace hodt
