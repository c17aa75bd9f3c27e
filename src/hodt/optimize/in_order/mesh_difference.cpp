#include "hodt/optimize/in_order/mesh_difference.h"

#include <algorithm>
#include <array>
#include <utility>

#include "hodt/mesh/replace_triangles.h"

namespace hodt {

MeshDifference::MeshDifference(TriangleMesh& mesh, const TriangleMesh& other)
    : mesh_(mesh),
      other_(other),
      in_mesh_(other.halfedge_count(), HalfEdgeId()),
      is_common_(mesh.halfedge_count(), false),
      region_(mesh.triangle_count(), kNone),
      other_region_(other.triangle_count(), kNone) {
  match_edges();
  find_regions();
  find_regions_of_other();
}

void MeshDifference::match_edges() {
  // The half-edges that leave each vertex, by their targets.
  Buffer<Index> first(mesh_.vertex_count() + 1, 0);
  for (const Index v : mesh_.origins()) ++first[v + 1];
  for (std::size_t v = 0; v < mesh_.vertex_count(); ++v) first[v + 1] += first[v];
  std::vector<std::pair<Index, Index>> leaving(mesh_.halfedge_count());
  Buffer<Index> next(mesh_.vertex_count());
  std::copy_n(first.begin(), next.size(), next.begin());
  for (Index h = 0; h < mesh_.halfedge_count(); ++h)
    leaving[next[mesh_.origins()[h]]++] = {mesh_.target(HalfEdgeId(h)), h};
  for (std::size_t v = 0; v < mesh_.vertex_count(); ++v)
    std::sort(leaving.begin() + first[v], leaving.begin() + first[v + 1]);

  for (Index i = 0; i < other_.halfedge_count(); ++i) {
    const HalfEdgeId h(i);
    const Index v = other_.origin(h), target = other_.target(h);
    const auto end = leaving.begin() + first[v + 1];
    const auto found =
        std::lower_bound(leaving.begin() + first[v], end, std::pair<Index, Index>(target, 0));
    if (found == end || found->first != target) continue;
    in_mesh_[i] = HalfEdgeId(found->second);
    is_common_[found->second] = true;
  }
}

void MeshDifference::find_regions() {
  for (Index t = 0; t < mesh_.triangle_count(); ++t) {
    if (region_[t] != kNone) continue;
    const auto region = static_cast<Index>(places_.size());
    std::vector<TriangleId> places{TriangleId(t)};
    region_[t] = region;
    for (std::size_t i = 0; i < places.size(); ++i)
      for (Index side = 0; side < 3; ++side) {
        const HalfEdgeId h(3 * places[i] + side);
        if (is_common_[h]) continue;
        const TriangleId beyond = TriangleMesh::triangle(mesh_.twin(h));
        if (region_[beyond] != kNone) continue;
        region_[beyond] = region;
        places.push_back(beyond);
      }
    // A triangle of three edges that both have is in both.
    if (places.size() > 1)
      places_.push_back(std::move(places));
    else
      region_[t] = kNone;
  }
}

void MeshDifference::find_regions_of_other() {
  other_places_.resize(places_.size());
  for (Index i = 0; i < other_.halfedge_count(); ++i) {
    if (!in_mesh_[i].valid()) continue;
    const Index region = region_[TriangleMesh::triangle(in_mesh_[i])];
    const TriangleId t = TriangleMesh::triangle(HalfEdgeId(i));
    if (region == kNone || other_region_[t] != kNone) continue;
    other_region_[t] = region;
    other_places_[region].push_back(t);
  }
  for (Index region = 0; region < other_places_.size(); ++region) {
    std::vector<TriangleId>& places = other_places_[region];
    for (std::size_t i = 0; i < places.size(); ++i)
      for (Index side = 0; side < 3; ++side) {
        const HalfEdgeId h(3 * places[i] + side);
        if (in_mesh_[h].valid()) continue;
        const TriangleId beyond = TriangleMesh::triangle(other_.twin(h));
        if (other_region_[beyond] != kNone) continue;
        other_region_[beyond] = region;
        places.push_back(beyond);
      }
  }
}

void MeshDifference::look_at(std::size_t region, Exchange& exchange) const {
  exchange.before.clear();
  exchange.after.clear();
  for (const TriangleId t : places_[region]) {
    exchange.before.triangles.push_back(mesh_.corners(t));
    for (Index side = 0; side < 3; ++side) {
      const HalfEdgeId h(3 * t + side), twin = mesh_.twin(h);
      if (!twin.valid()) continue;
      const bool is_around = region_[TriangleMesh::triangle(twin)] != region;
      if (!is_around && twin < h) continue;
      (is_around ? exchange.before.around : exchange.before.inside)
          .push_back({mesh_.origin(h), mesh_.target(h), mesh_.apex(h), mesh_.apex(twin)});
    }
  }
  for (const TriangleId t : other_places_[region]) {
    exchange.after.triangles.push_back(other_.corners(t));
    for (Index side = 0; side < 3; ++side) {
      const HalfEdgeId h(3 * t + side), twin = other_.twin(h);
      if (!twin.valid()) continue;
      if (other_region_[TriangleMesh::triangle(twin)] != region) {
        // Beyond is what the mesh has there now.
        const VertexId beyond = mesh_.apex(mesh_.twin(in_mesh_[h]));
        exchange.after.around.push_back(
            {other_.origin(h), other_.target(h), other_.apex(h), beyond});
      } else if (h < twin) {
        exchange.after.inside.push_back(
            {other_.origin(h), other_.target(h), other_.apex(h), other_.apex(twin)});
      }
    }
  }
}

void MeshDifference::exchange(std::size_t region, const Exchange& exchange) {
  replace_triangles(mesh_, places_[region], exchange.after.triangles);
}

}  // namespace hodt
