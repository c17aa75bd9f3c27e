// What a TIN's triangles tell: whether they are a mesh, their orders, heights between vertices,
// pits.
#include <optional>
#include <string>
#include <vector>

#include "arrays.h"
#include "job.h"
#include "report.h"
#include "sections.h"
#include <fmt/format.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "hodt/base/error.h"
#include "hodt/hydrology/pit_depths.h"
#include "hodt/mesh/glued.h"
#include "hodt/pipeline/examine_mesh.h"
#include "hodt/tin/contours.h"
#include "hodt/tin/counter_clockwise.h"
#include "hodt/tin/embedding.h"
#include "hodt/tin/extrema.h"
#include "hodt/tin/interpolate.h"

namespace hodt::python {

namespace {

/// What is wrong with the mesh; nothing if it is embedded.
std::string problem_of(const PlaceArray& xy, const IntegerArray& triangles) {
  return result_of({}, [&](const Progress&) {
    return check_embedding(rows_of<Point>(xy), rows_of<std::array<Index, 3>>(triangles)).problem;
  });
}

nb::dict check(const PlaceArray& xy, const std::optional<HeightArray>& z,
               const IntegerArray& triangles, const IntegerArray& walls, std::size_t threads) {
  const MeshFindings findings = result_of({threads}, [&](const Progress&) {
    return examine_mesh(tin_of(xy, z, triangles), copy_of(rows_of<std::array<Index, 2>>(walls)));
  });
  const Embedding& embedding = findings.embedding;
  nb::dict dict;
  dict["points"] = xy.shape(0);
  dict["triangles"] = triangles.shape(0);
  dict["embedded"] = embedding.embedded;
  dict["problem"] = embedding.embedded ? nb::none() : nb::cast(embedding.problem);
  dict["covers_hull"] = embedding.covers_hull;
  dict["unused_vertices"] = embedding.unused_vertices;
  dict["clockwise"] = embedding.clockwise;
  dict["components"] = embedding.embedded ? nb::cast(embedding.components) : nb::none();
  dict["boundary_edges"] = embedding.embedded ? nb::cast(embedding.boundary_edges) : nb::none();
  const bool has_order = findings.order && findings.order->missing_walls == 0;
  dict["order"] = has_order ? nb::cast(findings.order->order) : nb::none();
  dict["order_plain"] = has_order ? nb::cast(findings.order->order_plain) : nb::none();
  dict["order_histogram"] = has_order ? nb::cast(findings.order->histogram) : nb::none();
  dict["missing_edges"] = findings.order ? nb::cast(findings.order->missing_walls) : nb::none();
  dict["quality"] = findings.quality ? nb::object(quality_dict(*findings.quality)) : nb::none();
  if (findings.extrema) {
    dict["local_minima"] = split_dict(findings.extrema->minima);
    dict["local_maxima"] = split_dict(findings.extrema->maxima);
    dict["pits"] = split_dict(findings.extrema->pits);
  }
  return dict;
}

nb::object interpolated(const PlaceArray& xy, const HeightArray& z, const IntegerArray& triangles,
                        const PlaceArray& at, std::size_t threads) {
  return doubles(result_of({threads}, [&](const Progress&) {
    return interpolate(tin_of(xy, z, triangles), rows_of<Point>(at));
  }));
}

nb::object located(const PlaceArray& xy, const IntegerArray& triangles, const PlaceArray& at,
                   std::size_t threads) {
  return integers(result_of({threads}, [&](const Progress&) {
    return triangles_at(tin_of(xy, {}, triangles), rows_of<Point>(at));
  }));
}

/// Where several fans of triangles meet in a vertex alone, a walk around it does not pass them all.
void refuse_touching(const TriangleMesh& mesh) {
  Buffer<bool> is_left(mesh.vertex_count(), false);
  for (Index i = 0; i < mesh.halfedge_count(); ++i) {
    const HalfEdgeId h(i);
    if (!mesh.is_boundary(h)) continue;
    if (is_left[mesh.origin(h)])
      throw InputError(fmt::format("pits: the outline of the mesh touches itself at vertex {}",
                                   Index(mesh.origin(h))));
    is_left[mesh.origin(h)] = true;
  }
}

struct Pits {
  std::vector<Index> bottoms;
  std::vector<double> depths;
};

nb::tuple pits(const PlaceArray& xy, const HeightArray& z, const IntegerArray& triangles) {
  Pits found = result_of({}, [&](const Progress&) {
    Tin tin = tin_of(xy, z, triangles);
    make_counter_clockwise(tin);
    const TriangleMesh mesh = glued(tin.points.size(), tin.triangles);
    refuse_touching(mesh);
    Pits result;
    for (const Pit& pit : pit_depths(mesh, tin.points.xy, tin.points.z)) {
      result.bottoms.push_back(pit.bottom);
      result.depths.push_back(pit.depth);
    }
    return result;
  });
  return nb::make_tuple(integers(std::move(found.bottoms)), doubles(std::move(found.depths)));
}

nb::list contour_lines(const PlaceArray& xy, const HeightArray& z, const IntegerArray& triangles,
                       std::optional<std::vector<double>> levels, double interval, double base) {
  std::vector<ContourLine> lines = result_of({}, [&](const Progress&) {
    const Tin tin = tin_of(xy, z, triangles);
    return contours(tin, levels ? *levels : contour_levels(tin, interval, base));
  });
  nb::list list;
  for (ContourLine& line : lines)
    list.append(nb::make_tuple(line.level, places(std::move(line.xy))));
  return list;
}

}  // namespace

void add_mesh(nb::module_& module) {
  module.def("problem_of", problem_of, nb::arg("xy"), nb::arg("triangles"));
  module.def("check", check, nb::arg("xy"), nb::arg("z").none(), nb::arg("triangles"),
             nb::arg("walls"), nb::arg("threads"));
  module.def("interpolate", interpolated, nb::arg("xy"), nb::arg("z"), nb::arg("triangles"),
             nb::arg("at"), nb::arg("threads"));
  module.def("triangles_at", located, nb::arg("xy"), nb::arg("triangles"), nb::arg("at"),
             nb::arg("threads"));
  module.def("contours", contour_lines, nb::arg("xy"), nb::arg("z"), nb::arg("triangles"),
             nb::arg("levels").none(), nb::arg("interval"), nb::arg("base"));
  module.def("pits", pits, nb::arg("xy"), nb::arg("z"), nb::arg("triangles"));
}

}  // namespace hodt::python
