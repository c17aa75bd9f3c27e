// Coordinate reference systems as GDAL has them, and as hodt carries them.
// Tested by tests/io/crs_test.cpp.
#pragma once

#include <memory>
#include <string>

#include "hodt/io/gdal/api.h"

namespace hodt {

struct ReleaseReference {
  void operator()(OGRSpatialReferenceH reference) const { gdal().OSRRelease(reference); }
};
using Reference = std::unique_ptr<std::remove_pointer_t<OGRSpatialReferenceH>, ReleaseReference>;

/// Of a text that GDAL understands; nullptr if it does not.
Reference reference_of(const std::string& crs);

/// As hodt carries it: a code, else WKT; empty if it is nullptr.
std::string crs_text(OGRSpatialReferenceH reference);

/// Well-known text in a format of GDAL's ("WKT2_2019"), on one line; empty if there is none.
std::string wkt_of(OGRSpatialReferenceH reference, const char* format);

}  // namespace hodt
