// What a flip changes.
// Tested by tests/optimize/optimize_measure_test.cpp.
#pragma once

#include "hodt/base/ids.h"

namespace hodt {

/// The corners of the two triangles at an inner edge ab, abc on the left and bad: a flip has dc in
/// its place.
struct Quadrilateral {
  VertexId a, b, c, d;
};

}  // namespace hodt
