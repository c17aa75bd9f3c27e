// What users are told of points with equal (x, y).
// Tested by tests/app/command_test.cpp.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "app/common.h"

#include "hodt/delaunay/spatial_order.h"

namespace hodt::app {

/// How many of the points at one place had another height, and how far from the one that stays;
/// empty if none had.
std::string difference_text(const std::optional<DuplicateHeights>& heights);

/// "3 duplicates dropped", and that.
std::string dropped_text(std::size_t duplicates, const std::optional<DuplicateHeights>& heights);

/// Null without heights.
Json heights_json(const std::optional<DuplicateHeights>& heights);

}  // namespace hodt::app
