// The best triangulation of any face, as a linear program.
#pragma once

#include "hodt/base/deadline.h"
#include "hodt/optimize/face_problem.h"

namespace hodt {

/// For sums. One variable for each triangle; as many on the left of an inner edge as on its right,
/// and one on each side of the face: an integer solution is a triangulation, inner components or
/// not. The relaxation's optimum mostly is one already. The bound is evaluated anew from the dual
/// values, so it does not depend on what the solver believes.
///
/// Holds: bound is valid always, `chosen` is empty if the relaxation's optimum is no triangulation,
/// or if the solver ended (by the deadline, or by too many iterations) before there was one.
FaceSolution solve_face_program(const FaceProblem& face, const TriangleValues& values,
                                const Deadline& deadline);

}  // namespace hodt
