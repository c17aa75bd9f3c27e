#include "hodt/order/change_problem.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "hodt/base/parallel.h"
#include "hodt/geometry/predicates.h"

// Why this proves a triangulation. Every triangle is counter-clockwise, every half-edge that has a
// twin runs against it, and those that have none are the boundary of the hull, as before. So the
// boundaries of all triangles add up to that of the hull, and their winding numbers to its own: a
// point that is on no edge lies in one triangle if it is inside the hull, and in none outside. As
// there are as many triangles as in the Delaunay triangulation, no vertex is missing (Euler).

namespace hodt {

namespace {

using Edge = std::pair<Index, Index>;

class Checker {
 public:
  Checker(const DelaunayGraph& graph, const TriangleMesh& mesh)
      : graph_(graph), delaunay_(graph.mesh), mesh_(mesh) {}

  std::string problem() const {
    if (mesh_.vertex_count() != delaunay_.vertex_count() ||
        mesh_.origins().size() != delaunay_.origins().size() ||
        mesh_.twins().size() != delaunay_.twins().size())
      return "another number of vertices, triangles or half-edges";
    const auto find_changed = [&](std::size_t first, std::size_t last,
                                  std::vector<TriangleId>& found) {
      for (auto t = TriangleId(Index(first)); t < last; t = TriangleId(t + 1))
        if (is_changed(t)) found.push_back(t);
    };
    const std::vector<TriangleId> changed =
        parallel_collect<TriangleId>(0, mesh_.triangle_count(), 1 << 14, find_changed);
    const auto find_problem = [&](std::size_t first, std::size_t last,
                                  std::vector<std::string>& found) {
      for (std::size_t i = first; i < last && found.empty(); ++i)
        if (std::string wrong = problem_of(changed[i]); !wrong.empty())
          found.push_back(std::move(wrong));
    };
    const std::vector<std::string> problems =
        parallel_collect<std::string>(0, changed.size(), 1 << 12, find_problem);
    if (!problems.empty()) return problems.front();
    const std::string problem = boundary_problem(changed);
    return problem.empty() ? wall_problem(changed) : problem;
  }

 private:
  bool is_changed(TriangleId t) const {
    const HalfEdgeId h = TriangleMesh::halfedge(t);
    bool is_changed = false;
    for (Index i = h; i < h + 3; ++i)
      is_changed |= (mesh_.origins()[i] != delaunay_.origins()[i]) |
                    (mesh_.twins()[i] != delaunay_.twins()[i]);
    return is_changed;
  }

  std::string problem_of(TriangleId t) const {
    const auto [a, b, c] = mesh_.corners(t);
    for (const VertexId v : {a, b, c})
      if (v >= mesh_.vertex_count())
        return fmt::format("triangle {} has the corner {}, which is no vertex", t, Index(v));
    if (orient(graph_.point(a), graph_.point(b), graph_.point(c)) <= 0)
      return fmt::format("triangle {} is not counter-clockwise", t);
    for (Index i = 3 * t; i < 3 * t + 3; ++i)
      if (const HalfEdgeId h(i); !is_right(h, mesh_.twin(h)) || !is_right_for_twin(h))
        return fmt::format("half-edge {} has the twin {}, and they do not fit", i,
                           Index(mesh_.twin(h)));
    return "";
  }

  bool is_right(HalfEdgeId h, HalfEdgeId twin) const {
    if (!twin.valid()) return true;
    return twin < mesh_.halfedge_count() && mesh_.twin(twin) == h &&
           mesh_.origin(twin) == mesh_.target(h) && mesh_.target(twin) == mesh_.origin(h);
  }

  /// A triangle that is as it was still has this half-edge for a twin.
  bool is_right_for_twin(HalfEdgeId h) const {
    const HalfEdgeId before = delaunay_.twin(h);
    return !before.valid() || is_changed(TriangleMesh::triangle(before)) || mesh_.twin(h) == before;
  }

  std::string boundary_problem(const std::vector<TriangleId>& changed) const {
    if (boundary_of(mesh_, changed) == boundary_of(delaunay_, changed)) return "";
    return "the boundary is another one";
  }

  /// Walls are there if they are sides of the triangles in place of those that they were sides of.
  std::string wall_problem(const std::vector<TriangleId>& changed) const {
    if (!graph_.has_walls()) return "";
    std::vector<Edge> sides;
    for (const TriangleId t : changed)
      for (Index i = 3 * t; i < 3 * t + 3; ++i)
        if (const HalfEdgeId h(i); graph_.is_wall(mesh_.origin(h), mesh_.target(h)))
          sides.emplace_back(mesh_.origin(h), mesh_.target(h));
    std::sort(sides.begin(), sides.end());
    for (const TriangleId t : changed)
      for (Index i = 3 * t; i < 3 * t + 3; ++i) {
        const HalfEdgeId h(i);
        const Edge side(delaunay_.origin(h), delaunay_.target(h));
        if (graph_.walls[h] && !std::binary_search(sides.begin(), sides.end(), side))
          return fmt::format("the wall from vertex {} to {} is missing", side.first, side.second);
      }
    return "";
  }

  static std::vector<Edge> boundary_of(const TriangleMesh& mesh,
                                       const std::vector<TriangleId>& triangles) {
    std::vector<Edge> boundary;
    for (const TriangleId t : triangles)
      for (Index i = 3 * t; i < 3 * t + 3; ++i)
        if (const HalfEdgeId h(i); mesh.is_boundary(h))
          boundary.emplace_back(mesh.origin(h), mesh.target(h));
    std::sort(boundary.begin(), boundary.end());
    return boundary;
  }

  const DelaunayGraph& graph_;
  const TriangleMesh& delaunay_;
  const TriangleMesh& mesh_;
};

}  // namespace

std::string change_problem(const DelaunayGraph& graph, const TriangleMesh& mesh) {
  return Checker(graph, mesh).problem();
}

}  // namespace hodt
