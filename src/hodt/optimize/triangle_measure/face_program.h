// The best triangulation of any face, as a linear program.
// Tested by tests/optimize/optimize_measure_test.cpp.
#pragma once

#include <cstddef>

#include "hodt/base/deadline.h"
#include "hodt/optimize/solve/binary_program.h"
#include "hodt/optimize/triangle_measure/face_problem.h"

namespace hodt {

/// The best triangulation of a face, inner components or not, for sums and for the largest or
/// smallest value, one vector of values after another. One variable for each triangle; as many on
/// the left of an inner edge as on its right, and one on each side of the face: an integer solution
/// is a triangulation. The relaxation's optimum mostly is one already; if not, the search branches.
/// Bounds are evaluated anew from dual values, so they do not depend on what the solver believes.
class FaceProgram {
 public:
  FaceProgram(const FaceProblem& face, const Deadline& deadline, std::size_t most_programs);

  /// Whether there is time to begin: the solver looks at the clock only once it has taken up all
  /// triangles.
  static bool fits(const FaceProblem& face, const Deadline& deadline);

  /// The bound is valid always; `chosen` is empty if the deadline, or `most_programs` for one
  /// vector of costs, came before a triangulation. REQUIRES the face with which it was made, up to
  /// values.
  FaceSolution solve(const FaceProblem& face, const Aggregator& values);

 private:
  BinaryProgram program_;
};

}  // namespace hodt
