#include "hodt/mesh/replace_triangles.h"

#include <algorithm>
#include <stdexcept>
#include <tuple>
#include <vector>

namespace hodt {

namespace {

/// What an edge u -> v of the region is to be glued to.
struct Side {
  Index u, v;
  HalfEdgeId halfedge;
  auto key() const { return std::tuple(u, v); }
};

const Side* find(const std::vector<Side>& sides, Index u, Index v) {
  const auto it = std::lower_bound(sides.begin(), sides.end(), std::tuple(u, v),
                                   [](const Side& s, const auto& key) { return s.key() < key; });
  return it != sides.end() && it->key() == std::tuple(u, v) ? &*it : nullptr;
}

void sort(std::vector<Side>& sides) {
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return a.key() < b.key(); });
}

}  // namespace

void replace_triangles(TriangleMesh& mesh, std::span<const TriangleId> old,
                       std::span<const std::array<VertexId, 3>> fresh) {
  if (old.size() != fresh.size()) throw std::logic_error("a region changed its triangle count");
  std::vector<TriangleId> places(old.begin(), old.end());
  std::sort(places.begin(), places.end());
  std::vector<Side> outside, inside;  // by the edge as the region sees it
  for (const TriangleId t : old) {
    for (Index i = 0; i < 3; ++i) {
      const HalfEdgeId h(3 * t + i), twin = mesh.twin(h);
      if (twin.valid() &&
          std::binary_search(places.begin(), places.end(), TriangleMesh::triangle(twin)))
        continue;
      outside.push_back({mesh.origin(h), mesh.target(h), twin});
    }
  }
  for (std::size_t i = 0; i < old.size(); ++i) {
    for (Index j = 0; j < 3; ++j) {
      const HalfEdgeId h(3 * old[i] + j);
      mesh.set_origin(h, fresh[i][j]);
      inside.push_back({fresh[i][j], fresh[i][(j + 1) % 3], h});
    }
  }
  sort(outside);
  sort(inside);
  for (const Side& side : inside) {
    if (const Side* other = find(inside, side.v, side.u)) {
      mesh.glue(side.halfedge, other->halfedge);
    } else if (const Side* beyond = find(outside, side.u, side.v)) {
      mesh.glue(side.halfedge, beyond->halfedge);
    } else {
      throw std::logic_error("a region's triangles do not fit together");
    }
  }
}

}  // namespace hodt
