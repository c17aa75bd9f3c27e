#include "hodt/pipeline/given_tin.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "hodt/base/error.h"
#include "hodt/mesh/glued.h"
#include "hodt/tin/boundary_edges.h"
#include "hodt/tin/counter_clockwise.h"
#include "hodt/tin/embedding.h"

namespace hodt {

GivenTin given_tin(Tin tin) {
  const Embedding embedding = check_embedding(tin.points.xy, tin.triangles);
  if (!embedding.embedded)
    throw InputError("this is no mesh that can be improved: " + embedding.problem);
  make_counter_clockwise(tin);

  std::vector<Index> number(tin.points.size(), kNone);
  for (const auto& corners : tin.triangles)
    for (const Index v : corners) number[v] = 0;
  GivenTin given;
  Index next = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == kNone) continue;
    number[v] = next++;
    given.points.xy.push_back(tin.points.xy[v]);
    if (tin.points.has_heights()) given.points.z.push_back(tin.points.z[v]);
  }
  given.points.crs = std::move(tin.crs);
  given.unused_vertices = number.size() - next;
  for (auto& corners : tin.triangles)
    for (Index& v : corners) v = number[v];
  given.constraints.boundary = boundary_edges(tin.triangles);
  given.constraints.triangles = std::move(tin.triangles);
  given.number = std::move(number);
  return given;
}

TriangleMesh mesh_of_given(const Delaunay& delaunay, const PointSet& points,
                           std::span<const std::array<Index, 3>> triangles) {
  const VertexSet& vertices = delaunay.vertices;
  TriangleMesh mesh = glued(vertices.size(), triangles);
  // Where the domain touches itself, several vertices have the same row: those of the boundary are
  // told apart by the half-edges there.
  std::vector<Index> vertex_of(points.size(), kNone);
  for (Index v = 0; v < vertices.size(); ++v) vertex_of[vertices.row[v]] = v;
  if (vertices.size() == points.size()) {
    for (Index& origin : mesh.origins()) origin = vertex_of[origin];
    return mesh;
  }
  std::map<std::array<Index, 2>, Index> at_border;  // the origin of a boundary half-edge, by rows
  const TriangleMesh& other = delaunay.mesh;
  for (Index i = 0; i < other.halfedge_count(); ++i)
    if (const HalfEdgeId h(i); other.is_boundary(h))
      at_border[{vertices.row[other.origin(h)], vertices.row[other.target(h)]}] = other.origin(h);
  Buffer<Index> origins(mesh.halfedge_count());
  for (Index i = 0; i < origins.size(); ++i) origins[i] = vertex_of[mesh.origins()[i]];
  for (Index i = 0; i < origins.size(); ++i) {
    HalfEdgeId h(i);
    if (!mesh.is_boundary(h)) continue;
    const Index vertex = at_border.at({mesh.origin(h), mesh.target(h)});
    for (; h.valid(); h = mesh.rotate_ccw(h)) origins[h] = vertex;
  }
  mesh.origins() = std::move(origins);
  return mesh;
}

}  // namespace hodt
