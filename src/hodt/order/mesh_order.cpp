#include "hodt/order/mesh_order.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "hodt/base/error.h"
#include "hodt/base/parallel.h"
#include "hodt/mesh/edge_list.h"
#include "hodt/order/circle_counter.h"
#include "hodt/order/constrained/constrained_delaunay.h"

namespace hodt {

namespace {

struct Counts {
  Index order = 0;
  Index order_plain = 0;
  std::vector<std::size_t> histogram;

  void add(Index perturbed, Index plain) {
    order = std::max(order, perturbed);
    order_plain = std::max(order_plain, plain);
    if (histogram.size() <= plain) histogram.resize(plain + 1, 0);
    ++histogram[plain];
  }
};

using Edge = std::array<Index, 2>;

void make_walls(Delaunay& delaunay, const Buffer<VertexId>& vertex_of,
                std::span<const Edge> walls) {
  std::vector<std::array<VertexId, 2>> ends;
  for (const auto& [u, v] : walls) ends.push_back({vertex_of[u], vertex_of[v]});
  if (const std::vector<CrossingEdges> crossings = insert_walls(delaunay, ends);
      !crossings.empty()) {
    const auto [i, j] = crossings.front();
    throw InputError(fmt::format(
        "the edge from vertex {} to {} and that from {} to {} have to be there, but they cross",
        walls[i][0], walls[i][1], walls[j][0], walls[j][1]));
  }
}

/// Walls that the triangles do not have.
std::size_t missing_walls(const Delaunay& delaunay, const Buffer<VertexId>& vertex_of,
                          std::span<const std::array<Index, 3>> triangles) {
  const std::vector<Edge> edges =
      sorted_edges(triangles, [&](Index row) { return Index(vertex_of[row]); });
  std::size_t missing = 0;
  const TriangleMesh& mesh = delaunay.mesh;
  for (Index i = 0; i < mesh.halfedge_count(); ++i)
    if (const HalfEdgeId h(i), twin = mesh.twin(h);
        delaunay.walls[h] && (!twin.valid() || h < twin))
      missing += !has_edge(edges, mesh.origin(h), mesh.target(h));
  return missing;
}

}  // namespace

MeshOrder order_of_mesh(const PointSet& points, std::span<const std::array<Index, 3>> triangles,
                        std::span<const std::array<Index, 2>> walls,
                        std::span<const std::array<Index, 2>> border) {
  Delaunay delaunay = hodt::delaunay({points.xy, {}});
  const Buffer<VertexId> vertex_of = vertices_of_rows(points, delaunay.vertices);
  if (!walls.empty()) {
    Delaunay with_walls = delaunay;
    make_walls(with_walls, vertex_of, walls);
    MeshOrder unknown;
    unknown.missing_walls = missing_walls(with_walls, vertex_of, triangles);
    if (unknown.missing_walls > 0) return unknown;
    if (border.empty()) delaunay = std::move(with_walls);
  }
  if (!border.empty()) {
    std::vector<Edge> all(walls.begin(), walls.end());
    all.insert(all.end(), border.begin(), border.end());
    make_walls(delaunay, vertex_of, all);
  }
  const DelaunayGraph graph(delaunay);

  constexpr std::size_t kPiece = 1024;
  const std::size_t pieces = (triangles.size() + kPiece - 1) / kPiece;
  std::vector<Counts> counts(pieces);
  PerThread<CircleCounter> counters([&] { return CircleCounter(graph); });
  parallel_for(0, pieces, 1, [&](std::size_t first, std::size_t last) {
    CircleCounter& counter = counters.mine();
    for (std::size_t piece = first; piece < last; ++piece) {
      const std::size_t end = std::min(triangles.size(), (piece + 1) * kPiece);
      for (std::size_t t = piece * kPiece; t < end; ++t) {
        const auto [a, b, c] = triangles[t];
        const Circle circle(points.xy[a], points.xy[b], points.xy[c]);
        const Index order = counter.count(vertex_of[a], vertex_of[b], vertex_of[c], kUnlimited);
        const auto inside = [&](VertexId v) { return circle.side_plain(graph.point(v)) > 0; };
        const auto plain = std::count_if(counter.inside().begin(), counter.inside().end(), inside);
        counts[piece].add(order, static_cast<Index>(plain));
      }
    }
  });

  MeshOrder all;
  for (const Counts& c : counts) {
    all.order = std::max(all.order, c.order);
    all.order_plain = std::max(all.order_plain, c.order_plain);
    if (all.histogram.size() < c.histogram.size()) all.histogram.resize(c.histogram.size(), 0);
    for (std::size_t i = 0; i < c.histogram.size(); ++i) all.histogram[i] += c.histogram[i];
  }
  return all;
}

}  // namespace hodt
