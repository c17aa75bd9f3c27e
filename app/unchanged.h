// Objectives that no order changes: what one triangle decides, and that one cannot go.
// Tested by tests/app/command_test.cpp.
#pragma once

#include <string>

#include "app/comparison.h"

#include "hodt/delaunay/delaunay.h"

namespace hodt::app {

/// Why all rows have the value of the Delaunay triangulation (to 0.00 %), as a sentence; empty if
/// some row has not, no order above 0 was asked for, or the objective is not of a largest or
/// smallest value.
std::string why_unchanged(const ObjectiveComparison& objective, const Delaunay& delaunay);

}  // namespace hodt::app
