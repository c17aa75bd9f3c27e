// Better triangles on the same vertices: the smallest angles as large as can be, on average.
//
//   example_mesh_user points.csv mesh.obj
#include <cstdio>
#include <exception>

#include "hodt/io/point_file.h"
#include "hodt/io/tin_file.h"
#include "hodt/pipeline.h"

int main(int argc, char** argv) try {
  if (argc != 3) return 2;
  const hodt::PointSet points = hodt::read_points(argv[1]);
  const hodt::Objective objective(hodt::Direction::maximize, hodt::Aggregate::sum,
                                  hodt::TriangleMeasure::small_angle);
  for (const hodt::Index k : {0, 1, 2, 4}) {
    const auto [tin, report] = hodt::triangulate(points, {.order = k, .objective = objective});
    std::printf("k = %u: smallest angle %.3f degrees on average%s\n", k,
                report.value->result / double(report.triangles),
                report.value->optimal ? ", proven best" : "");
    if (k == 4) hodt::write_tin(tin, argv[2]);
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
