// The regions where two triangulations of the same points differ.
// Tested by tests/optimize/in_order_test.cpp.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hodt/base/buffer.h"
#include "hodt/mesh/triangle_mesh.h"
#include "hodt/optimize/in_order/exchange.h"

namespace hodt {

/// The edges that both have cut the plane into regions, and each region can be triangulated as one
/// or as the other, whatever is done elsewhere. A view of both meshes; the first may be changed by
/// exchange() alone.
class MeshDifference {
 public:
  /// REQUIRES two triangulations of the same region on the same vertices.
  MeshDifference(TriangleMesh& mesh, const TriangleMesh& other);

  /// How many regions of more than one triangle there are.
  std::size_t size() const { return places_.size(); }
  /// What it would be to triangulate a region of the mesh, not exchanged so far, as in the other.
  void look_at(std::size_t region, Exchange& exchange) const;
  /// Does so.
  void exchange(std::size_t region, const Exchange& exchange);

 private:
  void match_edges();
  void find_regions();
  void find_regions_of_other();

  TriangleMesh& mesh_;
  const TriangleMesh& other_;
  Buffer<HalfEdgeId> in_mesh_;  // of every half-edge of the other mesh, or kNone
  Buffer<bool> is_common_;      // of every half-edge of the mesh
  Buffer<Index> region_;        // of every triangle of the mesh
  Buffer<Index> other_region_;  // of every triangle of the other
  std::vector<std::vector<TriangleId>> places_, other_places_;
};

}  // namespace hodt
