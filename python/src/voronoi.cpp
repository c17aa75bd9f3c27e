// Order-m Voronoi diagrams: the cells' members and polygons.
#include "hodt/order/voronoi/voronoi.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "arrays.h"
#include "job.h"
#include "sections.h"
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>

#include "hodt/delaunay/delaunay.h"
#include "hodt/order/voronoi/voronoi_polygons.h"

namespace hodt::python {

namespace {

struct Cells {
  std::vector<Index> members;  ///< m a cell: rows, ascending
  std::vector<Point> corners;
  std::vector<std::int64_t> first;  ///< where each cell's corners begin, and the end
};

Cells cells_of(const PointView& points, Index m, const std::optional<Box>& asked) {
  const Delaunay d = delaunay(points);
  const VoronoiDiagram diagram = voronoi_diagram(DelaunayGraph(d), m);
  const Box box = asked ? *asked : enlarged_bounding_box(d.vertices.xy, 0.1);
  const VoronoiPolygons polygons(d.vertices.xy, diagram, box);
  Cells cells;
  cells.members.reserve(diagram.members.size());
  std::vector<Point> polygon;
  for (Index i = 0; i < diagram.cell_count(); ++i) {
    check_stop();
    for (const VertexId v : diagram.members_of(i)) cells.members.push_back(d.vertices.row[v]);
    std::sort(cells.members.end() - std::ptrdiff_t(m), cells.members.end());
    cells.first.push_back(std::int64_t(cells.corners.size()));
    polygons.polygon_of(i, polygon);
    cells.corners.insert(cells.corners.end(), polygon.begin(), polygon.end());
  }
  cells.first.push_back(std::int64_t(cells.corners.size()));
  return cells;
}

nb::tuple voronoi(const DoubleArray& array, Index m, std::optional<std::array<double, 4>> box,
                  std::size_t threads) {
  std::optional<Box> asked;
  if (box) asked = Box{{(*box)[0], (*box)[1]}, {(*box)[2], (*box)[3]}};
  Cells cells = result_of({threads}, [&](const Progress&) {
    const InputPoints points(array);
    return cells_of(points.view(), m, asked);
  });
  const std::size_t count = cells.first.size();
  return nb::make_tuple(integers(std::move(cells.members), m), places(std::move(cells.corners)),
                        owned<std::int64_t>(std::move(cells.first), {count}));
}

}  // namespace

void add_voronoi(nb::module_& module) {
  module.def("voronoi", voronoi, nb::arg("points"), nb::arg("m"), nb::arg("box").none(),
             nb::arg("threads"));
}

}  // namespace hodt::python
