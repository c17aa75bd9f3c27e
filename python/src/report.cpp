#include "report.h"

#include <string>

#include "app/mean_angle.h"
#include <nanobind/stl/array.h>
#include <nanobind/stl/string.h>

namespace hodt::python {

namespace {

template <class... Entries>
nb::dict dict_of(const Entries&... entries) {
  nb::dict dict;
  ((dict[entries.first] = entries.second), ...);
  return dict;
}

template <class T>
std::pair<const char*, nb::object> entry(const char* name, const T& value) {
  return {name, nb::cast(value)};
}

nb::object extrema(const Report& report, SplitCount ExtremaCount::*count) {
  if (!report.extrema_delaunay || !report.extrema_result) return nb::none();
  return dict_of(entry("delaunay", split_dict((*report.extrema_delaunay).*count)),
                 entry("result", split_dict((*report.extrema_result).*count)));
}

nb::dict value_dict(const Value& value) {
  return dict_of(entry("delaunay", value.delaunay), entry("result", value.result),
                 entry("bound", value.bound), entry("optimal", value.optimal));
}

nb::object value_dict(const Report& report) {
  if (!report.value) return nb::none();
  nb::dict dict = value_dict(*report.value);
  if (report.given) dict["input"] = report.given->value;
  return dict;
}

/// Of the objectives that are not the first.
nb::list then_list(const Report& report) {
  nb::list list;
  for (std::size_t i = 0; i < report.then.size(); ++i) {
    const LaterValue& later = report.then[i];
    nb::dict value = value_dict(later.value);
    value["bound_in_order"] = later.is_bound_in_order;
    if (report.given) value["input"] = report.given->then[i];
    list.append(dict_of(entry("objective", name_of(later.objective)), entry("value", value)));
  }
  return list;
}

nb::object mean_dict(const Report& report) {
  const std::optional<double> count = app::angles_in_sum(report);
  if (!report.value || !count) return nb::none();
  return dict_of(entry("delaunay", report.value->delaunay / *count),
                 entry("result", report.value->result / *count),
                 entry("bound", report.value->bound / *count));
}

nb::dict spread_dict(const Spread& spread) {
  return dict_of(entry("min", spread.min), entry("median", spread.median),
                 entry("mean", spread.mean), entry("max", spread.max));
}

}  // namespace

nb::dict report_dict(const Report& report) {
  return dict_of(entry("points", report.points), entry("duplicates", report.duplicates),
                 entry("duplicate_heights", heights_dict(report.duplicate_heights)),
                 entry("triangles", report.triangles), entry("k", report.k),
                 entry("order", report.order), entry("order_histogram", report.order_histogram),
                 entry("objective", name_of(report.objective)), entry("kept", report.kept),
                 entry("polygons_without_points", report.empty_polygons),
                 entry("value", value_dict(report)), entry("then", then_list(report)),
                 entry("mean", mean_dict(report)),
                 entry("local_minima", extrema(report, &ExtremaCount::minima)),
                 entry("local_maxima", extrema(report, &ExtremaCount::maxima)),
                 entry("pits", extrema(report, &ExtremaCount::pits)),
                 entry("seconds", dict_of(entry("delaunay", report.seconds.delaunay),
                                          entry("optimize", report.seconds.optimize))));
}

nb::dict constraints_dict(const JoinReport& joined, const ConstraintReport& report) {
  return dict_of(
      entry("edges", report.edges), entry("edges_kept", report.walls),
      entry("vertices_added", joined.added + joined.crossings),
      entry("vertices_at_points", joined.at_points), entry("vertices_snapped", joined.snapped),
      entry("pieces_snapped_away", joined.collapsed), entry("vertices_from_surface", joined.soft),
      entry("vertices_at_crossings", joined.crossings),
      entry("largest_difference_at_crossings", joined.largest_crossing_difference),
      entry("heights_replaced", joined.heights_replaced),
      entry("largest_replacement", joined.largest_replacement),
      entry("heights_in_conflict", joined.heights_in_conflict),
      entry("largest_conflict", joined.largest_conflict),
      entry("heights_passed", joined.heights_passed),
      entry("largest_passed", joined.largest_passed),
      entry("triangles_outside", report.triangles_outside),
      entry("triangles_too_long", report.triangles_too_long),
      entry("points_left_out", report.unused_points),
      entry("edges_left_out", report.walls_left_out));
}

nb::object heights_dict(const std::optional<DuplicateHeights>& heights) {
  if (!heights) return nb::none();
  return dict_of(entry("different", heights->different),
                 entry("largest_difference", heights->largest_difference));
}

nb::object pits_dict(const std::optional<PitTotals>& pits) {
  if (!pits) return nb::none();
  return dict_of(entry("interior_minima", pits->count), entry("total_depth", pits->depth),
                 entry("largest_depth", pits->deepest), entry("volume", pits->volume));
}

nb::dict split_dict(const SplitCount& count) {
  return dict_of(entry("interior", count.interior), entry("boundary", count.boundary));
}

nb::dict quality_dict(const Quality& quality) {
  return dict_of(entry("smallest_angle", spread_dict(quality.smallest_angle)),
                 entry("largest_angle", spread_dict(quality.largest_angle)),
                 entry("radius_ratio", spread_dict(quality.radius_ratio)),
                 entry("aspect_ratio", spread_dict(quality.aspect_ratio)),
                 entry("smallest_angles_from_0_by_10", quality.smallest_angles),
                 entry("largest_angles_from_60_by_10", quality.largest_angles));
}

}  // namespace hodt::python
