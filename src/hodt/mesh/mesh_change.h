// A triangulation told by what it changes in another one.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "hodt/base/prefetch.h"
#include "hodt/mesh/triangle_mesh.h"

namespace hodt {

/// Edges to flip, or a mesh in place of the other one. Flips can be looked at, and made, without a
/// copy of the mesh.
class MeshChange {
 public:
  /// Nothing.
  MeshChange() = default;
  /// One half-edge of each edge. REQUIRES that no two have a triangle in common.
  explicit MeshChange(std::vector<HalfEdgeId> flips) : flips_(std::move(flips)) {}
  explicit MeshChange(TriangleMesh mesh) : mesh_(std::move(mesh)) {}

  /// None if there is a mesh.
  std::span<const HalfEdgeId> flips() const { return flips_; }
  /// Null if there are flips only.
  const TriangleMesh* mesh() const { return mesh_ ? &*mesh_ : nullptr; }

  /// Makes the change. `mesh` is the one that it was told for.
  void apply_to(TriangleMesh& mesh) && {
    if (mesh_) mesh = *std::move(mesh_);
    flip(mesh);
  }
  /// The changed mesh, beside the one that it was told for.
  TriangleMesh applied_to(const TriangleMesh& mesh) const {
    TriangleMesh changed = mesh_ ? *mesh_ : mesh;
    flip(changed);
    return changed;
  }

 private:
  void flip(TriangleMesh& mesh) const {
    // What a flip touches is somewhere near in memory, and asked for in time.
    constexpr std::size_t kSoon = 12, kLater = 32;
    const auto twin_of = [&](std::size_t i) { return mesh.twin(flips_[i]); };
    for (std::size_t i = 0; i < flips_.size(); ++i) {
      if (i + kLater < flips_.size()) {
        prefetch(&mesh.origins()[twin_of(i + kLater)]);
        prefetch(&mesh.twins()[twin_of(i + kLater)]);
      }
      if (i + kSoon < flips_.size())
        for (const HalfEdgeId side : {flips_[i + kSoon], twin_of(i + kSoon)})
          if (const HalfEdgeId beyond = mesh.twin(TriangleMesh::next(side)); beyond.valid())
            prefetch(&mesh.twins()[beyond]);
      mesh.flip(flips_[i]);
    }
  }

  std::vector<HalfEdgeId> flips_;
  std::optional<TriangleMesh> mesh_;
};

}  // namespace hodt
