// Edges and triangles of a class, with their orders.
#include <string>
#include <vector>

#include "arrays.h"
#include "constraints.h"
#include "job.h"
#include "sections.h"
#include <nanobind/stl/string.h>

#include "hodt/order/edges.h"
#include "hodt/order/triangles.h"

namespace hodt::python {

namespace {

/// produce(graph, numbering) on the (constrained) Delaunay triangulation, whose vertices have the
/// numbers of their rows.
template <class Produce>
auto on_graph(const DoubleArray& array, const ConstraintInput& constraints,
              const JobOptions& options, const Produce& produce) {
  return result_of(options, [&](const Progress&) {
    const Joined joined = constraints.join(InputPoints(array).set());
    const Delaunay d = naming_lines(joined, [&] {
      Delaunay made = delaunay(joined.points);
      constrain(made, joined.points, joined.constraints);
      return made;
    });
    DelaunayGraph graph(d);
    graph.list_neighbours();
    return produce(graph, row_numbering(d.vertices, joined.points.size()));
  });
}

nb::object edges(const DoubleArray& array, Index k, int edge_class,
                 const ConstraintInput& constraints, std::size_t threads) {
  const auto all = [&](const DelaunayGraph& graph, const Numbering& numbering) {
    std::vector<EdgeRecord> records;
    for_each_edge(graph, EdgeClass(edge_class), k, numbering,
                  [&](std::span<const EdgeRecord> piece) {
                    check_stop();
                    records.insert(records.end(), piece.begin(), piece.end());
                  });
    return records;
  };
  return integers(on_graph(array, constraints, {threads}, all), 3);
}

nb::object triangles(const DoubleArray& array, Index k, int triangle_class,
                     const ConstraintInput& constraints, std::size_t threads) {
  const auto all = [&](const DelaunayGraph& graph, const Numbering& numbering) {
    std::vector<TriangleRecord> records;
    for_each_triangle(graph, TriangleClass(triangle_class), k, numbering,
                      [&](std::span<const TriangleRecord> piece) {
                        check_stop();
                        records.insert(records.end(), piece.begin(), piece.end());
                      });
    return records;
  };
  return integers(on_graph(array, constraints, {threads}, all), 4);
}

}  // namespace

void add_lists(nb::module_& module) {
  module.attr("USEFUL") = int(EdgeClass::useful);
  module.attr("KOD") = int(EdgeClass::kod);
  module.attr("FIXED") = int(EdgeClass::fixed);
  module.attr("DELAUNAY") = int(EdgeClass::delaunay);
  module.attr("KOD_TRIANGLES") = int(TriangleClass::kod);
  module.attr("VALID_TRIANGLES") = int(TriangleClass::valid);
  module.def("edges", edges, nb::arg("points"), nb::arg("k"), nb::arg("edge_class"),
             nb::arg("constraints"), nb::arg("threads"));
  module.def("triangles", triangles, nb::arg("points"), nb::arg("k"), nb::arg("triangle_class"),
             nb::arg("constraints"), nb::arg("threads"));
}

}  // namespace hodt::python
