#include "hodt/optimize/triangle_measure/faces.h"

#include <optional>

#include "hodt/base/parallel.h"
#include "hodt/geometry/predicates.h"
#include "hodt/mesh/find_outgoing.h"
#include "hodt/optimize/rounded_sum.h"
#include "hodt/order/triangles.h"

namespace hodt {

namespace {

using Corners = std::array<VertexId, 3>;

/// Proven, and little more: every place has a triangle, one of those given.
double loose_bound(const FaceProblem& face, const Aggregator& aggregator) {
  double best = face.triangles.front().value;
  for (const FaceTriangle& t : face.triangles)
    if (aggregator.better(t.value, best)) best = t.value;
  if (!aggregator.is_sum()) return best;
  const double product = double(face.size) * best;
  return bound_within(aggregator, product, 0x1p-52 * product);
}

}  // namespace

Faces::Faces(const DelaunayGraph& graph, Index order, const Deadline& deadline)
    : graph_(graph), fixed_(fixed_edges(graph, order, deadline)), faces_(graph, fixed_) {
  std::vector<std::pair<Index, Corners>> all;
  const auto add = [&](std::span<const TriangleRecord> piece) {
    const std::size_t before = all.size();
    all.resize(before + piece.size());
    parallel_for(0, piece.size(), 1 << 10, [&](std::size_t i, std::size_t last) {
      deadline.check();
      for (; i < last; ++i) {
        Corners c{VertexId(piece[i].a), VertexId(piece[i].b), VertexId(piece[i].c)};
        if (orient(graph.point(c[0]), graph.point(c[1]), graph.point(c[2])) < 0)
          std::swap(c[1], c[2]);
        all[before + i] = {face_of(c), c};
      }
    });
  };
  for_each_triangle(graph, TriangleClass::valid, order, own_numbering(graph.xy.size()), add,
                    deadline);
  first_.assign(faces_.size() + 1, 0);
  for (const auto& [face, corners] : all) ++first_[face + 1];
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  triangles_.resize(all.size());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (const auto& [face, corners] : all) triangles_[next[face]++].corners = corners;
}

/// That of the Delaunay triangle which the triangle begins in, at one corner: the first at which
/// few triangles have to be looked at for it. Hubs are corners of very many triangles.
Index Faces::face_of(const Corners& t) const {
  for (Index corner = 0; corner < 3; ++corner)
    if (const TriangleId place = beginning_at(t[corner], t[(corner + 1) % 3], kFewTriangles);
        place.valid())
      return faces_.face_of(place);
  return faces_.face_of(beginning_at(t[0], t[1], kNone));
}

/// The Delaunay triangle at v that a triangle with the side vw begins in, on the left of it; kNone
/// if it is not among the first `most`.
TriangleId Faces::beginning_at(VertexId v, VertexId w, Index most) const {
  const TriangleMesh& mesh = graph_.mesh;
  const Point &a = graph_.point(v), &b = graph_.point(w);
  const HalfEdgeId h = find_outgoing(mesh, graph_.outgoing[v], most, [&](HalfEdgeId g) {
                         return orient(a, graph_.point(mesh.target(g)), b) >= 0 &&
                                orient(a, b, graph_.point(mesh.apex(g))) > 0;
                       }).halfedge;
  return h.valid() ? TriangleMesh::triangle(h) : TriangleId();
}

FaceSolution Faces::solve(Index face, const Aggregator& aggregator, double value,
                          const Deadline& deadline, std::size_t most_programs,
                          PolygonOptimum& polygon, std::unique_ptr<FaceProgram>* program) {
  const auto bound_only = [&](const FaceProblem& problem) {
    return FaceSolution{{}, loose_bound(problem, aggregator)};
  };
  if (deadline.passed()) return bound_only({triangles(face), {}, places(face).size(), value});
  std::vector<std::pair<VertexId, VertexId>> sides;
  for (const TriangleId t : places(face))
    for (Index i = 0; i < 3; ++i)
      if (const HalfEdgeId h(3 * t + i); fixed_[h])
        sides.emplace_back(graph_.mesh.origin(h), graph_.mesh.target(h));
  const FaceProblem problem{triangles(face), sides, places(face).size(), value};
  if (std::optional<FaceSolution> best = polygon.solve(problem, aggregator))
    return *std::move(best);
  if (!FaceProgram::fits(problem, deadline)) return bound_only(problem);
  std::unique_ptr<FaceProgram> own;
  std::unique_ptr<FaceProgram>& kept = program != nullptr ? *program : own;
  if (!kept) kept = std::make_unique<FaceProgram>(problem, deadline, most_programs);
  FaceSolution solution = kept->solve(problem, aggregator);
  // A solver that fails leaves none, or a bad one.
  const double loose = loose_bound(problem, aggregator);
  if (!aggregator.better(loose, solution.bound)) solution.bound = loose;
  return solution;
}

}  // namespace hodt
