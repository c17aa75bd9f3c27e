// A sum of angles says nothing to people; their mean does.
// Tested by tests/app/command_test.cpp.
#pragma once

#include <optional>

#include "hodt/pipeline.h"

namespace hodt::app {

/// How many angles the objective adds up: one a triangle, or one an inner edge. Empty if it is no
/// sum of angles, or of none.
std::optional<double> angles_in_sum(const Report& report);

}  // namespace hodt::app
