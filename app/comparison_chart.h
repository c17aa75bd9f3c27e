// The line chart of an objective: value and bound against the order.
// Tested by tests/app/compare_test.cpp.
#pragma once

#include <string>

#include "app/comparison.h"

namespace hodt::app {

/// An SVG element for a page.
std::string comparison_chart(const ObjectiveComparison& objective);

}  // namespace hodt::app
