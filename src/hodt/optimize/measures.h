// What a triangle measures. A new measure is one more function here, and a name in objective.
#pragma once

#include <span>

#include "hodt/base/buffer.h"
#include "hodt/geometry/point.h"
#include "hodt/mesh/triangle_mesh.h"
#include "hodt/optimize/objective.h"

namespace hodt {

/// Values of triangles for an objective of kind measured, and how they combine. `z` may be empty
/// unless the measure needs heights. A view: the points and heights must outlive it.
class TriangleValues {
 public:
  TriangleValues(const Objective& objective, std::span<const Point> xy, std::span<const double> z)
      : objective_(objective), xy_(xy), z_(z) {}

  /// The value of a triangle, its corners in any order; never negative, at most 1e150.
  double of(VertexId a, VertexId b, VertexId c) const;

  /// The sum, the larger or the smaller one. Several values combine alike in any order, up to
  /// rounding.
  double combine(double x, double y) const {
    switch (objective_.aggregate) {
      case Aggregate::sum:
        return x + y;
      case Aggregate::max:
        return x > y ? x : y;
      case Aggregate::min:
        return x < y ? x : y;
    }
    return x;
  }
  /// What combining with changes nothing.
  double neutral() const;
  bool better(double x, double y) const {
    return objective_.direction == Direction::minimize ? x < y : x > y;
  }

  /// Whether the two triangles of the first pair are better than those of the second, by value, and
  /// lexicographically (the sorted values) for max and min.
  bool better_pair(double a1, double a2, double b1, double b2) const;

  /// The value of every triangle.
  Buffer<double> of_each(const TriangleMesh& mesh) const;
  /// The objective's value of a triangulation, given those of its triangles.
  double of(const TriangleMesh& mesh, std::span<const double> each) const;

  const Objective& objective() const { return objective_; }

 private:
  double measured(VertexId a, VertexId b, VertexId c) const;

  const Objective objective_;
  std::span<const Point> xy_;
  std::span<const double> z_;
};

}  // namespace hodt
