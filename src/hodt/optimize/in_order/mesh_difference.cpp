#include "hodt/optimize/in_order/mesh_difference.h"

#include <algorithm>
#include <array>
#include <utility>

#include "hodt/mesh/replace_triangles.h"

namespace hodt {

namespace {

/// Adds to the places of a region all that is reached from them without crossing a common edge.
template <class IsCommon>
void spread(const TriangleMesh& mesh, const IsCommon& is_common, Index region,
            Buffer<Index>& regions, std::vector<TriangleId>& places) {
  for (std::size_t i = 0; i < places.size(); ++i)
    for (Index side = 0; side < 3; ++side) {
      const HalfEdgeId h(3 * places[i] + side);
      if (is_common(h)) continue;
      const TriangleId beyond = TriangleMesh::triangle(mesh.twin(h));
      if (regions[beyond] != kNone) continue;
      regions[beyond] = region;
      places.push_back(beyond);
    }
}

/// The triangles at the places of a region, and their edges. `beyond` says what the apex is across
/// an edge around it.
template <class Beyond>
void list(const TriangleMesh& mesh, const std::vector<TriangleId>& places,
          const Buffer<Index>& regions, const Beyond& beyond, Exchange::Side& found) {
  found.clear();
  for (const TriangleId t : places) {
    found.triangles.push_back(mesh.corners(t));
    for (Index side = 0; side < 3; ++side) {
      const HalfEdgeId h(3 * t + side), twin = mesh.twin(h);
      if (!twin.valid()) continue;
      const VertexId a = mesh.origin(h), b = mesh.target(h), c = mesh.apex(h);
      if (regions[TriangleMesh::triangle(twin)] != regions[t])
        found.around.push_back({a, b, c, beyond(h)});
      else if (h < twin)
        found.inside.push_back({a, b, c, mesh.apex(twin)});
    }
  }
}

}  // namespace

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
  const auto is_common = [&](HalfEdgeId h) { return is_common_[h]; };
  for (Index t = 0; t < mesh_.triangle_count(); ++t) {
    if (region_[t] != kNone) continue;
    const auto region = static_cast<Index>(places_.size());
    std::vector<TriangleId> places{TriangleId(t)};
    region_[t] = region;
    spread(mesh_, is_common, region, region_, places);
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
  const auto is_common = [&](HalfEdgeId h) { return in_mesh_[h].valid(); };
  for (Index region = 0; region < other_places_.size(); ++region)
    spread(other_, is_common, region, other_region_, other_places_[region]);
}

void MeshDifference::look_at(std::size_t region, Exchange& exchange) const {
  list(
      mesh_, places_[region], region_, [&](HalfEdgeId h) { return mesh_.apex(mesh_.twin(h)); },
      exchange.before);
  // Beyond is what the mesh has there now.
  list(
      other_, other_places_[region], other_region_,
      [&](HalfEdgeId h) { return mesh_.apex(mesh_.twin(in_mesh_[h])); }, exchange.after);
}

void MeshDifference::exchange(std::size_t region, const Exchange& exchange) {
  replace_triangles(mesh_, places_[region], exchange.after.triangles);
}

}  // namespace hodt
