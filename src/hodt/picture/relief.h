// The colours of the ground: a tint by height, shaded by a lamp in the north-west. Internal to this
// layer.
// Tested by tests/picture/picture_test.cpp.
#pragma once

#include "hodt/picture/image.h"

namespace hodt {

/// The tint of a height, given as a share of the range: 0 the lowest, 1 the highest.
Colour tint(double share);

/// The tint as it looks on a slope with the given gradient. Few shades, so that triangles of one
/// colour can share a path.
Colour shaded(double share, double slope_x, double slope_y);

}  // namespace hodt
