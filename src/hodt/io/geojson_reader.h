// GeoJSON (RFC 7946), as far as it takes to read what lies on a map.
// Tested by tests/io/places_file_test.cpp.
// Tested by tests/io/line_file_test.cpp.
#pragma once

#include <string>

#include "hodt/io/features.h"
#include "hodt/io/input_text.h"

namespace hodt {

/// Hands all points, lines and rings of a GeoJSON text to the taker; returns the coordinate
/// reference system that it names (a member crs, of GeoJSON of 2008), empty if it names none.
/// Throws InputError, naming the
/// place, if the text is none or holds what the taker does not take.
std::string read_geojson(const InputText& text, const FeatureTaker& taker);

}  // namespace hodt
