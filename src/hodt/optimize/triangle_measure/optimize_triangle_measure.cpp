#include "hodt/optimize/triangle_measure/optimize_triangle_measure.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <utility>
#include <vector>

#include "hodt/base/parallel.h"
#include "hodt/mesh/replace_triangles.h"
#include "hodt/optimize/flip/flips.h"
#include "hodt/optimize/measure/measures.h"
#include "hodt/optimize/measure/trivial_bound.h"
#include "hodt/optimize/triangle_measure/faces.h"
#include "hodt/order/first_order/first_order.h"

namespace hodt {

namespace {

using Corners = std::array<VertexId, 3>;

/// Either diagonal of every quadrilateral may be taken, whatever is taken elsewhere.
MeasuredSolution optimize_first_order(const MeasureProblem& problem) {
  const TriangleMesh& mesh = problem.graph.mesh;
  const TriangleValues values(problem.objective, problem.graph.xy, problem.z);
  ExactSum missed;
  std::mutex mutex;
  std::vector<HalfEdgeId> flips =
      first_order_edges(problem.graph, [&](std::span<HalfEdgeId> edges) {
        ExactSum missed_here;
        const std::size_t kept = values.keep_better_flips(mesh, edges, missed_here);
        if (!missed_here.is_empty()) {
          const std::lock_guard lock(mutex);
          missed.add(missed_here);
        }
        return kept;
      });
  const auto [before, after, bound] = values.with_flips(mesh, flips, missed);
  return measured(values, MeshChange(std::move(flips)), before, after, bound);
}

/// Order 2 and more.
class Optimizer {
 public:
  explicit Optimizer(const MeasureProblem& problem)
      : problem_(problem),
        graph_(problem.graph),
        values_(problem.objective, graph_.xy, problem.z),
        is_sum_(problem.objective.aggregate == Aggregate::sum),
        mesh_(graph_.mesh),
        bound_(values_) {
    if (is_total_length(problem.objective)) bound_.add(values_.half_boundary_length(mesh_));
  }

  MeasuredSolution run() && {
    // What there is if time runs out, and what a face's program need not exceed.
    improve_by_flips(graph_, values_, problem_.order, problem_.deadline, mesh_);
    double bound = 0;
    try {
      solve_faces();
      bound = bound_.bound();
    } catch (const TimeIsUp&) {  // not all faces are known, and none is solved
      bound = trivial_bound(problem_.objective, graph_.xy, graph_.mesh);
    }
    const double before = values_.of(graph_.mesh), result = values_.of(mesh_);
    return measured(values_, MeshChange(std::move(mesh_)), before, result, bound);
  }

 private:
  void solve_faces();
  void take(Faces& faces, Index face, const FaceSolution& solution);
  double value_in_mesh(std::span<const TriangleId> places) const {
    return total_in_mesh(places).value();
  }
  Total total_in_mesh(std::span<const TriangleId> places) const {
    Total total(values_);
    for (const TriangleId t : places) {
      const auto [a, b, c] = mesh_.corners(t);
      total.add(values_.of(a, b, c));
    }
    return total;
  }

  const MeasureProblem& problem_;
  const DelaunayGraph& graph_;
  const TriangleValues values_;
  const bool is_sum_;
  TriangleMesh mesh_;  // the best so far
  Total bound_;        // of the faces, and of the triangles that are always there
};

void Optimizer::take(Faces& faces, Index face, const FaceSolution& solution) {
  const std::span<const TriangleId> places = faces.places(face);
  bound_.add(solution.bound);
  if (solution.chosen.empty()) return;
  std::vector<Corners> fresh;
  Total chosen(values_);
  for (const Index t : solution.chosen) {
    const FaceTriangle& triangle = faces.triangles(face)[t];
    fresh.push_back(triangle.corners);
    chosen.add(triangle.value);
  }
  // Equal largest values leave the rest better.
  const double value = value_in_mesh(places);
  if (values_.better(chosen.value(), value) || (!is_sum_ && chosen.value() == value))
    replace_triangles(mesh_, places, fresh);
}

void Optimizer::solve_faces() {
  constexpr std::size_t kPrograms = 400, kExactPrograms = 1'000'000;
  Faces faces(graph_, problem_.order, problem_.deadline);
  const std::span<FaceTriangle> triangles = faces.triangles();
  parallel_for(0, triangles.size(), 1 << 12, [&](std::size_t first, std::size_t last) {
    for (FaceTriangle& t : triangles.subspan(first, last - first))
      t.value = values_.of(t.corners[0], t.corners[1], t.corners[2]);
  });
  std::vector<FaceSolution> solutions(faces.size());
  PerThread<PolygonOptimum> polygons([] { return PolygonOptimum(); });
  parallel_for(0, faces.size(), 1, [&](std::size_t first, std::size_t last) {
    for (auto face = static_cast<Index>(first); face < last; ++face)
      if (faces.places(face).size() > 1)
        solutions[face] = faces.solve(
            face, values_, value_in_mesh(faces.places(face)), problem_.deadline,
            problem_.method == Method::exact ? kExactPrograms : kPrograms, polygons.mine());
  });
  if (problem_.method == Method::flip)
    for (FaceSolution& s : solutions) s.chosen.clear();  // the bounds are good all the same
  // Flips stay inside the faces, so a face is in its places still; as long as no triangle of the
  // mesh crosses a fixed edge, which none of order k does.
  for (Index face = 0; face < faces.size(); ++face) {
    if (faces.places(face).size() > 1)
      take(faces, face, solutions[face]);
    else
      bound_.add(total_in_mesh(faces.places(face)));
  }
  // Below the largest (or smallest) value of a face there may be something left to gain.
  if (!is_sum_) improve_by_flips(graph_, values_, problem_.order, problem_.deadline, mesh_);
}

}  // namespace

MeasuredSolution optimize_triangle_measure(const MeasureProblem& problem) {
  if (problem.order == 1) return optimize_first_order(problem);
  if (problem.order > 1) return Optimizer(problem).run();
  const TriangleValues values(problem.objective, problem.graph.xy, problem.z);
  const double value = values.of(problem.graph.mesh);
  return measured(values, {}, value, value, value);
}

}  // namespace hodt
