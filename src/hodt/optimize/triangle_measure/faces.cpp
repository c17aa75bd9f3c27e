#include "hodt/optimize/triangle_measure/faces.h"

#include <optional>

#include "hodt/base/parallel.h"
#include "hodt/geometry/predicates.h"
#include "hodt/optimize/rounded_sum.h"
#include "hodt/order/triangles.h"

namespace hodt {

namespace {

using Corners = std::array<VertexId, 3>;

/// Proven, and little more: every place has a triangle, one of those given.
double loose_bound(const FaceProblem& face, const Combination& combination) {
  double best = face.triangles.front().value;
  for (const FaceTriangle& t : face.triangles)
    if (combination.better(t.value, best)) best = t.value;
  if (!combination.is_sum()) return best;
  const double product = double(face.size) * best;
  return bound_within(combination, product, 0x1p-52 * product);
}

}  // namespace

Faces::Faces(const DelaunayGraph& graph, Index order)
    : graph_(graph), fixed_(fixed_edges(graph, order)), faces_(graph, fixed_) {
  std::vector<std::pair<Index, Corners>> all;
  for_each_triangle(
      graph, TriangleClass::valid, order, own_numbering(graph.xy.size()),
      [&](std::span<const TriangleRecord> piece) {
        const std::size_t before = all.size();
        all.resize(before + piece.size());
        parallel_for(0, piece.size(), 1 << 10, [&](std::size_t i, std::size_t last) {
          for (; i < last; ++i) {
            Corners c{VertexId(piece[i].a), VertexId(piece[i].b), VertexId(piece[i].c)};
            if (orient(graph.point(c[0]), graph.point(c[1]), graph.point(c[2])) < 0)
              std::swap(c[1], c[2]);
            all[before + i] = {face_of(c), c};
          }
        });
      });
  first_.assign(faces_.size() + 1, 0);
  for (const auto& [face, corners] : all) ++first_[face + 1];
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  triangles_.resize(all.size());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (const auto& [face, corners] : all) triangles_[next[face]++].corners = corners;
}

/// That of the Delaunay triangle which the triangle begins in, at one corner.
Index Faces::face_of(const Corners& t) const {
  const TriangleMesh& mesh = graph_.mesh;
  const Point &a = graph_.point(t[0]), &b = graph_.point(t[1]);
  Index face = kNone;
  for_each_outgoing(mesh, graph_.outgoing[t[0]], [&](HalfEdgeId h) {
    if (face != kNone) return;
    if (orient(a, graph_.point(mesh.target(h)), b) >= 0 &&
        orient(a, b, graph_.point(mesh.apex(h))) > 0)
      face = faces_.face_of(TriangleMesh::triangle(h));
  });
  return face;
}

FaceSolution Faces::solve(Index face, const Combination& combination, double value,
                          const Deadline& deadline, std::size_t most_programs,
                          PolygonOptimum& polygon, std::unique_ptr<FaceProgram>* program) {
  std::vector<std::pair<VertexId, VertexId>> sides;
  for (const TriangleId t : places(face))
    for (Index i = 0; i < 3; ++i)
      if (const HalfEdgeId h(3 * t + i); fixed_[h])
        sides.emplace_back(graph_.mesh.origin(h), graph_.mesh.target(h));
  const FaceProblem problem{triangles(face), sides, places(face).size(), value};
  if (std::optional<FaceSolution> best = polygon.solve(problem, combination))
    return *std::move(best);
  if (deadline.passed()) return {{}, loose_bound(problem, combination)};
  std::unique_ptr<FaceProgram> own;
  std::unique_ptr<FaceProgram>& kept = program != nullptr ? *program : own;
  if (!kept) kept = std::make_unique<FaceProgram>(problem, deadline, most_programs);
  FaceSolution solution = kept->solve(problem, combination);
  // A solver that fails leaves none, or a bad one.
  const double loose = loose_bound(problem, combination);
  if (!combination.better(loose, solution.bound)) solution.bound = loose;
  return solution;
}

}  // namespace hodt
