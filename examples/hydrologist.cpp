// A TIN that drains: false pits go, deep ones stay, no height changes.
//
//   example_hydrologist points.csv terrain.ply
#include <cstdio>
#include <exception>

#include "hodt/io/point_file.h"
#include "hodt/io/tin_file.h"
#include "hodt/pipeline.h"

int main(int argc, char** argv) try {
  if (argc != 3) return 2;
  const hodt::PointSet points = hodt::read_points(argv[1]);
  const auto [tin, report] =
      hodt::triangulate(points, {.order = 8, .min_pit_depth = 10});  // in the unit of the heights
  std::printf(
      "local minima: %zu before, %zu after, %zu kept, at least %.0f of any TIN of order 8\n",
      report.extrema_delaunay->minima.total(), report.extrema_result->minima.total(), report.kept,
      report.value->bound);
  hodt::write_tin(tin, argv[2]);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
