// The whole job: points or a mesh in, a TIN and a report out.
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "constraints.h"
#include "job.h"
#include "measure.h"
#include "report.h"
#include "sections.h"
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "hodt/base/error.h"
#include "hodt/pipeline.h"
#include "hodt/pipeline/given_tin.h"

namespace hodt::python {

namespace {

/// Everything but the points, by the names of hodt.triangulate().
struct Wishes {
  TriangulateOptions options;
  JobOptions job;
};

TriangulateOptions options_of(nb::handle wishes, const OwnMeasure& own) {
  TriangulateOptions options;
  options.order = nb::cast<Index>(wishes["k"]);
  options.objective = own.objective();
  options.then = own.then();
  options.method = method_from_name(nb::cast<std::string>(wishes["method"]));
  check_method(options.method, options.objective);
  options.time_limit = nb::cast<double>(wishes["time_limit"]);
  options.min_pit_depth = nb::cast<double>(wishes["min_pit_depth"]);
  options.keep = keep_of(wishes["keep"]);
  return options;
}

JobOptions job_of(nb::handle wishes) {
  return {nb::cast<std::size_t>(wishes["threads"]), nb::borrow(wishes["progress"])};
}

nb::tuple arrays_and_report(TriangulateResult result, nb::object constraints, nb::object input) {
  nb::dict report = report_dict(result.report);
  report["constraints"] = std::move(constraints);
  report["input"] = std::move(input);
  return nb::make_tuple(tin_arrays(std::move(result.tin)), report);
}

nb::tuple triangulate_points(const DoubleArray& array, nb::handle wishes,
                             const ConstraintInput& constraints) {
  const OwnMeasure own(wishes["objective"]);
  TriangulateOptions options = options_of(wishes, own);
  JoinReport joined_report;
  TriangulateResult result = result_of(job_of(wishes), [&](const Progress& progress) {
    options.progress = progress;
    const Joined joined = constraints.join(InputPoints(array).set());
    joined_report = joined.report;
    own.prepare(joined.points, options.order);
    return naming_lines(joined,
                        [&] { return triangulate(joined.points, options, joined.constraints); });
  });
  nb::object told = nb::none();
  if (constraints.any()) told = constraints_dict(joined_report, result.report.constraints);
  return arrays_and_report(std::move(result), std::move(told), nb::none());
}

nb::tuple triangulate_tin(const PlaceArray& xy, const std::optional<HeightArray>& z,
                          const IntegerArray& triangles, nb::handle wishes) {
  const OwnMeasure own(wishes["objective"]);
  TriangulateOptions options = options_of(wishes, own);
  std::size_t unused = 0;
  TriangulateResult result = result_of(job_of(wishes), [&](const Progress& progress) {
    options.progress = progress;
    const GivenTin given = given_tin(tin_of(xy, z, triangles));
    unused = given.unused_vertices;
    own.prepare(given.points, options.order);
    return triangulate(given.points, options, given.constraints);
  });
  nb::dict input;
  input["order"] = result.report.given ? nb::cast(result.report.given->order) : nb::none();
  input["is_result"] = result.report.given && result.report.given->is_kept;
  input["unused_vertices"] = unused;
  return arrays_and_report(std::move(result), nb::none(), std::move(input));
}

}  // namespace

void add_triangulate(nb::module_& module) {
  add_constraint_input(module);
  module.def("triangulate_points", triangulate_points, nb::arg("points"), nb::arg("wishes"),
             nb::arg("constraints"));
  module.def("triangulate_tin", triangulate_tin, nb::arg("xy"), nb::arg("z").none(),
             nb::arg("triangles"), nb::arg("wishes"));
  module.def(
      "usual_order", [](const std::string& names) { return usual_order(names); },
      nb::arg("objective"));
}

}  // namespace hodt::python
