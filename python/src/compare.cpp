// What every order gains, for some objectives.
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/comparison.h"
#include "arrays.h"
#include "constraints.h"
#include "job.h"
#include "report.h"
#include "sections.h"
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/variant.h>
#include <nanobind/stl/vector.h>

#include "hodt/base/error.h"
#include "hodt/io/point_file.h"
#include "hodt/pipeline/given_tin.h"

namespace hodt::python {

namespace {

/// Of the objectives that are not the first.
nb::list then_list(const app::ObjectiveComparison& objective, std::size_t order) {
  nb::list list;
  for (std::size_t i = 0; i + 1 < objective.objectives.size(); ++i) {
    const app::ComparisonRow row = objective.rows[order].by_later(i);
    nb::dict dict;
    dict["objective"] = name_of(objective.objectives[i + 1]);
    dict["value"] = row.value.result;
    dict["bound"] = row.value.bound;
    dict["optimal"] = row.value.optimal;
    dict["bound_in_order"] = objective.rows[order].then[i].is_bound_in_order;
    dict["gap"] = or_none(row.gap());
    dict["change_percent"] = or_none(row.change());
    list.append(dict);
  }
  return list;
}

/// Of a surface on a raster of truth.
nb::object land_dict(const std::optional<app::LandFit>& land) {
  if (!land) return nb::none();
  nb::dict dict;
  dict["slope_error"] = or_none(land->slope_error);
  dict["fill_volume"] = land->fill.volume;
  dict["fill_depth"] = land->fill.depth;
  dict["stream_agreement"] = or_none(land->stream_agreement);
  return dict;
}

nb::dict row_dict(const app::ObjectiveComparison& objective, std::size_t order) {
  const app::ComparisonRow& row = objective.rows[order];
  nb::dict dict;
  dict["k"] = row.k;
  dict["value"] = row.value.result;
  dict["bound"] = row.value.bound;
  dict["optimal"] = row.value.optimal;
  dict["then"] = then_list(objective, order);
  dict["mean_angle"] = or_none(row.mean_angle);
  dict["gap"] = or_none(row.gap());
  dict["change_percent"] = or_none(row.change());
  dict["order"] = row.order;
  dict["smallest_angle"] = row.smallest_angle;
  dict["local_minima"] = or_none(row.local_minima);
  dict["pits"] = pits_dict(row.pits);
  dict["rmse"] = row.fit ? nb::cast(row.fit->rmse) : nb::none();
  dict["max_error"] = row.fit ? nb::cast(row.fit->max_error) : nb::none();
  dict["land"] = land_dict(row.land);
  dict["seconds"] = row.seconds;
  return dict;
}

nb::object truth_dict(const std::optional<app::TruthSummary>& truth) {
  if (!truth) return nb::none();
  nb::dict dict;
  dict["points"] = truth->points;
  dict["outside"] = truth->outside;
  dict["delaunay_rmse"] = truth->delaunay ? nb::cast(truth->delaunay->rmse) : nb::none();
  dict["delaunay_max_error"] = truth->delaunay ? nb::cast(truth->delaunay->max_error) : nb::none();
  dict["delaunay_land"] = land_dict(truth->delaunay_land);
  dict["land_fill_volume"] = truth->delaunay_land ? nb::cast(truth->land_fill.volume) : nb::none();
  return dict;
}

nb::dict comparison_dict(const app::Comparison& comparison) {
  nb::list objectives;
  for (const app::ObjectiveComparison& objective : comparison.objectives) {
    nb::dict dict;
    nb::list rows;
    for (std::size_t i = 0; i < objective.rows.size(); ++i) rows.append(row_dict(objective, i));
    nb::list then;
    for (std::size_t i = 1; i < objective.objectives.size(); ++i)
      then.append(name_of(objective.objectives[i]));
    dict["objective"] = name_of(objective.objective());
    dict["then"] = then;
    dict["input"] = objective.given.empty() ? nb::none() : nb::cast(objective.given);
    const bool is_unchanged = !objective.why_unchanged.empty();
    dict["unchanged"] = is_unchanged ? nb::cast(objective.why_unchanged) : nb::none();
    dict["rows"] = rows;
    objectives.append(dict);
  }
  nb::dict dict;
  dict["points"] = comparison.points;
  dict["duplicates"] = comparison.duplicates;
  dict["duplicate_heights"] = heights_dict(comparison.duplicate_heights);
  dict["kept"] = or_none(comparison.kept);
  dict["polygons_without_points"] = comparison.empty_polygons;
  dict["delaunay_pits"] = pits_dict(comparison.delaunay_pits);
  dict["truth"] = truth_dict(comparison.truth);
  dict["orders"] = comparison.orders;
  dict["objectives"] = objectives;
  return dict;
}

app::ComparisonOptions options_of(const std::vector<Index>& orders,
                                  const std::vector<std::string>& objectives, nb::handle wishes) {
  app::ComparisonOptions options;
  options.orders = orders;
  for (const std::string& name : objectives)
    options.objectives.push_back(app::compared_objectives(name));
  options.time_limit = nb::cast<double>(wishes["time_limit"]);
  options.min_pit_depth = nb::cast<double>(wishes["min_pit_depth"]);
  options.keep = keep_of(wishes["keep"]);
  return options;
}

JobOptions job_of(nb::handle wishes) {
  return {nb::cast<std::size_t>(wishes["threads"]), nb::borrow(wishes["progress"])};
}

/// Points, or a file.
using Truth = std::variant<std::monostate, DoubleArray, std::filesystem::path>;

app::Comparison compared(const PointSet& points, const Truth& truth,
                         app::ComparisonOptions& options, const Constraints& constraints) {
  std::optional<PointSet> known;
  if (const auto* const array = std::get_if<DoubleArray>(&truth)) known = InputPoints(*array).set();
  if (const auto* const file = std::get_if<std::filesystem::path>(&truth)) {
    PointTable table = read_point_table(*file);
    if (!table.points.has_heights())
      throw InputError(file->string() + ": the truth needs heights, and the points have none");
    known = std::move(table.points);
    options.truth_grid = table.grid;
  }
  return app::compare(points, known ? &*known : nullptr, options, constraints);
}

nb::dict compare_points(const DoubleArray& array, const Truth& truth,
                        const std::vector<Index>& orders,
                        const std::vector<std::string>& objectives,
                        const ConstraintInput& constraints, nb::handle wishes) {
  app::ComparisonOptions options = options_of(orders, objectives, wishes);
  JoinReport joined_report;
  const app::Comparison comparison = result_of(job_of(wishes), [&](const Progress& progress) {
    options.progress = progress;
    const Joined joined = constraints.join(InputPoints(array).set());
    joined_report = joined.report;
    return naming_lines(
        joined, [&] { return compared(joined.points, truth, options, joined.constraints); });
  });
  nb::dict dict = comparison_dict(comparison);
  dict["constraints"] = nb::none();
  if (constraints.any())
    dict["constraints"] = constraints_dict(joined_report, comparison.constraints);
  dict["input"] = nb::none();
  return dict;
}

nb::dict compare_tin(const PlaceArray& xy, const std::optional<HeightArray>& z,
                     const IntegerArray& triangles, const Truth& truth,
                     const std::vector<Index>& orders, const std::vector<std::string>& objectives,
                     nb::handle wishes) {
  app::ComparisonOptions options = options_of(orders, objectives, wishes);
  std::size_t unused = 0;
  const app::Comparison comparison = result_of(job_of(wishes), [&](const Progress& progress) {
    options.progress = progress;
    const GivenTin given = given_tin(tin_of(xy, z, triangles));
    unused = given.unused_vertices;
    return compared(given.points, truth, options, given.constraints);
  });
  nb::dict dict = comparison_dict(comparison), input;
  input["order"] = or_none(comparison.given_order);
  input["unused_vertices"] = unused;
  dict["constraints"] = nb::none();
  dict["input"] = input;
  return dict;
}

}  // namespace

void add_compare(nb::module_& module) {
  module.def("compare_points", compare_points, nb::arg("points"), nb::arg("truth").none(),
             nb::arg("orders"), nb::arg("objectives"), nb::arg("constraints"), nb::arg("wishes"));
  module.def("compare_tin", compare_tin, nb::arg("xy"), nb::arg("z").none(), nb::arg("triangles"),
             nb::arg("truth").none(), nb::arg("orders"), nb::arg("objectives"), nb::arg("wishes"));
}

}  // namespace hodt::python
