#include "hodt/hydrology/pit_water.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace hodt {

namespace {

double area(const Point& a, const Point& b, const Point& c) {
  return std::fabs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
}

/// The mean over a triangle of the depth, which is linear, counted as 0 where it is negative. The
/// depths at the corners are sorted, the largest first and positive. Sums of products that are not
/// negative: nothing cancels, however thin the wedge.
double mean_depth(double a, double b, double c) {
  if (c >= 0) return (a + b + c) / 3;
  const double along_ac = a / (a - c);  // the share of that side that is under water
  if (b <= 0) return a / 3 * along_ac * (a / (a - b));
  const double along_bc = b / (b - c);
  return ((a + b) * along_bc + a * along_ac * (1 - along_bc)) / 3;
}

/// Of level water over a triangle; 0 if it is dry.
double volume_over(const TriangleMesh& mesh, TriangleId t, std::span<const Point> xy,
                   std::span<const double> z, double level) {
  std::array<VertexId, 3> corner = mesh.corners(t);
  std::sort(corner.begin(), corner.end(), [&](VertexId u, VertexId v) { return z[u] < z[v]; });
  const auto [low, middle, high] = corner;
  if (level <= z[low]) return 0;
  return area(xy[low], xy[middle], xy[high]) *
         mean_depth(level - z[low], level - z[middle], level - z[high]);
}

/// The lake around a pit's bottom: what is lower than its level and connected.
class Lake {
 public:
  Lake(const TriangleMesh& mesh, std::span<const Point> xy, std::span<const double> z)
      : mesh_(mesh),
        outgoing_(outgoing_halfedges(mesh)),
        xy_(xy),
        z_(z),
        of_pit_(z.size(), kNone) {}

  /// The pits one after another, each with a number of its own.
  double volume(const Pit& pit, Index number) {
    if (pit.depth <= 0) return 0;
    vertices_.assign(1, pit.bottom);
    of_pit_[pit.bottom] = number;
    double volume = 0;
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      for_each_neighbour(mesh_, outgoing_[vertices_[i]], [&](VertexId w) {
        if (z_[w] >= pit.level || of_pit_[w] == number) return;
        of_pit_[w] = number;
        vertices_.push_back(w);
      });
      volume += volume_at(vertices_[i], pit.level);
    }
    return volume;
  }

 private:
  /// Over the triangles of which the vertex is the lowest corner; a level one's has the least
  /// number.
  double volume_at(VertexId v, double level) const {
    double volume = 0;
    const auto is_first = [&](VertexId w) { return z_[v] < z_[w] || (z_[v] == z_[w] && v < w); };
    for_each_outgoing(mesh_, outgoing_[v], [&](HalfEdgeId h) {
      if (is_first(mesh_.target(h)) && is_first(mesh_.apex(h)))
        volume += volume_over(mesh_, TriangleMesh::triangle(h), xy_, z_, level);
    });
    return volume;
  }

  const TriangleMesh& mesh_;
  Buffer<HalfEdgeId> outgoing_;
  std::span<const Point> xy_;
  std::span<const double> z_;
  Buffer<Index> of_pit_;  // of which lake a vertex was last
  std::vector<VertexId> vertices_;
};

}  // namespace

std::vector<double> pit_volumes(const TriangleMesh& mesh, std::span<const Point> xy,
                                std::span<const double> z, std::span<const Pit> pits) {
  Lake lake(mesh, xy, z);
  std::vector<double> volumes;
  for (const Pit& pit : pits)
    volumes.push_back(lake.volume(pit, static_cast<Index>(volumes.size())));
  return volumes;
}

Buffer<double> water_levels(const TriangleMesh& mesh, std::span<const double> z) {
  const Buffer<HalfEdgeId> outgoing = outgoing_halfedges(mesh);
  Buffer<double> levels(z.size(), std::numeric_limits<double>::infinity());
  using Shore = std::pair<double, Index>;
  std::priority_queue<Shore, std::vector<Shore>, std::greater<>> shores;
  const auto reach = [&](Index v, double level) {
    if (level >= levels[v]) return;
    levels[v] = level;
    shores.emplace(level, v);
  };
  for (Index v = 0; v < z.size(); ++v)
    if (outgoing[v].valid() && mesh.is_boundary(outgoing[v])) reach(v, z[v]);
  while (!shores.empty()) {
    const auto [level, v] = shores.top();
    shores.pop();
    // What is reached first is reached lowest, so each vertex enters the queue once.
    for_each_neighbour(mesh, outgoing[v],
                       [&, level = level](VertexId w) { reach(w, std::max(level, z[w])); });
  }
  return levels;
}

double water_volume(const TriangleMesh& mesh, std::span<const Point> xy,
                    std::span<const double> z) {
  const Buffer<double> levels = water_levels(mesh, z);
  double volume = 0;
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.corners(TriangleId(t));
    // Water over a triangle stands as high as at its lowest corner.
    const VertexId low = z[b] < z[a] ? (z[c] < z[b] ? c : b) : (z[c] < z[a] ? c : a);
    volume += volume_over(mesh, TriangleId(t), xy, z, levels[low]);
  }
  return volume;
}

PitTotals pit_totals(const TriangleMesh& mesh, std::span<const Point> xy,
                     std::span<const double> z) {
  PitTotals totals;
  const Buffer<HalfEdgeId> outgoing = outgoing_halfedges(mesh);
  for (const Pit& pit : pit_depths(mesh, xy, z)) {
    if (mesh.is_boundary(outgoing[pit.bottom])) continue;
    ++totals.count;
    totals.depth += pit.depth;
    totals.deepest = std::max(totals.deepest, pit.depth);
  }
  totals.volume = water_volume(mesh, xy, z);
  return totals;
}

}  // namespace hodt
