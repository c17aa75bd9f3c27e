#include "hodt/pipeline/examine_mesh.h"

#include "hodt/tin/boundary_edges.h"
#include "hodt/tin/counter_clockwise.h"

namespace hodt {

MeshFindings examine_mesh(Tin tin, std::vector<std::array<Index, 2>> walls) {
  MeshFindings findings;
  findings.embedding = check_embedding(tin.points.xy, tin.triangles);
  if (!findings.embedding.embedded) return findings;
  if (findings.embedding.clockwise > 0) make_counter_clockwise(tin);
  std::vector<std::array<Index, 2>> border;
  if (!findings.embedding.covers_hull) border = boundary_edges(tin.triangles);
  findings.order = order_of_mesh(tin.points, tin.triangles, walls, border);
  findings.quality = quality_of(tin.points.xy, tin.triangles);
  if (tin.points.has_heights()) findings.extrema = count_extrema(tin.points, tin.triangles);
  return findings;
}

}  // namespace hodt
