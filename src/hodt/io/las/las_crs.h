// The coordinate system that a LAS file names.
// Tested by tests/io/las_test.cpp.
#pragma once

#include <string>
#include <string_view>

#include "hodt/io/las/las_header.h"
#include "hodt/io/las/las_reader.h"

namespace hodt::las {

/// Of x and y by GeoKeys: "EPSG:25832"; well-known text, or nothing.
std::string crs_of(const LasHeader& header);

/// What GeoKeys say of heights, where the system comes from them.
LasHeights heights_of(const LasHeader& header);

/// The code that EPSG gives the whole of the system in the text: "25832"; empty if none.
std::string epsg_code_in_wkt(std::string_view text);

}  // namespace hodt::las
