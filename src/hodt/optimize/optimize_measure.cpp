#include "hodt/optimize/optimize_measure.h"

#include <algorithm>
#include <array>
#include <vector>

#include "hodt/base/parallel.h"
#include "hodt/geometry/predicates.h"
#include "hodt/mesh/replace_triangles.h"
#include "hodt/optimize/face_program.h"
#include "hodt/optimize/flips.h"
#include "hodt/optimize/measures.h"
#include "hodt/optimize/optimize_edge_measure.h"
#include "hodt/optimize/polygon_optimum.h"
#include "hodt/order/first_order.h"
#include "hodt/order/fixed_edges.h"
#include "hodt/order/triangles.h"

namespace hodt {

namespace {

using Corners = std::array<VertexId, 3>;

class Optimizer {
 public:
  explicit Optimizer(const MeasureProblem& problem)
      : problem_(problem),
        graph_(problem.graph),
        values_(problem.objective, graph_.xy, problem.z),
        is_sum_(problem.objective.aggregate == Aggregate::sum) {
    solution_.mesh = graph_.mesh;
    ranks_ = values_.ranks(graph_.mesh);
    solution_.delaunay = values_.of(graph_.mesh, ranks_);
  }

  MeasuredSolution run() && {
    if (problem_.order == 1)
      flip_quadrilaterals();
    else if (problem_.order > 1)
      solve_faces();
    if (problem_.order > 1) ranks_ = values_.ranks(solution_.mesh);
    solution_.result = values_.of(solution_.mesh, ranks_);
    // Each face lost as much as that, or nothing.
    solution_.bound = is_sum_ ? solution_.result - gap_ : values_.combine(bound_, fixed_);
    if (problem_.order <= 1) solution_.bound = solution_.result;
    return std::move(solution_);
  }

 private:
  /// Either diagonal of every quadrilateral may be taken, whatever is taken elsewhere.
  void flip_quadrilaterals() {
    const auto keep_gains = [&](std::span<HalfEdgeId> edges) { return keep_better_flipped(edges); };
    const std::vector<HalfEdgeId> edges = first_order_edges(graph_, keep_gains);
    std::vector<double> left(edges.size()), right(edges.size());
    values_.ranks_flipped(graph_.mesh, edges, left.data(), right.data());
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const HalfEdgeId h = edges[i];
      ranks_[TriangleMesh::triangle(h)] = left[i];
      ranks_[TriangleMesh::triangle(graph_.mesh.twin(h))] = right[i];
      solution_.mesh.flip(h);
    }
  }

  /// Moves the edges whose flips gain to the front, and returns how many they are.
  std::size_t keep_better_flipped(std::span<HalfEdgeId> edges) const {
    const TriangleMesh& mesh = graph_.mesh;
    std::array<double, kMostFirstOrderEdges> left, right, left_now, right_now;
    std::array<bool, kMostFirstOrderEdges> is_better;
    values_.ranks_flipped(mesh, edges, left.data(), right.data());
    for (std::size_t i = 0; i < edges.size(); ++i) {
      left_now[i] = ranks_[TriangleMesh::triangle(edges[i])];
      right_now[i] = ranks_[TriangleMesh::triangle(mesh.twin(edges[i]))];
    }
    values_.better_pairs(edges.size(), left.data(), right.data(), left_now.data(), right_now.data(),
                         is_better.data());
    std::size_t kept = 0;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      edges[kept] = edges[i];
      kept += std::size_t{is_better[i]};
    }
    return kept;
  }

  void solve_faces();
  void sort_into_faces(const FixedFaces& faces);
  Index face_of(const FixedFaces& faces, const Corners& t) const;
  FaceSolution solve_face(const FixedFaces& faces, const Buffer<bool>& fixed, Index face,
                          PolygonOptimum& polygon) const;
  void take(const FixedFaces& faces, Index face, const FaceSolution& solution);
  FaceProblem problem_of(Index face, std::span<const TriangleId> places,
                         std::span<const std::pair<VertexId, VertexId>> sides) const {
    return {{triangles_.data() + first_[face], triangles_.data() + first_[face + 1]},
            sides,
            places.size(),
            value_in_mesh(places)};
  }
  double value_in_mesh(std::span<const TriangleId> places) const {
    double value = values_.neutral();
    for (const TriangleId t : places) {
      const auto [a, b, c] = solution_.mesh.corners(t);
      value = values_.combine(value, values_.of(a, b, c));
    }
    return value;
  }
  double loose_bound(const FaceProblem& face) const;

  const MeasureProblem& problem_;
  const DelaunayGraph& graph_;
  const TriangleValues values_;
  const bool is_sum_;
  MeasuredSolution solution_;
  Buffer<double> ranks_;                 // of its triangles
  double gap_ = 0;                       // of sums
  double bound_ = values_.neutral();     // of the others: of the faces
  double fixed_ = values_.neutral();     // and of the triangles that are always there
  std::vector<FaceTriangle> triangles_;  // valid, by face
  std::vector<std::size_t> first_;       // of each face
};

/// A triangle of any triangulation of order k is in one face: that of the Delaunay triangle which
/// it begins in, at one corner.
Index Optimizer::face_of(const FixedFaces& faces, const Corners& t) const {
  const TriangleMesh& mesh = graph_.mesh;
  const Point &a = graph_.point(t[0]), &b = graph_.point(t[1]);
  Index face = kNone;
  for_each_outgoing(mesh, graph_.outgoing[t[0]], [&](HalfEdgeId h) {
    if (face != kNone) return;
    if (orient(a, graph_.point(mesh.target(h)), b) >= 0 &&
        orient(a, b, graph_.point(mesh.apex(h))) > 0)
      face = faces.face_of(TriangleMesh::triangle(h));
  });
  return face;
}

