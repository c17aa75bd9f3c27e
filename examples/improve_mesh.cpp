// Better triangles in a mesh that is there: the same vertices, its outline and its holes stay.
//
//   example_improve_mesh mesh.obj better.obj
#include <cstdio>
#include <exception>

#include "hodt/io/tin_file.h"
#include "hodt/pipeline.h"
#include "hodt/pipeline/given_tin.h"

int main(int argc, char** argv) try {
  if (argc != 3) return 2;
  const hodt::GivenTin given = hodt::given_tin(hodt::read_tin(argv[1]));
  // More edges that have to stay, such as a crack or the border between two materials, would be
  // pairs of vertices in given.constraints.edges. For points without a mesh, `boundary` of one's own Constraints holds
  // the edges of an outline and of holes.
  const hodt::Objective objective(hodt::Direction::minimize, hodt::Aggregate::max,
                                  hodt::TriangleMeasure::angle);
  const auto [tin, report] =
      hodt::triangulate(given.points, {.order = 4, .objective = objective}, given.constraints);
  std::printf("largest angle: %.3f in the mesh (of order %u), %.3f by Delaunay, %.3f now%s\n",
              report.given->value, report.given->order, report.value->delaunay,
              report.value->result, report.value->optimal ? ", proven best at k = 4" : "");
  hodt::write_tin(tin, argv[2]);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
