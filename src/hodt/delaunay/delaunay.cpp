#include "hodt/delaunay/delaunay.h"

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/base/parallel.h"
#include "hodt/delaunay/divide_and_conquer.h"

namespace hodt {

Delaunay delaunay(const PointView& points) {
  SpatialOrder order = spatial_order(points);
  if (order.vertices.size() < 3)
    throw InputError(fmt::format(
        "{} distinct point{}: a triangulation needs at least three that are not on one line",
        order.vertices.size(), order.vertices.size() == 1 ? "" : "s"));
  TriangleMesh mesh = divide_and_conquer(order);
  if (mesh.triangle_count() == 0)
    throw InputError(fmt::format(
        "all {} distinct points lie on one line, so there is no triangle; add a point off the line",
        order.vertices.size()));
  return {std::move(order.vertices), std::move(mesh), {}};
}

TriangleMesh in_input_numbering(TriangleMesh mesh, const VertexSet& vertices,
                                std::size_t input_rows) {
  Buffer<Index>& origins = mesh.origins();
  parallel_for(0, origins.size(), 1 << 16, [&](std::size_t first, std::size_t last) {
    for (std::size_t h = first; h < last; ++h) origins[h] = vertices.row[origins[h]];
  });
  mesh.set_vertex_count(input_rows);
  return mesh;
}

}  // namespace hodt
