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

/// What the member crs of a text says.
struct GeoJsonCrs {
  bool is_there = false;
  bool is_null = false;
  std::string name;  ///< as crs_of_urn() gives it; empty if it is something else than a name
  std::string text;  ///< as it stands there, or its beginning
};

/// Says that there is none if the text is no JSON.
GeoJsonCrs crs_of_geojson(const InputText& text);

}  // namespace hodt
