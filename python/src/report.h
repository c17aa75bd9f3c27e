// Reports as dictionaries, with the names that the command's JSON has.
#pragma once

#include <cstddef>
#include <optional>

#include <nanobind/nanobind.h>
#include <nanobind/stl/vector.h>

#include "hodt/delaunay/spatial_order.h"
#include "hodt/hydrology/pit_water.h"
#include "hodt/pipeline.h"
#include "hodt/pipeline/join_lines.h"
#include "hodt/tin/quality.h"

namespace hodt::python {

namespace nb = nanobind;

/// Of triangulate; the entries `constraints` and `input` are for the caller to add.
nb::dict report_dict(const Report& report);
nb::dict constraints_dict(const JoinReport& joined, const ConstraintReport& report);
nb::object heights_dict(const std::optional<DuplicateHeights>& heights);
nb::object pits_dict(const std::optional<PitTotals>& pits);
nb::dict split_dict(const SplitCount& count);
nb::dict quality_dict(const Quality& quality);

template <class T>
nb::object or_none(const std::optional<T>& value) {
  return value ? nb::cast(*value) : nb::none();
}

}  // namespace hodt::python
