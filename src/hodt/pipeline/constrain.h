// Constraints, brought into a Delaunay triangulation.
// Tested by tests/exhaustive/constraints_small_test.cpp.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "hodt/base/error.h"
#include "hodt/delaunay/delaunay.h"
#include "hodt/geometry/constraints.h"
#include "hodt/geometry/point_set.h"
#include "hodt/order/constrained/constrained_delaunay.h"

namespace hodt {

/// Constraints cross each other elsewhere than at a point.
class CrossingError : public InputError {
 public:
  CrossingError(const std::string& what, std::vector<CrossingEdges> crossings)
      : InputError(what), crossings_(std::move(crossings)) {}
  /// By the numbers of the edges; those of the boundary follow the others.
  const std::vector<CrossingEdges>& crossings() const { return crossings_; }

 private:
  std::vector<CrossingEdges> crossings_;
};

/// Where two segments cross that do, rounded.
Point crossing_place(const Point& a, const Point& b, const Point& c, const Point& d);

/// Makes the Delaunay triangulation of the points the constrained one of the domain. Throws
/// CrossingError, naming two edges and the place; InputError if the boundary is not closed or no
/// triangle is left; ParameterError for a row that the points do not have.
ConstraintReport constrain(Delaunay& delaunay, const PointSet& points,
                           const Constraints& constraints);

}  // namespace hodt
