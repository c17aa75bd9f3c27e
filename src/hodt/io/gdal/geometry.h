// The parts of a geometry: points, lines and rings.
// Tested by tests/io/gdal_test.cpp.
#pragma once

#include <functional>

#include "hodt/geometry/lines.h"
#include "hodt/io/gdal/api.h"

namespace hodt {

enum class Part { point, line, outer_ring, inner_ring };

/// Calls f(part, kind) with each part that is not empty, in order; rings of a polygon follow its
/// outer one. Throws InputError for what has curves.
void for_each_part(OGRGeometryH geometry, const std::function<void(OGRGeometryH, Part)>& f);

/// The positions of a part, with heights if it has any and they are asked for. Throws InputError
/// for a coordinate that is not finite.
Line positions_of(OGRGeometryH part, bool heights);

/// What messages call it: "Line String".
const char* name_of(Part part);

}  // namespace hodt
