// What every order gains, for some objectives.
#include <optional>
#include <string>
#include <vector>

#include "app/comparison.h"
#include "arrays.h"
#include "constraints.h"
#include "job.h"
#include "report.h"
#include "sections.h"
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

namespace hodt::python {

namespace {

nb::dict row_dict(const app::ComparisonRow& row) {
  nb::dict dict;
  dict["k"] = row.k;
  dict["value"] = row.value.result;
  dict["bound"] = row.value.bound;
  dict["optimal"] = row.value.optimal;
  dict["mean_angle"] = or_none(row.mean_angle);
  dict["gap"] = or_none(row.gap());
  dict["change_percent"] = or_none(row.change());
  dict["order"] = row.order;
  dict["smallest_angle"] = row.smallest_angle;
  dict["local_minima"] = or_none(row.local_minima);
  dict["pits"] = pits_dict(row.pits);
  dict["rmse"] = row.fit ? nb::cast(row.fit->rmse) : nb::none();
  dict["max_error"] = row.fit ? nb::cast(row.fit->max_error) : nb::none();
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
  return dict;
}

nb::dict comparison_dict(const app::Comparison& comparison) {
  nb::list objectives;
  for (const app::ObjectiveComparison& objective : comparison.objectives) {
    nb::dict dict;
    nb::list rows;
    for (const app::ComparisonRow& row : objective.rows) rows.append(row_dict(row));
    dict["objective"] = name_of(objective.objective);
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

nb::dict compare(const DoubleArray& array, const std::optional<DoubleArray>& truth,
                 const std::vector<Index>& orders, const std::vector<std::string>& objectives,
                 nb::handle wishes) {
  app::ComparisonOptions options;
  options.orders = orders;
  for (const std::string& name : objectives)
    options.objectives.push_back(objective_from_name(name));
  options.time_limit = nb::cast<double>(wishes["time_limit"]);
  options.min_pit_depth = nb::cast<double>(wishes["min_pit_depth"]);
  options.keep = keep_of(wishes["keep"]);
  const JobOptions job{nb::cast<std::size_t>(wishes["threads"]), nb::borrow(wishes["progress"])};
  return comparison_dict(result_of(job, [&](const Progress& progress) {
    options.progress = progress;
    const PointSet points = InputPoints(array).set();
    std::optional<PointSet> known;
    if (truth) known = InputPoints(*truth).set();
    return app::compare(points, known ? &*known : nullptr, options);
  }));
}

}  // namespace

void add_compare(nb::module_& module) {
  module.def("compare", compare, nb::arg("points"), nb::arg("truth").none(), nb::arg("orders"),
             nb::arg("objectives"), nb::arg("wishes"));
}

}  // namespace hodt::python
