// The Delaunay triangulation alone, with what scipy.spatial.Delaunay tells of it.
#include "hodt/delaunay/delaunay.h"

#include "arrays.h"
#include "job.h"
#include "sections.h"

#include "hodt/base/parallel.h"
#include "hodt/base/stopwatch.h"
#include "hodt/tin/interpolate.h"

namespace hodt::python {

namespace {

/// Below so many points there is nothing to wait for.
constexpr std::size_t kFew = 10'000;

nb::object triangles_of(const DoubleArray& array, std::size_t threads) {
  const JobOptions options{threads, nb::none(), array.shape(0) < kFew};
  TriangleMesh mesh = result_of(options, [&](const Progress&) {
    const InputPoints points(array);
    Delaunay d = delaunay(points.view());
    return in_input_numbering(std::move(d.mesh), d.vertices, points.view().size());
  });
  return integers(std::move(mesh.origins()), 3);
}

/// What the call takes in C++, from a PointSet to triangles by rows: for bench/python_vs_others.py.
double seconds_of(const DoubleArray& array) {
  const PointSet points = InputPoints(array).set();
  return result_of({}, [&](const Progress&) {
    Stopwatch watch;
    Delaunay d = delaunay(points);
    const TriangleMesh mesh = in_input_numbering(std::move(d.mesh), d.vertices, points.size());
    return watch.lap();
  });
}

struct Adjacency {
  Buffer<Index> corners;
  Buffer<Index> opposite;       ///< of every corner the triangle beyond the side across, or kNone
  Buffer<Index> vertex_of_row;  ///< the row that stands for each row; another one for duplicates
};

Adjacency adjacency_of(const PointView& points) {
  Delaunay d = delaunay(points);
  const TriangleMesh& mesh = d.mesh;
  Adjacency result;
  result.opposite = Buffer<Index>(mesh.halfedge_count());
  parallel_for(0, mesh.halfedge_count(), 1 << 16, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const HalfEdgeId across = mesh.twin(TriangleMesh::next(HalfEdgeId(Index(i))));
      result.opposite[i] = across.valid() ? Index(TriangleMesh::triangle(across)) : kNone;
    }
  });
  result.vertex_of_row = Buffer<Index>(points.size());
  const Buffer<VertexId> vertices = vertices_of_rows(points, d.vertices);
  for (std::size_t row = 0; row < points.size(); ++row)
    result.vertex_of_row[row] = d.vertices.row[vertices[row]];
  result.corners =
      std::move(in_input_numbering(std::move(d.mesh), d.vertices, points.size()).origins());
  return result;
}

nb::tuple adjacency(const DoubleArray& array, std::size_t threads) {
  const JobOptions options{threads, nb::none(), array.shape(0) < kFew};
  Adjacency result = result_of(options, [&](const Progress&) {
    const InputPoints points(array);
    return adjacency_of(points.view());
  });
  return nb::make_tuple(integers(std::move(result.corners), 3),
                        integers(std::move(result.opposite), 3),
                        integers(std::move(result.vertex_of_row)));
}

}  // namespace

void add_delaunay(nb::module_& module) {
  module.def("delaunay", triangles_of, nb::arg("points"), nb::arg("threads"));
  module.def("seconds_of_delaunay", seconds_of, nb::arg("points"));
  module.def("adjacency", adjacency, nb::arg("points"), nb::arg("threads"));
}

}  // namespace hodt::python
