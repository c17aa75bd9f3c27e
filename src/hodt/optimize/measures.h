// What a triangle measures. A new measure is one more function here, and a name in objective.
#pragma once

#include <span>

#include "hodt/base/buffer.h"
#include "hodt/geometry/point.h"
#include "hodt/mesh/triangle_mesh.h"
#include "hodt/optimize/combination.h"

namespace hodt {

/// Where rounding leaves no area, or coordinates are huge, values can be infinite or undefined.
/// Then they are 1e150 or 0.
double finite(double value);

/// Values of triangles for an objective of kind measured, and how they combine. `z` may be empty
/// unless the measure needs heights. A view: the points and heights must outlive it.
class TriangleValues : public Combination {
 public:
  TriangleValues(const Objective& objective, std::span<const Point> xy, std::span<const double> z)
      : Combination(objective), xy_(xy), z_(z) {}

  /// The value of a triangle, its corners in any order; never negative, at most 1e150.
  double of(VertexId a, VertexId b, VertexId c) const;

  /// Whether the two triangles of the first pair are better than those of the second, by value, and
  /// lexicographically (the sorted values) for max and min.
  bool better_pair(double a1, double a2, double b1, double b2) const;

  /// The value of every triangle.
  Buffer<double> of_each(const TriangleMesh& mesh) const;
  /// The objective's value of a triangulation, given those of its triangles.
  double of(const TriangleMesh& mesh, std::span<const double> each) const;

 private:
  double measured(VertexId a, VertexId b, VertexId c) const;

  std::span<const Point> xy_;
  std::span<const double> z_;
};

}  // namespace hodt
