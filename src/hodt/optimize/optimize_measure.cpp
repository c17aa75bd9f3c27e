#include "hodt/optimize/optimize_measure.h"

#include "hodt/optimize/edge_measure/optimize_edge_measure.h"
#include "hodt/optimize/triangle_measure/optimize_triangle_measure.h"

namespace hodt {

MeasuredSolution optimize_measure(const MeasureProblem& problem) {
  return is_of_edges(problem.objective) ? optimize_edge_measure(problem)
                                        : optimize_triangle_measure(problem);
}

}  // namespace hodt
