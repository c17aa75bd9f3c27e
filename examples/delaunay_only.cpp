// The Delaunay triangulation alone, in the numbers of the input's rows.
//
//   example_delaunay_only points.csv
#include <cstdio>
#include <exception>
#include <utility>

#include "hodt/delaunay/delaunay.h"
#include "hodt/io/point_file.h"

int main(int argc, char** argv) try {
  if (argc != 2) return 2;
  const hodt::PointSet points = hodt::read_points(argv[1]);
  hodt::Delaunay delaunay = hodt::delaunay(points);
  const hodt::TriangleMesh mesh =
      hodt::in_input_numbering(std::move(delaunay.mesh), delaunay.vertices, points.size());
  const auto [a, b, c] = mesh.corners(hodt::TriangleId(0));
  std::printf("%zu rows, %zu triangles; the corners of the first are rows %u, %u and %u\n",
              points.size(), mesh.triangle_count(), hodt::Index(a), hodt::Index(b), hodt::Index(c));
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
