#include "hodt/pipeline/what_changed.h"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "hodt/geometry/heights.h"
#include "hodt/hydrology/pit_depths.h"
#include "hodt/hydrology/pit_water.h"

namespace hodt {

namespace {

/// One of the two triangulations, by the numbers of the TIN.
class Surface {
 public:
  Surface(const TriangleMesh& mesh, const VertexSet& vertices, std::span<const Index> number,
          std::size_t count)
      : lowest_(count, kNone),
        on_boundary_(count, false),
        level_set_(count),
        has_deeper_(count, false),
        sizes_(count) {
    std::iota(level_set_.begin(), level_set_.end(), Index{0});
    look_at_edges(mesh, vertices, number);
    measure_pits(mesh, vertices, number);
  }

  /// Vertices of no triangle are no minima.
  bool is_minimum(Index v) const { return sizes_[v].has_value() && lowest_[v] == kNone; }
  bool on_boundary(Index v) const { return on_boundary_[v]; }
  /// A minimum whose level set has no neighbour of smaller z.
  bool is_pit(Index v) { return !has_deeper_[find(v)]; }
  std::optional<PitSize> size(Index v) const { return is_minimum(v) ? sizes_[v] : std::nullopt; }
  /// The lowest of the lower neighbours.
  Index lowest_neighbour(Index v) const { return lowest_[v]; }

 private:
  Index find(Index v) {
    while (level_set_[v] != v) v = level_set_[v] = level_set_[level_set_[v]];
    return v;
  }

  void look_at_edges(const TriangleMesh& mesh, const VertexSet& vertices,
                     std::span<const Index> number) {
    const Heights heights{vertices.xy, vertices.z};
    std::vector<VertexId> lowest(lowest_.size());
    std::vector<Index> deeper;
    const auto look = [&](VertexId u, VertexId v) {
      const Index at = number[u];
      if (vertices.z[v] < vertices.z[u]) deeper.push_back(at);
      if (!heights.lower(v, u) || (lowest_[at] != kNone && !heights.lower(v, lowest[at]))) return;
      lowest_[at] = number[v];
      lowest[at] = v;
    };
    for (Index h = 0; h < mesh.halfedge_count(); ++h) {
      const VertexId u = mesh.origin(HalfEdgeId(h)), v = mesh.target(HalfEdgeId(h));
      look(u, v);
      look(v, u);
      if (mesh.is_boundary(HalfEdgeId(h))) on_boundary_[number[u]] = on_boundary_[number[v]] = true;
      if (vertices.z[u] == vertices.z[v]) level_set_[find(number[u])] = find(number[v]);
    }
    for (const Index v : deeper) has_deeper_[find(v)] = true;
  }

  void measure_pits(const TriangleMesh& mesh, const VertexSet& vertices,
                    std::span<const Index> number) {
    const std::vector<Pit> pits = pit_depths(mesh, vertices.xy, vertices.z);
    const std::vector<double> volumes = pit_volumes(mesh, vertices.xy, vertices.z, pits);
    for (std::size_t i = 0; i < pits.size(); ++i)
      sizes_[number[pits[i].bottom]] = PitSize{pits[i].depth, volumes[i]};
  }

  std::vector<Index> lowest_;
  std::vector<bool> on_boundary_;
  std::vector<Index> level_set_;
  std::vector<bool> has_deeper_;  // of level sets
  std::vector<std::optional<PitSize>> sizes_;
};

std::vector<MinimumChange> changed_minima(const TriangleMesh& before, const TriangleMesh& after,
                                          const VertexSet& vertices, const MinimaToKeep& keep,
                                          std::span<const Index> number, std::size_t count) {
  Surface old(before, vertices, number, count), now(after, vertices, number, count);
  std::vector<bool> is_kept(count, false);
  for (std::size_t v = 0; v < keep.is_kept.size(); ++v)
    if (keep.is_kept[v]) is_kept[number[v]] = true;
  std::vector<MinimumChange> minima;
  for (Index v = 0; v < count; ++v) {
    if (!old.is_minimum(v) && !now.is_minimum(v)) continue;
    MinimumChange minimum;
    minimum.vertex = v;
    minimum.fate = !old.is_minimum(v)   ? Fate::made
                   : !now.is_minimum(v) ? Fate::removed
                   : is_kept[v]         ? Fate::kept
                                        : Fate::left;
    minimum.on_boundary = old.on_boundary(v);
    minimum.is_pit = (old.is_minimum(v) ? old : now).is_pit(v);
    minimum.before = old.size(v);
    minimum.after = now.size(v);
    if (minimum.fate == Fate::removed) minimum.drains_to = now.lowest_neighbour(v);
    minima.push_back(minimum);
  }
  return minima;
}

bool is_before(const EdgeChange& a, const EdgeChange& b) {
  return a.u < b.u || (a.u == b.u && a.v < b.v);
}

/// Every inner edge with the larger order of its two triangles, sorted.
std::vector<EdgeChange> inner_edges(const TriangleMesh& mesh, std::span<const Index> orders,
                                    std::span<const Index> number, bool is_new) {
  std::vector<EdgeChange> edges;
  for (Index i = 0; i < mesh.halfedge_count(); ++i) {
    const HalfEdgeId h(i), twin = mesh.twin(h);
    if (!twin.valid() || twin < h) continue;
    const auto [u, v] = std::minmax(number[mesh.origin(h)], number[mesh.target(h)]);
    const Index order = orders.empty() ? 0
                                       : std::max(orders[TriangleMesh::triangle(h)],
                                                  orders[TriangleMesh::triangle(twin)]);
    edges.push_back({u, v, is_new, order});
  }
  std::sort(edges.begin(), edges.end(), is_before);
  return edges;
}

std::vector<EdgeChange> changed_edges(const TriangleMesh& before, const TriangleMesh& after,
                                      std::span<const Index> orders,
                                      std::span<const Index> number) {
  const std::vector<EdgeChange> old = inner_edges(before, {}, number, false);
  const std::vector<EdgeChange> now = inner_edges(after, orders, number, true);
  std::vector<EdgeChange> changed;
  std::set_symmetric_difference(old.begin(), old.end(), now.begin(), now.end(),
                                std::back_inserter(changed), is_before);
  return changed;
}

}  // namespace

WhatChanged what_changed(const TriangleMesh& before, const TriangleMesh& after,
                         const VertexSet& vertices, const MinimaToKeep& keep,
                         std::span<const Index> orders, std::span<const Index> number) {
  WhatChanged changed;
  const std::size_t count =
      number.empty() ? 0 : std::size_t{*std::max_element(number.begin(), number.end())} + 1;
  if (!vertices.z.empty())
    changed.minima = changed_minima(before, after, vertices, keep, number, count);
  changed.edges = changed_edges(before, after, orders, number);
  return changed;
}

}  // namespace hodt
