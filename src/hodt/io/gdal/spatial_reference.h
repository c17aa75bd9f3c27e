// The coordinate reference system of what GDAL has opened.
// Tested by tests/io/crs_test.cpp.
#pragma once

#include <string>

#include "hodt/io/gdal/api.h"

namespace hodt {

/// As hodt carries it: a code, else WKT; empty if it is nullptr.
std::string crs_text(OGRSpatialReferenceH reference);

}  // namespace hodt