void Optimizer::sort_into_faces(const FixedFaces& faces) {
  const Numbering numbering = own_numbering(graph_.xy.size());
  std::vector<std::pair<Index, FaceTriangle>> all;
  for_each_triangle(
      graph_, TriangleClass::valid, problem_.order, numbering,
      [&](std::span<const TriangleRecord> piece) {
        const std::size_t before = all.size();
        all.resize(before + piece.size());
        parallel_for(0, piece.size(), 1 << 10, [&](std::size_t first, std::size_t last) {
          for (std::size_t i = first; i < last; ++i) {
            Corners c{VertexId(piece[i].a), VertexId(piece[i].b), VertexId(piece[i].c)};
            if (orient(graph_.point(c[0]), graph_.point(c[1]), graph_.point(c[2])) < 0)
              std::swap(c[1], c[2]);
            all[before + i] = {face_of(faces, c), {c, values_.of(c[0], c[1], c[2])}};
          }
        });
      });
  first_.assign(faces.size() + 1, 0);
  for (const auto& [face, triangle] : all) ++first_[face + 1];
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  triangles_.resize(all.size());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (const auto& [face, triangle] : all) triangles_[next[face]++] = triangle;
}

/// Proven, and no more: every side has a triangle, one of those given.
double Optimizer::loose_bound(const FaceProblem& face) const {
  double best = face.triangles.front().value;
  for (const FaceTriangle& t : face.triangles)
    if (values_.better(t.value, best)) best = t.value;
  return is_sum_ ? double(face.size) * best : best;
}

FaceSolution Optimizer::solve_face(const FixedFaces& faces, const Buffer<bool>& fixed, Index face,
                                   PolygonOptimum& polygon) const {
  const std::span<const TriangleId> places = faces.triangles(face);
  std::vector<std::pair<VertexId, VertexId>> sides;
  for (const TriangleId t : places)
    for (Index i = 0; i < 3; ++i)
      if (const HalfEdgeId h(3 * t + i); fixed[h])
        sides.emplace_back(graph_.mesh.origin(h), graph_.mesh.target(h));
  const FaceProblem problem = problem_of(face, places, sides);
  if (auto best = polygon.solve(problem, values_)) return *std::move(best);
  constexpr std::size_t kPrograms = 400, kExactPrograms = 1'000'000;
  if (!problem_.deadline.passed())
    return solve_face_program(problem, values_, problem_.deadline,
                              problem_.method == Method::exact ? kExactPrograms : kPrograms);
  return {{}, loose_bound(problem)};
}

void Optimizer::take(const FixedFaces& faces, Index face, const FaceSolution& solution) {
  const std::span<const TriangleId> places = faces.triangles(face);
  double value = value_in_mesh(places);
  if (!solution.chosen.empty()) {
    std::vector<Corners> fresh;
    double chosen_value = values_.neutral();
    for (const Index t : solution.chosen) {
      const FaceTriangle& triangle = triangles_[first_[face] + t];
      fresh.push_back(triangle.corners);
      chosen_value = values_.combine(chosen_value, triangle.value);
    }
    // Equal sums differ by rounding; equal largest values leave the rest better.
    if (values_.better(chosen_value, value) || (!is_sum_ && chosen_value == value)) {
      replace_triangles(solution_.mesh, places, fresh);
      value = chosen_value;
    }
  }
  if (is_sum_)
    gap_ += value - solution.bound;
  else
    bound_ = values_.combine(bound_, solution.bound);
}

void Optimizer::solve_faces() {
  const Buffer<bool> fixed = fixed_edges(graph_, problem_.order);
  const FixedFaces faces(graph_, fixed);
  sort_into_faces(faces);
  // What there is if time runs out, and what a face's program need not exceed.
  improve_by_flips(graph_, values_, problem_.order, problem_.deadline, solution_.mesh);
  std::vector<FaceSolution> solutions(faces.size());
  PerThread<PolygonOptimum> polygons([] { return PolygonOptimum(); });
  parallel_for(0, faces.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t face = first; face < last; ++face)
      if (faces.triangles(Index(face)).size() > 1)
        solutions[face] = solve_face(faces, fixed, Index(face), polygons.mine());
  });
  if (problem_.method == Method::flip)
    for (FaceSolution& s : solutions) s.chosen.clear();  // the bounds are good all the same
  // Flips stay inside the faces, so a face is in its places still; as long as no triangle of the
  // mesh crosses a fixed edge, which none of order k does.
  for (Index face = 0; face < faces.size(); ++face) {
    if (faces.triangles(face).size() > 1)
      take(faces, face, solutions[face]);
    else if (!is_sum_)
      fixed_ = values_.combine(fixed_, value_in_mesh(faces.triangles(face)));
  }
  // Below the largest (or smallest) value of a face there may be something left to gain.
  if (!is_sum_)
    improve_by_flips(graph_, values_, problem_.order, problem_.deadline, solution_.mesh);
}

}  // namespace

MeasuredSolution optimize_measure(const MeasureProblem& problem) {
  if (is_of_edges(problem.objective.measure)) return optimize_edge_measure(problem);
  return Optimizer(problem).run();
}

}  // namespace hodt
