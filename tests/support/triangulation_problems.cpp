#include "triangulation_problems.h"

#include <algorithm>
#include <vector>

#include "boundary.h"
#include <fmt/format.h>

#include "hodt/base/parallel.h"
#include "hodt/geometry/predicates.h"
#include "hodt/order/circle_counter.h"

// Why turns alone prove a triangulation. Every triangle is counter-clockwise, and the boundary is
// one closed path that turns left or goes straight on, once around: a convex polygon P, passed
// once. The boundaries of the triangles add up to that path, since the two half-edges of an inner
// edge cancel. So do the winding numbers: a point that is on no edge lies in as many triangles as
// P winds around it, which is one inside P and none outside. So triangles never overlap and fill P.
// Nor is a vertex where it should not be: its triangles would overlap those that are there, for
// around a vertex they fill a full turn, or at the boundary all that is inside P. With every point
// a vertex, all points are in P, and P is their convex hull.

namespace hodt {

namespace {

bool is_counter_clockwise(std::span<const Point> points, const TriangleMesh& mesh, Index t) {
  const auto [a, b, c] = mesh.corners(TriangleId(t));
  return orient(points[a], points[b], points[c]) > 0;
}

std::string clockwise_problem(std::span<const Point> points, const TriangleMesh& mesh) {
  for (Index t = 0; t < mesh.triangle_count(); ++t)
    if (!is_counter_clockwise(points, mesh, t))
      return fmt::format("triangle {} is not counter-clockwise", t);
  return "";
}

/// Whether the boundary is one path around a convex polygon, passed once. Of the directions of a
/// path that turns left all the time, those to the right (straight up among them) are one run in
/// each turn.
std::string hull_problem(std::span<const Point> points, const TriangleMesh& mesh) {
  const HalfEdgeId start = first_on_boundary(mesh);
  if (!start.valid()) return "there is no boundary";
  const auto edges = std::count(mesh.twins().begin(), mesh.twins().end(), kNone);
  const auto goes_right = [&](HalfEdgeId h) {
    return lexicographically_less(points[mesh.origin(h)], points[mesh.target(h)]);
  };
  HalfEdgeId h = start;
  int passed = 0, turns = 0;
  do {
    const HalfEdgeId following = following_on_boundary(mesh, h);
    const VertexId v = mesh.target(h);
    const int turn = orient(points[mesh.origin(h)], points[v], points[mesh.target(following)]);
    if (turn < 0) return fmt::format("the boundary turns right at vertex {}", Index(v));
    if (turn == 0 && goes_right(h) != goes_right(following))
      return fmt::format("the boundary turns back at vertex {}", Index(v));
    turns += !goes_right(h) && goes_right(following);
    ++passed;
    h = following;
  } while (h != start);
  if (passed != edges)
    return fmt::format(
        "the boundary is more than one path: {} of its {} edges are on that of "
        "half-edge {}",
        passed, edges, Index(start));
  if (turns != 1) return fmt::format("the boundary winds around {} times", turns);
  return "";
}

std::string unused_problem(std::span<const Point> points, const TriangleMesh& mesh) {
  if (points.size() != mesh.vertex_count())
    return fmt::format("{} points, but {} vertices", points.size(), mesh.vertex_count());
  std::vector<bool> used(points.size(), false);
  for (const Index v : mesh.origins()) used[v] = true;
  const auto unused = std::find(used.begin(), used.end(), false);
  if (unused != used.end()) return fmt::format("vertex {} has no triangle", unused - used.begin());
  return "";
}

}  // namespace

std::string embedding_problem(std::span<const Point> points, const TriangleMesh& mesh) {
  for (const auto check : {unused_problem, clockwise_problem, hull_problem})
    if (std::string problem = check(points, mesh); !problem.empty()) return problem;
  return "";
}

std::string order_problem(const DelaunayGraph& graph, const TriangleMesh& mesh, Index k) {
  if (mesh.vertex_count() != graph.xy.size())
    return fmt::format("{} vertices, but the graph has {}", mesh.vertex_count(), graph.xy.size());
  const Index limit = std::min(k, kNone - 2);
  constexpr std::size_t kPiece = 2048;
  const std::size_t triangles = mesh.triangle_count();
  std::vector<std::string> problems((triangles + kPiece - 1) / kPiece);
  PerThread<CircleCounter> counters([&] { return CircleCounter(graph); });
  const auto problem_of = [&](Index t) -> std::string {
    if (!is_counter_clockwise(graph.xy, mesh, t))
      return fmt::format("triangle {} is not counter-clockwise", t);
    const auto [a, b, c] = mesh.corners(TriangleId(t));
    if (counters.mine().count(a, b, c, limit) <= limit) return "";
    return fmt::format("triangle {} ({}, {}, {}) has more than {} points in its circle", t,
                       Index(a), Index(b), Index(c), k);
  };
  parallel_for(0, problems.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t piece = first; piece < last; ++piece) {
      const std::size_t end = std::min(triangles, (piece + 1) * kPiece);
      for (std::size_t t = piece * kPiece; t < end && problems[piece].empty(); ++t)
        problems[piece] = problem_of(static_cast<Index>(t));
    }
  });
  for (std::string& problem : problems)
    if (!problem.empty()) return std::move(problem);
  return "";
}

std::string delaunay_problem(std::span<const Point> points, const TriangleMesh& mesh) {
  if (std::string problem = clockwise_problem(points, mesh); !problem.empty()) return problem;
  for (Index i = 0; i < mesh.halfedge_count(); ++i) {
    const HalfEdgeId h(i), g = mesh.twin(h);
    if (!g.valid() || g < h) continue;
    const VertexId a = mesh.origin(h), b = mesh.target(h), c = mesh.apex(h), d = mesh.apex(g);
    if (in_circle(points[a], points[b], points[c], points[d]))
      return fmt::format("vertex {} is inside the circle of triangle {}, across the edge {}-{}",
                         Index(d), Index(TriangleMesh::triangle(h)), Index(a), Index(b));
  }
  return "";
}

}  // namespace hodt
