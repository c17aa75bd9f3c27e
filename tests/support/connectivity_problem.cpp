#include "connectivity_problem.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

namespace hodt {

namespace {

std::string array_problem(const TriangleMesh& mesh) {
  const std::size_t origins = mesh.origins().size(), twins = mesh.twins().size();
  if (origins != twins) return fmt::format("{} origins but {} twins", origins, twins);
  if (origins % 3 != 0) return fmt::format("{} half-edges are not three a triangle", origins);
  if (origins >= kNone) return fmt::format("{} half-edges are too many to be numbered", origins);
  return "";
}

std::string corner_problem(const TriangleMesh& mesh) {
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.corners(TriangleId(t));
    for (const VertexId v : {a, b, c})
      if (v >= mesh.vertex_count())
        return fmt::format("triangle {} has the corner {}, but there are {} vertices", t, Index(v),
                           mesh.vertex_count());
    if (a == b || b == c || c == a)
      return fmt::format("triangle {} has a corner twice: {}, {}, {}", t, Index(a), Index(b),
                         Index(c));
  }
  return "";
}

std::string twin_problem(const TriangleMesh& mesh) {
  for (Index i = 0; i < mesh.halfedge_count(); ++i) {
    const HalfEdgeId h(i), g = mesh.twin(h);
    if (!g.valid()) continue;
    if (g >= mesh.halfedge_count())
      return fmt::format("half-edge {} has the twin {}, but there are {} half-edges", i, Index(g),
                         mesh.halfedge_count());
    if (mesh.twin(g) != h)
      return fmt::format("half-edge {} has the twin {}, whose twin is another", i, Index(g));
    if (mesh.origin(g) != mesh.target(h) || mesh.target(g) != mesh.origin(h))
      return fmt::format("half-edge {} runs from {} to {}, its twin {} from {} to {}", i,
                         Index(mesh.origin(h)), Index(mesh.target(h)), Index(g),
                         Index(mesh.origin(g)), Index(mesh.target(g)));
  }
  return "";
}

/// From here on, steps around a vertex are a permutation with gaps, so that walks end.
std::string fan_problem(const TriangleMesh& mesh) {
  std::vector<Index> corners(mesh.vertex_count(), 0);
  for (const Index v : mesh.origins()) ++corners[v];
  const Buffer<HalfEdgeId> outgoing = outgoing_halfedges(mesh);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (!outgoing[v].valid()) continue;
    Index passed = 0;
    for_each_outgoing(mesh, outgoing[v], [&](HalfEdgeId) { ++passed; });
    if (passed != corners[v])
      return fmt::format("vertex {} has {} triangles, but only {} of them around it", v, corners[v],
                         passed);
  }
  return "";
}

std::size_t reachable_triangles(const TriangleMesh& mesh) {
  std::vector<bool> seen(mesh.triangle_count(), false);
  std::vector<Index> stack{0};
  seen[0] = true;
  std::size_t count = 0;
  while (!stack.empty()) {
    const Index t = stack.back();
    stack.pop_back();
    ++count;
    for (Index h = 3 * t; h < 3 * t + 3; ++h) {
      const HalfEdgeId g = mesh.twin(HalfEdgeId(h));
      if (!g.valid() || seen[TriangleMesh::triangle(g)]) continue;
      seen[TriangleMesh::triangle(g)] = true;
      stack.push_back(TriangleMesh::triangle(g));
    }
  }
  return count;
}

/// A connected surface of genus g with b boundaries has V - E + F = 2 - 2g - b: that is 1 only for
/// the disk (g = 0, b = 1), as surfaces made of twins in opposite directions are orientable.
std::string disk_problem(const TriangleMesh& mesh) {
  const std::size_t triangles = mesh.triangle_count();
  if (triangles == 0) return "there is no triangle";
  if (const std::size_t reached = reachable_triangles(mesh); reached != triangles)
    return fmt::format("only {} of {} triangles are connected with triangle 0", reached, triangles);
  std::vector<bool> used(mesh.vertex_count(), false);
  for (const Index v : mesh.origins()) used[v] = true;
  const auto vertices = static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
  const auto boundary =
      static_cast<std::size_t>(std::count(mesh.twins().begin(), mesh.twins().end(), kNone));
  const std::size_t edges = (3 * triangles + boundary) / 2;
  if (vertices + triangles != edges + 1)
    return fmt::format("{} vertices - {} edges + {} triangles is not 1: no disk", vertices, edges,
                       triangles);
  return "";
}

}  // namespace

std::string connectivity_problem(const TriangleMesh& mesh, Surface surface) {
  // Each check relies on those before it.
  for (const auto check : {array_problem, corner_problem, twin_problem, fan_problem})
    if (std::string problem = check(mesh); !problem.empty()) return problem;
  return surface == Surface::disk ? disk_problem(mesh) : "";
}

}  // namespace hodt
