#include "hodt/hydrology/pit_depths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "hodt/geometry/heights.h"

namespace hodt {

namespace {

/// The vertices under water so far, as sets of connected ones.
class Basins {
 public:
  explicit Basins(std::size_t n) : parent_(n), bottom_(n), drains_(n, false) {
    std::iota(parent_.begin(), parent_.end(), Index(0));
    std::iota(bottom_.begin(), bottom_.end(), Index(0));
  }
  Index find(Index v) {
    while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
    return v;
  }
  void join(Index a, Index b) { parent_[find(b)] = find(a); }

  Index& bottom(Index set) { return bottom_[set]; }
  void set_drains(Index set) { drains_[set] = true; }
  bool drains(Index set) const { return drains_[set]; }

 private:
  std::vector<Index> parent_, bottom_;
  std::vector<bool> drains_;  // it has flowed over at the boundary, or into one that has
};

}  // namespace

std::vector<Pit> pit_depths(const TriangleMesh& mesh, std::span<const Point> xy,
                            std::span<const double> z) {
  const Heights heights{xy, z};
  const Buffer<HalfEdgeId> outgoing = outgoing_halfedges(mesh);
  std::vector<Index> order(xy.size());
  std::iota(order.begin(), order.end(), Index(0));
  std::sort(order.begin(), order.end(),
            [&](Index a, Index b) { return heights.lower(VertexId(a), VertexId(b)); });
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> level(xy.size(), none);  // where what stands on a bottom flows over
  Basins basins(xy.size());
  std::vector<bool> is_flooded(xy.size(), false);
  for (const Index v : order) {
    if (!outgoing[v].valid()) continue;  // of no triangle
    is_flooded[v] = true;
    bool is_minimum = true;
    for_each_neighbour(mesh, outgoing[v], [&](VertexId w) {
      if (!is_flooded[w]) return;
      is_minimum = false;
      const Index mine = basins.find(v), other = basins.find(w);
      if (mine == other) return;
      // v itself is no bottom: what it has joined so far takes its place.
      const auto flow_over = [&](Index set) {
        if (basins.drains(set)) return;
        level[basins.bottom(set)] = z[v];
      };
      if (basins.bottom(mine) == v) {
        basins.join(other, mine);
        return;
      }
      // The lower one goes on filling, unless one of them drains.
      const bool drains = basins.drains(mine) || basins.drains(other);
      const bool mine_is_lower =
          heights.lower(VertexId(basins.bottom(mine)), VertexId(basins.bottom(other)));
      const Index lower = mine_is_lower ? mine : other, higher = mine_is_lower ? other : mine;
      flow_over(higher);
      if (drains) flow_over(lower);
      basins.join(lower, higher);
      if (drains) basins.set_drains(lower);
    });
    if (is_minimum) level[v] = z[v];
    const Index set = basins.find(v);
    if (mesh.is_boundary(outgoing[v]) && !basins.drains(set)) {
      level[basins.bottom(set)] = z[v];
      basins.set_drains(set);
    }
  }
  std::vector<Pit> pits;
  for (Index v = 0; v < xy.size(); ++v)
    if (!std::isnan(level[v])) pits.push_back({VertexId(v), level[v] - z[v], level[v]});
  return pits;
}

VertexId drains_to(const TriangleMesh& mesh, std::span<const HalfEdgeId> outgoing,
                   std::span<const Point> xy, std::span<const double> z, VertexId from) {
  const Heights heights{xy, z};
  for (VertexId at = from;;) {
    VertexId lowest = at;
    for_each_neighbour(mesh, outgoing[at], [&](VertexId w) {
      if (heights.lower(w, lowest)) lowest = w;
    });
    if (lowest == at) return at;
    at = lowest;
  }
}

}  // namespace hodt
