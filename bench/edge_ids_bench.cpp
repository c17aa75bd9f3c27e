// The question behind docs/decisions/edge-ids.md: half-edges numbered by triangle (3t + i), which a
// flip renames in part, against half-edges in pairs (twin = h ^ 1) with a `next` array, whose ids
// survive flips. Both take 8 bytes a half-edge.
#include <random>
#include <vector>

#include <benchmark/benchmark.h>

#include "hodt/delaunay/delaunay.h"
#include "hodt/geometry/predicates.h"

namespace {

using namespace hodt;

constexpr std::size_t kPoints = 1000000;

const Delaunay& triangulation() {
  static const Delaunay delaunay = [] {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> unit(0, 1);
    PointSet points;
    for (std::size_t i = 0; i < kPoints; ++i) points.xy.push_back({unit(random), unit(random)});
    return hodt::delaunay(points);
  }();
  return delaunay;
}

/// Half-edges in pairs: 2e and 2e + 1 are the two directions of edge e.
struct PairedMesh {
  std::vector<Index> origin, next;
  std::vector<Index> id;  // of each half-edge of the mesh it was made from

  explicit PairedMesh(const TriangleMesh& mesh) : id(mesh.halfedge_count(), kNone) {
    Index count = 0;
    for (Index i = 0; i < mesh.halfedge_count(); ++i) {
      const HalfEdgeId twin = mesh.twin(HalfEdgeId(i));
      if (twin.valid() && twin < i) continue;
      id[i] = count;
      if (twin.valid()) id[twin] = count + 1;
      count += 2;
    }
    origin.assign(count, kNone);
    next.assign(count, kNone);
    for (Index i = 0; i < mesh.halfedge_count(); ++i) {
      origin[id[i]] = mesh.origin(HalfEdgeId(i));
      next[id[i]] = id[TriangleMesh::next(HalfEdgeId(i))];
    }
  }

  void flip(Index h) {
    const Index g = h ^ 1;
    const Index hn = next[h], hp = next[hn], gn = next[g], gp = next[gn];
    origin[h] = origin[gp];
    origin[g] = origin[hp];
    next[h] = hp, next[hp] = gn, next[gn] = h;
    next[g] = gp, next[gp] = hn, next[hn] = g;
  }
};

/// Convex quadrilaterals that share no triangle: their diagonals flip back and forth at will.
std::vector<HalfEdgeId> flippable_edges() {
  const VertexSet& vertices = triangulation().vertices;
  const TriangleMesh& mesh = triangulation().mesh;
  std::vector<HalfEdgeId> edges;
  std::vector<bool> used(mesh.triangle_count(), false);
  for (Index i = 0; i < mesh.halfedge_count(); ++i) {
    const HalfEdgeId h(i), g = mesh.twin(h);
    if (!g.valid() || used[TriangleMesh::triangle(h)] || used[TriangleMesh::triangle(g)]) continue;
    const Point &a = vertices.xy[mesh.origin(h)], &b = vertices.xy[mesh.target(h)];
    const Point &c = vertices.xy[mesh.apex(h)], &d = vertices.xy[mesh.apex(g)];
    if (orient(d, c, a) <= 0 || orient(d, c, b) >= 0) continue;
    used[TriangleMesh::triangle(h)] = used[TriangleMesh::triangle(g)] = true;
    edges.push_back(h);
  }
  return edges;
}

void flip_by_triangle(benchmark::State& state) {
  TriangleMesh mesh = triangulation().mesh;
  std::vector<HalfEdgeId> edges = flippable_edges();
  for (auto _ : state)
    for (HalfEdgeId& h : edges) h = mesh.flip(h);
  state.SetItemsProcessed(state.iterations() * std::int64_t(edges.size()));
}
BENCHMARK(flip_by_triangle)->Unit(benchmark::kMillisecond);

void flip_in_pairs(benchmark::State& state) {
  PairedMesh mesh(triangulation().mesh);
  std::vector<Index> edges;
  for (const HalfEdgeId h : flippable_edges()) edges.push_back(mesh.id[h]);
  for (auto _ : state)
    for (const Index h : edges) mesh.flip(h);
  state.SetItemsProcessed(state.iterations() * std::int64_t(edges.size()));
}
BENCHMARK(flip_in_pairs)->Unit(benchmark::kMillisecond);

void sum_triangles(benchmark::State& state) {
  const TriangleMesh& mesh = triangulation().mesh;
  for (auto _ : state) {
    std::uint64_t sum = 0;
    for (Index t = 0; t < mesh.triangle_count(); ++t) {
      const auto [a, b, c] = mesh.corners(TriangleId(t));
      sum += a ^ b ^ c;
    }
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(state.iterations() * std::int64_t(mesh.triangle_count()));
}
BENCHMARK(sum_triangles)->Name("triangles_by_triangle")->Unit(benchmark::kMillisecond);

void sum_faces(benchmark::State& state) {
  const PairedMesh mesh(triangulation().mesh);
  for (auto _ : state) {
    std::uint64_t sum = 0;
    for (Index h = 0; h < mesh.next.size(); ++h) {
      const Index n = mesh.next[h];
      if (n == kNone) continue;
      const Index p = mesh.next[n];
      if (h < n && h < p) sum += mesh.origin[h] ^ mesh.origin[n] ^ mesh.origin[p];
    }
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(state.iterations() * std::int64_t(triangulation().mesh.triangle_count()));
}
BENCHMARK(sum_faces)->Name("triangles_in_pairs")->Unit(benchmark::kMillisecond);

void pair_up(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(PairedMesh(triangulation().mesh));
}
BENCHMARK(pair_up)->Unit(benchmark::kMillisecond);

}  // namespace
