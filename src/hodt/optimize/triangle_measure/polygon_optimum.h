// The best triangulation of a polygon from given triangles.
// Tested by tests/optimize/optimize_measure_test.cpp.
#pragma once

#include <optional>
#include <vector>

#include "hodt/optimize/triangle_measure/face_problem.h"

namespace hodt {

/// By dynamic programming over the triangles: O(their number + m²) for m vertices. For sums, and
/// for the largest or smallest value; among equals those where the others are good, too. Empty if
/// the face is no simple polygon (a side that is inside, a vertex that is met twice, an inner
/// component) or has more than kMostVertices. Holds scratch memory for one thread.
class PolygonOptimum {
 public:
  static constexpr Index kMostVertices = 600;

  std::optional<FaceSolution> solve(const FaceProblem& face, const Aggregator& values);

 private:
  struct Best {
    double value, secondary;
    double bound;  // no exact sum is better; otherwise the value
    Index triangle;
    Index apex;  // a position; kNone: there is no triangulation
  };
  struct Placed {
    Index first, apex, last;  // positions along the polygon, ascending
    Index triangle;
  };

  bool walk_around(const FaceProblem& face);
  Index position(VertexId v) const;

  std::vector<std::pair<VertexId, VertexId>> by_origin_;
  std::vector<std::pair<VertexId, Index>> positions_;  // sorted by vertex
  std::vector<Placed> placed_;
  std::vector<Best> best_;
};

}  // namespace hodt
