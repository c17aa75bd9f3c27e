// Order-m Voronoi diagrams from the Delaunay triangulation, and their polygons.
#include <random>
#include <vector>

#include <benchmark/benchmark.h>

#include "hodt/order/voronoi/voronoi.h"
#include "hodt/order/voronoi/voronoi_polygons.h"

namespace {

using namespace hodt;

PointSet uniform(std::size_t n) {
  std::mt19937_64 random(1);
  PointSet points;
  for (std::size_t i = 0; i < n; ++i) {
    const auto real = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    const double x = real();
    points.xy.push_back({x, real()});
  }
  return points;
}

PointSet lattice(std::size_t n) {
  PointSet points;
  for (std::size_t i = 0; i < n; ++i)
    points.xy.push_back({static_cast<double>(i % 100), static_cast<double>(i / 100)});
  return points;
}

template <PointSet make(std::size_t)>
void diagram(benchmark::State& state) {
  const Delaunay triangulation = delaunay(make(10000));
  const DelaunayGraph graph(triangulation);
  for (auto _ : state)
    benchmark::DoNotOptimize(voronoi_diagram(graph, static_cast<Index>(state.range(0))));
}

void polygons(benchmark::State& state) {
  const Delaunay triangulation = delaunay(uniform(10000));
  const auto& xy = triangulation.vertices.xy;
  const VoronoiDiagram cells =
      voronoi_diagram(DelaunayGraph(triangulation), static_cast<Index>(state.range(0)));
  const Box box = enlarged_bounding_box(xy, 0.1);
  std::vector<Point> polygon;
  for (auto _ : state) {
    const VoronoiPolygons all(xy, cells, box);
    for (Index cell = 0; cell < cells.cell_count(); ++cell) {
      all.polygon_of(cell, polygon);
      benchmark::DoNotOptimize(polygon.data());
    }
  }
}

BENCHMARK(diagram<uniform>)->Arg(2)->Arg(4)->Arg(8)->Arg(16)->Unit(benchmark::kMillisecond);
BENCHMARK(diagram<lattice>)->Arg(8)->Unit(benchmark::kMillisecond);
BENCHMARK(polygons)->Arg(1)->Arg(8)->Unit(benchmark::kMillisecond);

}  // namespace
