// What looks wrong about points that could be read: values that are numbers, but no coordinates.
// Tested by tests/io/point_dialects_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "hodt/geometry/point_set.h"

namespace hodt {

/// Whether x is a whole number that grows by one from point to point, as numbers of points do. At
/// least three points.
bool x_counts(const PointSet& points);

/// Whether x could be the number of each point rather than a coordinate: whole, and either no two
/// are the same or the other coordinate is not whole.
bool x_could_number_points(const PointSet& points);

/// Warnings of heights that usually mean that there is no height, such as -9999: if they are many,
/// or far from all others.
std::vector<std::string> warn_of_no_data(const PointSet& points);

}  // namespace hodt
