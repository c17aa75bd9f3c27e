// A comparison as one HTML page that needs nothing else.
// Tested by tests/app/compare_test.cpp.
#pragma once

#include <string>

#include "app/comparison.h"

namespace hodt::app {

/// A summary, and for each objective a table and a chart of value and bound against the order;
/// folded if nothing changes. `input` is the file of the points, `constraints` what is to be said
/// of lines.
std::string comparison_page(const Comparison& comparison, const std::string& input,
                            const std::string& constraints);

}  // namespace hodt::app
