// A comparison as one HTML page that needs nothing else.
#pragma once

#include <string>
#include <string_view>

#include "app/comparison.h"

namespace hodt::app {

/// Tables, and for each objective a chart of value and bound against the order. `name` says what
/// the points are.
std::string comparison_page(const Comparison& comparison, std::string_view name);

}  // namespace hodt::app
