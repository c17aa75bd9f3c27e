// The whole job, with most components: built-in points, fewer minima, a file and back.
//
//   terrain mesh.ply
#include "hodt/terrain/terrain.h"

#include <cstdio>

#include "hodt/io/tin_file.h"
#include "hodt/pipeline.h"
#include "hodt/tin/extrema.h"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const hodt::PointSet points = hodt::sample_terrain("jacksboro", 500, 1);
  const auto [tin, report] = hodt::triangulate(points);
  hodt::write_tin(tin, argv[1]);
  const std::size_t before = report.extrema_delaunay->minima.total();
  const hodt::Tin copy = hodt::read_tin(argv[1]);
  const std::size_t after = hodt::count_extrema(copy.points, copy.triangles).minima.total();
  std::printf("local minima: %zu before, %zu after\n", before, after);
  return after < before && after == report.extrema_result->minima.total() ? 0 : 1;
}
